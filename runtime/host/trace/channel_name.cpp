#include <array>
#include <cstdint>
#include <runtime/host/trace/channel_name.hpp>

namespace eagerx::trace_log {
namespace {

/// The first byte of a code point, how many bytes follow it, and the least and the most that the
/// first of these can be: Unicode 15, table 3-7.
struct Form {
  std::uint8_t first, last;
  std::size_t following;
  std::uint8_t least = 0x80, most = 0xbf;
};
constexpr std::array<Form, 9> kForms = {{{0x00, 0x7f, 0},
                                         {0xc2, 0xdf, 1},
                                         {0xe0, 0xe0, 2, 0xa0, 0xbf},
                                         {0xe1, 0xec, 2},
                                         {0xed, 0xed, 2, 0x80, 0x9f},
                                         {0xee, 0xef, 2},
                                         {0xf0, 0xf0, 3, 0x90, 0xbf},
                                         {0xf1, 0xf3, 3},
                                         {0xf4, 0xf4, 3, 0x80, 0x8f}}};

/// Bytes of the code point at the beginning of `text`; 0 if there is none.
std::size_t code_point_bytes(std::string_view text) {
  const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  for (const Form& form : kForms) {
    if (at(0) < form.first || at(0) > form.last) continue;
    if (text.size() <= form.following) return 0;
    if (form.following > 0 && (at(1) < form.least || at(1) > form.most)) return 0;
    for (std::size_t i = 2; i <= form.following; ++i) {
      if (at(i) < 0x80 || at(i) > 0xbf) return 0;
    }
    return form.following + 1;
  }
  return 0;
}

}  // namespace

std::string problem_with_channel_name(std::string_view name) {
  constexpr std::uint8_t kDelete = 0x7f;
  if (name.size() > kMostNameBytes)
    return "a name has at most " + std::to_string(kMostNameBytes) + " bytes";
  for (std::size_t i = 0; i < name.size();) {
    const auto byte = static_cast<std::uint8_t>(name[i]);
    if (byte < ' ' || byte == kDelete) return "a name has no control characters";
    if (byte == ',') return "a name has no comma: no line could begin a message of it";
    const std::size_t bytes = code_point_bytes(name.substr(i));
    if (bytes == 0) return "a name is UTF-8";
    i += bytes;
  }
  return {};
}

}  // namespace eagerx::trace_log
