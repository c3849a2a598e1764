// Reads a file of a training line by line, and reports problems with their lines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

class TrainingLines {
 public:
  /// `text` is that of `file`.
  TrainingLines(FileId file, std::string_view text, const SourceMap& sources,
                Diagnostics& diagnostics)
      : file_(file), left_(text), sources_(sources), diagnostics_(diagnostics) {}

  /// The next line without its end; nothing after the last one, or with a problem if that has none.
  std::optional<std::string_view> next();

  /// Reports a problem of the line that next() returned: E0363. Returns false.
  bool fail(const std::string& what);
  [[nodiscard]] bool has_failed() const { return has_failed_; }

 private:
  FileId file_;
  std::string_view left_;
  const SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::uint32_t number_ = 0;  // of the line, from 1
  bool has_failed_ = false;
};

}  // namespace eagerx::gen
