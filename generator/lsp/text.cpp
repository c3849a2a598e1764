#include "generator/lsp/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

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

std::string path_of_uri(std::string_view uri) {
  constexpr std::string_view kScheme = "file://";
  if (!uri.starts_with(kScheme)) return {};
  uri.remove_prefix(kScheme.size());
  uri.remove_prefix(std::min(uri.find('/'), uri.size()));  // a host
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* const end = uri.data() + std::min(i + 3, uri.size());
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(uri.data() + i + 1, end, byte, 16).ptr == end) {
      path += static_cast<char>(byte);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

std::string uri_of_path(std::string_view path) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string uri = "file://";
  for (const char c : path) {
    if (kPlain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

}  // namespace eagerx::gen::lsp
