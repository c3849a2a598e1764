#include <runtime/host/base/utf8.hpp>

namespace eagerx::host {
namespace {

constexpr char32_t kReplacement = 0xfffd;

/// The facts in the first byte: length of the sequence, its payload, and the bounds of the second
/// byte.
struct Lead {
  std::size_t size = 0;  // 0: not a lead byte
  char32_t payload = 0;
  unsigned char low = 0x80;
  unsigned char high = 0xbf;
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte};
  if (byte >= 0xc2 && byte <= 0xdf) return {2, byte & 0x1fU};
  if (byte == 0xe0) return {3, 0, 0xa0, 0xbf};
  if (byte == 0xed) return {3, byte & 0x0fU, 0x80, 0x9f};
  if (byte >= 0xe1 && byte <= 0xef) return {3, byte & 0x0fU};
  if (byte == 0xf0) return {4, 0, 0x90, 0xbf};
  if (byte == 0xf4) return {4, byte & 0x07U, 0x80, 0x8f};
  if (byte >= 0xf1 && byte <= 0xf3) return {4, byte & 0x07U};
  return {};
}

}  // namespace

CodePoint decode_utf8(std::string_view text, std::size_t at) {
  constexpr CodePoint kMalformed = {kReplacement, 1, false};
  const Lead lead = lead_of(static_cast<unsigned char>(text[at]));
  if (lead.size == 0 || at + lead.size > text.size()) return kMalformed;
  char32_t value = lead.payload;
  for (std::size_t i = 1; i < lead.size; ++i) {
    const auto byte = static_cast<unsigned char>(text[at + i]);
    const unsigned char low = i == 1 ? lead.low : 0x80;
    const unsigned char high = i == 1 ? lead.high : 0xbf;
    if (byte < low || byte > high) return kMalformed;
    value = (value << 6U) | (byte & 0x3fU);
  }
  return {value, lead.size, true};
}

}  // namespace eagerx::host
