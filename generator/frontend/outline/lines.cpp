#include "generator/frontend/outline/lines.hpp"

#include <algorithm>

#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {

Bytes line_of(std::string_view text, std::uint32_t line) {
  std::size_t begin = 0;
  for (; line > 0; --line) {
    const std::size_t newline = text.find('\n', begin);
    if (newline == std::string_view::npos) return {text.size(), text.size()};
    begin = newline + 1;
  }
  return {begin, std::min(text.find('\n', begin), text.size())};
}

Bytes bytes_of(std::string_view text, const Span& span) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // columns count behind it
  Bytes whole = line_of(text, std::max(span.line, 1U) - 1);
  if (span.line <= 1 && text.starts_with(kByteOrderMark)) whole.begin = kByteOrderMark.size();
  if (span.line == 0) return whole;
  const auto skip = [&](std::size_t from, std::uint32_t count) {
    for (; count > 0 && from < whole.end; --count) from += decode_utf8(text, from).size;
    return from;
  };
  const std::size_t begin = skip(whole.begin, std::max(span.column, 1U) - 1);
  return {begin, skip(begin, span.length)};
}

}  // namespace eagerx::gen
