// A place in one of the files that were read.
#pragma once

#include <cstdint>

namespace eagerx::gen {

/// Index of a file in a SourceMap.
enum class FileId : std::uint32_t { none = 0xffffffffU };

/// A place in a file. Lines and columns count from 1, columns in code points; line 0 means the
/// whole file.
struct Span {
  FileId file = FileId::none;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::uint32_t length = 0;  // code points on that line
};

}  // namespace eagerx::gen
