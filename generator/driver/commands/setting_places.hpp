// Places of a training's settings in files: the trainer finds settings that do not go together, but
// does not know the files.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

class SettingPlaces {
 public:
  /// `word`: as the trainer gets it, "clip=0.3", or "clip" for any value of a range.
  void add(std::string word, Span span) { places_.emplace_back(std::move(word), span); }

  /// Reports the message of the trainer's `--check` as an error (E0206) at the settings that it
  /// concerns. Returns false, and reports nothing, if none of them is in a file.
  bool report(std::string_view said, bool is_io, Diagnostics& diagnostics) const;

 private:
  [[nodiscard]] const Span* find(std::string_view word) const;

  std::vector<std::pair<std::string, Span>> places_;
};

}  // namespace eagerx::gen
