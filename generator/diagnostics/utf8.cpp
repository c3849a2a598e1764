#include "generator/diagnostics/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace eagerx::gen {
namespace {

constexpr char32_t kReplacement = 0xfffd;

struct Range {
  char32_t first;
  char32_t last;
};

template <std::size_t kCount>
bool contains(const std::array<Range, kCount>& ranges, char32_t code_point) {
  return std::any_of(ranges.begin(), ranges.end(), [code_point](const Range& range) {
    return code_point >= range.first && code_point <= range.last;
  });
}

// The blocks that matter in practice, not the whole of EastAsianWidth.txt.
constexpr std::array<Range, 11> kWide = {{{0x1100, 0x115f},
                                          {0x2e80, 0x303e},
                                          {0x3041, 0xa4cf},
                                          {0xac00, 0xd7a3},
                                          {0xf900, 0xfaff},
                                          {0xfe30, 0xfe6f},
                                          {0xff00, 0xff60},
                                          {0xffe0, 0xffe6},
                                          {0x1f300, 0x1f64f},
                                          {0x1f900, 0x1f9ff},
                                          {0x20000, 0x3fffd}}};

constexpr std::array<Range, 8> kZeroWidth = {{{0x0300, 0x036f},
                                              {0x0483, 0x0489},
                                              {0x0591, 0x05bd},
                                              {0x064b, 0x065f},
                                              {0x1ab0, 0x1aff},
                                              {0x200b, 0x200d},
                                              {0x20d0, 0x20ff},
                                              {0xfe00, 0xfe0f}}};

constexpr std::array<Range, 7> kUnprintable = {{{0x00, 0x1f},
                                                {0x7f, 0x9f},
                                                {0x200e, 0x200f},
                                                {0x2028, 0x202e},
                                                {0x2066, 0x2069},
                                                {0xd800, 0xdfff},
                                                {0xfffe, 0xffff}}};

/// What the first byte says: length of the sequence, its payload, and the bounds of the second
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

std::size_t count_code_points(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); at += decode_utf8(text, at).size) ++count;
  return count;
}

std::size_t display_width(char32_t code_point) {
  if (code_point < 0x300) return 1;
  if (contains(kZeroWidth, code_point)) return 0;
  return contains(kWide, code_point) ? 2 : 1;
}

bool is_unprintable(char32_t code_point) {
  return contains(kUnprintable, code_point);
}

std::string escape_unprintable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = decode_utf8(text, at);
    if (!point.valid) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[at]));
    } else if (point.value == U'\n') {
      result += "\\n";
    } else if (point.value == U'\t') {
      result += "\\t";
    } else if (is_unprintable(point.value)) {
      const auto value = static_cast<std::uint32_t>(point.value);
      result += value < 0x100 ? fmt::format("\\x{:02x}", value) : fmt::format("\\u{:04x}", value);
    } else {
      result += text.substr(at, point.size);
    }
    at += point.size;
  }
  return result;
}

}  // namespace eagerx::gen
