#include "generator/edit/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "generator/outline/lines.hpp"

namespace eagerx::gen {

std::string applied(std::string_view text, std::vector<Splice> splices) {
  std::vector<Splice> chosen;
  for (Splice& splice : splices) {
    const bool overlaps = std::ranges::any_of(chosen, [&](const Splice& other) {
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

std::optional<Edit> fix_of(const Diagnostic& diagnostic, std::string_view text) {
  constexpr std::string_view kBegin = "did you mean `";
  const std::size_t found = diagnostic.help.find(kBegin);
  if (found == std::string::npos || diagnostic.span.length == 0) return std::nullopt;
  const std::size_t begin = found + kBegin.size();
  const std::size_t end = diagnostic.help.find('`', begin);
  if (end == std::string::npos) return std::nullopt;
  std::string word = diagnostic.help.substr(begin, end - begin);
  std::string reason = fmt::format("Change to `{}`", word);
  return Edit{std::move(reason), {{bytes_of(text, diagnostic.span), std::move(word)}}};
}

}  // namespace eagerx::gen
