// What the helps of diagnostics say, as changes of the text.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "generator/tools/edit/edit.hpp"

namespace eagerx::gen {

struct Help {
  Edit edit;
  bool is_certain = false;  // else one of several, or with a place where something is to be written
};

/// The changes that the help of a diagnostic names, the likeliest first; none where it is no change
/// of this text.
std::vector<Help> helps_of(const Diagnostic& diagnostic, std::string_view text);

/// The certain one, if there is one.
std::optional<Edit> fix_of(const Diagnostic& diagnostic, std::string_view text);

}  // namespace eagerx::gen
