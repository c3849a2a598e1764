#include "generator/backend/compile/messages.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

namespace eagerx::gen {
namespace {

/// The number before the next colon, which is taken off, too.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + colon, number);
  if (error != std::errc() || end != text.data() + colon) return std::nullopt;
  text.remove_prefix(colon + 1);
  return number;
}

std::optional<CompilerMessage> message_in(std::string_view line) {
  CompilerMessage message;
  for (const std::string_view kind : {": fatal error: ", ": error: ", ": warning: "}) {
    const std::size_t at = line.find(kind);
    if (at == std::string_view::npos) continue;
    message.error = kind != ": warning: ";
    message.text = line.substr(at + kind.size());
    // The file may have colons, its line and column have none.
    const std::string_view place = line.substr(0, at);
    const std::size_t column = place.rfind(':');
    if (column == std::string_view::npos || column == 0) return std::nullopt;
    const std::size_t row = place.rfind(':', column - 1);
    if (row == std::string_view::npos) return std::nullopt;
    message.file = place.substr(0, row);
    std::string numbers(place.substr(row + 1));
    numbers += ":";
    std::string_view rest = numbers;
    const auto first = take_number(rest);
    const auto second = take_number(rest);
    if (!first || !second) return std::nullopt;
    message.line = *first;
    message.column = *second;
    return message;
  }
  return std::nullopt;
}

}  // namespace

std::vector<CompilerMessage> messages_in(std::string_view output) {
  std::vector<CompilerMessage> messages;
  while (!output.empty()) {
    const std::string_view line = output.substr(0, output.find('\n'));
    output.remove_prefix(std::min(line.size() + 1, output.size()));
    if (auto message = message_in(line)) messages.push_back(std::move(*message));
  }
  return messages;
}

}  // namespace eagerx::gen
