#include "generator/frontend/outline/splice.hpp"

#include <algorithm>
#include <utility>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

std::string applied(std::string_view text, std::vector<Splice> splices) {
  std::vector<Splice> chosen;
  for (Splice& splice : splices) {
    const bool overlaps = ranges::any_of(chosen, [&](const Splice& other) {
      return splice.place.begin < other.place.end && other.place.begin < splice.place.end;
    });
    if (!overlaps && splice.place.end <= text.size()) chosen.push_back(std::move(splice));
  }
  // From the end, so that places stay what they are.
  std::ranges::sort(chosen, std::ranges::greater{},
                    [](const Splice& splice) { return splice.place.begin; });
  std::string result(text);
  for (const Splice& splice : chosen)
    result.replace(splice.place.begin, splice.place.end - splice.place.begin, splice.text);
  return result;
}

}  // namespace eagerx::gen
