#include "generator/backend/compile/messages.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

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

/// Takes "FILE:LINE:COLUMN", where the file may have colons.
bool read_place(std::string_view place, std::string& file, std::uint32_t& line,
                std::uint32_t& column) {
  const std::size_t second = place.rfind(':');
  if (second == std::string_view::npos || second == 0) return false;
  const std::size_t first = place.rfind(':', second - 1);
  if (first == std::string_view::npos) return false;
  file = place.substr(0, first);
  const std::string numbers = std::string(place.substr(first + 1)) + ":";
  std::string_view rest = numbers;
  const auto row = take_number(rest);
  const auto at = take_number(rest);
  if (!row || !at) return false;
  line = *row;
  column = *at;
  return true;
}

/// "    inlined from 'void mine::Gain<Io>::callback(…)' at gain.hpp:14:16:"
std::optional<CompilerMessage::Place> inlined_at(std::string_view line) {
  constexpr std::string_view kBegin = "    inlined from ", kPlace = "' at ";
  const std::size_t at = line.rfind(kPlace);
  if (!line.starts_with(kBegin) || at == std::string_view::npos) return std::nullopt;
  line.remove_prefix(at + kPlace.size());
  while (line.ends_with(':') || line.ends_with(',')) line.remove_suffix(1);
  CompilerMessage::Place place;
  if (!read_place(line, place.file, place.line, place.column)) return std::nullopt;
  return place;
}

std::optional<CompilerMessage> message_in(std::string_view line) {
  CompilerMessage message;
  for (const std::string_view kind : {": fatal error: ", ": error: ", ": warning: "}) {
    const std::size_t at = line.find(kind);
    if (at == std::string_view::npos) continue;
    message.error = kind != ": warning: ";
    message.text = line.substr(at + kind.size());
    if (!read_place(line.substr(0, at), message.file, message.line, message.column))
      return std::nullopt;
    return message;
  }
  return std::nullopt;
}

}  // namespace

std::vector<CompilerMessage> messages_in(std::string_view output) {
  std::vector<CompilerMessage> messages;
  std::vector<CompilerMessage::Place> places;  // said before the message
  while (!output.empty()) {
    const std::string_view line = output.substr(0, output.find('\n'));
    output.remove_prefix(std::min(line.size() + 1, output.size()));
    if (auto place = inlined_at(line)) {
      places.push_back(std::move(*place));
    } else if (auto message = message_in(line)) {
      message->inlined_at = std::exchange(places, {});
      messages.push_back(std::move(*message));
    } else if (!line.starts_with(' ')) {
      places.clear();  // "In function …" begins another one
    }
  }
  return messages;
}

std::vector<CompilerMessage> instantiations_in(std::string_view output) {
  std::vector<CompilerMessage> places;
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    const std::string_view line = output.substr(0, end);
    output.remove_prefix(std::min(end + 1, output.size()));
    const std::size_t at =
        std::min(line.find(":   required from "), line.find(": note: in instantiation"));
    CompilerMessage place;
    if (at != std::string_view::npos &&
        read_place(line.substr(0, at), place.file, place.line, place.column))
      places.push_back(std::move(place));
  }
  return places;
}

}  // namespace eagerx::gen
