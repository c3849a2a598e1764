// Names of entities in other tools.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

/// Names among `known` that `word` may mean, ignoring case: by their names in other tools (`lqr` is
/// StateFeedback), or because they contain it (`pid`). Empty if there are none or too many.
std::vector<std::string> other_names(std::string_view word, const std::vector<std::string>& known);

/// "did you mean `PidController`?" with them; empty if there are none.
std::string meant_by_other_name(std::string_view word, const std::vector<std::string>& known);

}  // namespace eagerx::gen
