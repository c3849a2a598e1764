// The fixes of diagnostics as splices of a text.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "generator/frontend/outline/splice.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

struct TextFix {
  Edit edit;
  bool is_certain = false;  // else one of several, or with a place where something is to be written
};

/// The fixes of a diagnostic that are changes of this text of its file, the likeliest first.
std::vector<TextFix> fixes_of(const Diagnostic& diagnostic, std::string_view text);

/// The certain one, if there is one.
std::optional<Edit> fix_of(const Diagnostic& diagnostic, std::string_view text);

/// Gives every fix its edits in the texts of `sources`: spans and replacements. Drops fixes without
/// edits.
void place_fixes(Diagnostics& diagnostics, const SourceMap& sources);

}  // namespace eagerx::gen
