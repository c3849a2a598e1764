#include "generator/frontend/read/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "generator/support/diagnostics/utf8.hpp"
#include "generator/support/files/files.hpp"
#include "generator/support/files/unsaved.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string in_words(std::error_code error) {
  std::string words = error.message();
  const bool capital = !words.empty() && words[0] >= 'A' && words[0] <= 'Z';
  if (capital) words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return words;
}

LoadedFile unreadable(std::string reason) {
  return {LoadedFile::Status::unreadable, {}, std::move(reason)};
}

/// YAML 1.2, section 5.1 (c-printable), without the characters no keyboard writes.
bool is_text(char32_t c) {
  if (c == U'\t' || c == U'\n' || c == 0x85) return true;
  return c >= 0x20 && c != 0x7f && !(c >= 0x80 && c < 0xa0) && c != 0xfffe && c != 0xffff;
}

bool is_utf16(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
}

}  // namespace

LoadedFile load_file(const std::string& path, std::size_t max_bytes) {
  if (auto text = unsaved_text(path)) {
    const bool fits = text->size() <= max_bytes;
    return fits ? LoadedFile{LoadedFile::Status::loaded, std::move(*text), {}}
                : LoadedFile{LoadedFile::Status::too_large, {}, {}};
  }
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    return unreadable(
        in_words(error ? error : std::make_error_code(std::errc::no_such_file_or_directory)));
  }
  if (std::filesystem::is_directory(status)) return unreadable("it is a directory");
  if (std::filesystem::is_regular_file(status)) {
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > max_bytes) return {LoadedFile::Status::too_large, {}, {}};
  }
  // A pipe in a folder would be waited for without end, and a device may have none. What a shell
  // passes on as `<(…)` is meant.
  const bool passed_on =
      path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/") || path == "/dev/stdin";
  if (!std::filesystem::is_regular_file(status) && !passed_on)
    return unreadable("it is not a file");
  if (!passed_on) remember_input(path);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return unreadable(in_words({errno, std::generic_category()}));

  // The size is only a promise (pipes have none): count what comes.
  LoadedFile file;
  constexpr std::size_t kChunk = 1U << 16U;
  std::array<char, kChunk> chunk{};
  while (stream.read(chunk.data(), chunk.size()) || stream.gcount() > 0) {
    file.bytes.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    if (file.bytes.size() > max_bytes) return {LoadedFile::Status::too_large, {}, {}};
  }
  if (stream.bad()) return unreadable(in_words({errno, std::generic_category()}));
  return file;
}

bool check_text(const std::string& text, FileId file, Diagnostics& diagnostics) {
  Span span = {file, 1, 1, 1};
  if (is_utf16(text)) {
    diagnostics.error("E0103", {file, 0, 0, 0}, "the file is not UTF-8 text but UTF-16").help =
        "save it as UTF-8";
    return false;
  }
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = decode_utf8(text, at);
    if (!point.valid) {
      diagnostics
          .error("E0103", span,
                 fmt::format("the file is not UTF-8 text: byte 0x{:02x} in line {}",
                             static_cast<unsigned char>(text[at]), span.line))
          .help = "save it as UTF-8";
      return false;
    }
    if (!is_text(point.value)) {
      const auto value = static_cast<std::uint32_t>(point.value);
      diagnostics.error(
          "E0103", span,
          fmt::format("the file is not plain text: control character U+{:04X} in line {}", value,
                      span.line));
      return false;
    }
    at += point.size;
    if (point.value == U'\n') {
      ++span.line;
      span.column = 1;
    } else {
      ++span.column;
    }
  }
  return true;
}

std::string normalize_text(std::string text) {
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  if (text.find('\r') == std::string::npos) return text;
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '\r') {
      result += text[at];
    } else if (at + 1 == text.size() || text[at + 1] != '\n') {
      result += '\n';
    }
  }
  return result;
}

}  // namespace eagerx::gen
