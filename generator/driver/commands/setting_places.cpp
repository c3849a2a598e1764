#include "generator/driver/commands/setting_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// The text between `begin` and `end`, both of which are taken off `text`; empty if it does not
/// begin so.
std::string_view take(std::string_view& text, std::string_view begin, std::string_view end) {
  if (!text.starts_with(begin)) return {};
  text.remove_prefix(begin.size());
  const std::size_t length = std::min(text.find(end), text.size());
  const std::string_view taken = text.substr(0, length);
  text.remove_prefix(std::min(length + end.size(), text.size()));
  return taken;
}

std::string_view setting_name(std::string_view word) {
  return word.substr(0, word.find('='));
}

}  // namespace

const Span* SettingPlaces::find(std::string_view word) const {
  for (const std::string_view wanted : {word, setting_name(word)}) {
    const auto found = ranges::find(
        places_, wanted, [](const auto& place) { return std::string_view(place.first); });
    if (found != places_.end()) return &found->second;
  }
  return nullptr;
}

bool SettingPlaces::report(std::string_view said, bool is_io, Diagnostics& diagnostics) const {
  std::vector<std::pair<std::string_view, Span>> found;
  std::string_view words = take(said, "settings: ", "\n");
  while (!words.empty()) {
    const std::string_view word = take(words, "", " ");
    if (const Span* place = find(word)) found.emplace_back(word, *place);
  }
  if (found.empty()) return false;
  const std::string message(take(said, "error: ", "\nhelp: "));
  auto& problem = is_io ? diagnostics.io_error("E0206", found.front().second, message)
                        : diagnostics.error("E0206", found.front().second, message);
  problem.help = std::string(said.substr(0, said.find_last_not_of('\n') + 1));
  for (const auto& [word, place] : std::span(found).subspan(1))
    problem.notes.push_back({fmt::format("`{}` stands here", setting_name(word)), place, ""});
  return true;
}

}  // namespace eagerx::gen
