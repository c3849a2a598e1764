// Names of entities in other tools.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// Those of `known` that `word` may mean, whatever its case: by what others call them (`lqr` is
/// StateFeedback), or because they have it in their names (`pid`). Empty if there are none, or
/// many.
std::vector<std::string> other_names(std::string_view word, const std::vector<std::string>& known);

/// "did you mean `PidController`?" with them; empty if there are none.
std::string meant_by_other_name(std::string_view word, const std::vector<std::string>& known);

}  // namespace eagerx::gen
