// Converts bytes into text to parse: loading, limits, UTF-8, line ends.
#pragma once

#include <cstddef>
#include <string>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The result of reading a file.
struct LoadedFile {
  enum class Status : std::uint8_t { loaded, unreadable, too_large };
  Status status = Status::loaded;
  std::string bytes;
  std::string reason;  // why it is unreadable: "no such file or directory"
};

/// Reads at most `max_bytes`; a larger file is not read at all where its size is known beforehand.
LoadedFile load_file(const std::string& path, std::size_t max_bytes);

/// Adds error E0103 and returns false when `text` (normalized) is not UTF-8 or has control
/// characters other than tab and line feed.
bool check_text(const std::string& text, FileId file, Diagnostics& diagnostics);

/// Without byte order mark, and with line ends LF (from CRLF and CR).
std::string normalize_text(std::string text);

}  // namespace eagerx::gen
