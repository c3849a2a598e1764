#include "generator/lsp/text.hpp"

#include <algorithm>

#include "generator/diagnostics/utf8.hpp"
#include "generator/outline/lines.hpp"

namespace eagerx::gen::lsp {
namespace {

/// 2 for what UTF-16 writes as two surrogates.
std::uint32_t units_of(char32_t code_point) {
  constexpr char32_t kOneUnit = 0x10000;
  return code_point >= kOneUnit ? 2 : 1;
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
  Position position;
  position.line = static_cast<std::uint32_t>(std::ranges::count(before, '\n'));
  for (std::size_t at = begin; at < byte;) {
    const CodePoint next = decode_utf8(text, at);
    position.character += units_of(next.value);
    at += next.size;
  }
  return position;
}

}  // namespace eagerx::gen::lsp
