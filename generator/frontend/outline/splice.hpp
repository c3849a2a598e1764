// Changes of a text that leave the rest as it was written.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/outline.hpp"

namespace eagerx::gen {

/// `text` takes the place of some bytes.
struct Splice {
  Bytes place;
  std::string text;
};

struct Edit {
  std::string reason;  // as a button would say it: "Change to `theta`"
  std::vector<Splice> splices;
};

/// The text with all splices that do not overlap an earlier one of the list.
std::string applied(std::string_view text, std::vector<Splice> splices);

}  // namespace eagerx::gen
