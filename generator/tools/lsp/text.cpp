#include "generator/tools/lsp/text.hpp"

#include <algorithm>
#include <iterator>

#include "generator/frontend/outline/lines.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen::lsp {
namespace {

/// 2 for what UTF-16 writes as two surrogates.
std::uint32_t units_of(char32_t code_point) {
  constexpr char32_t kOneUnit = 0x10000;
  return code_point >= kOneUnit ? 2 : 1;
}

std::uint32_t units_between(std::string_view text, std::size_t begin, std::size_t end) {
  std::uint32_t units = 0;
  while (begin < end) {
    const CodePoint next = decode_utf8(text, begin);
    units += units_of(next.value);
    begin += next.size;
  }
  return units;
}

}  // namespace

std::size_t byte_at(std::string_view text, Position position) {
  const Bytes line = line_of(text, position.line);
  std::size_t at = line.begin;
  for (std::uint32_t units = 0; at < line.end && units < position.character;) {
    const CodePoint next = decode_utf8(text, at);
    units += units_of(next.value);
    at += next.size;
  }
  return at;
}

Position position_at(std::string_view text, std::size_t byte) {
  byte = std::min(byte, text.size());
  const std::string_view before = text.substr(0, byte);
  const std::size_t newline = before.rfind('\n');
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  return {static_cast<std::uint32_t>(std::ranges::count(before, '\n')),
          units_between(text, begin, byte)};
}

Lines::Lines(std::string_view text) : text_(text) {
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    starts_.push_back(at + 1);
}

Position Lines::position(std::size_t byte) const {
  byte = std::min(byte, text_.size());
  const auto line = std::prev(std::ranges::upper_bound(starts_, byte));
  return {static_cast<std::uint32_t>(line - starts_.begin()), units_between(text_, *line, byte)};
}

}  // namespace eagerx::gen::lsp
