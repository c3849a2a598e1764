// Words of other libraries and languages, and their equivalents here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// The equivalent in `known` of a `word` of other libraries: `normal` for `gaussian`, `terminated`
/// for `done`. Empty if there is none.
std::string foreign_word(std::string_view word, const std::vector<std::string>& known);

/// "true" for `yes`, `on`, `True`, `1`; "false" for their opposites; else empty.
std::string_view foreign_truth(std::string_view word);

}  // namespace eagerx::gen
