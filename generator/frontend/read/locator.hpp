// Converts the byte offsets of yaml-cpp's marks into spans of a YAML text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Half-open range of bytes.
struct Extent {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The tag and anchor in front of a value, and where the value itself begins.
struct Properties {
  Extent all;
  Extent tag;  // empty: no tag
  std::size_t content = 0;
};

/// Turns offsets into spans. `text` must be UTF-8 with LF line ends and outlive the locator.
class Locator {
 public:
  Locator(FileId file, std::string_view text);

  [[nodiscard]] std::string_view text() const { return text_; }
  /// The part of the extent on its first line; at least one code point long.
  [[nodiscard]] Span span(Extent extent) const;
  /// The whole file.
  [[nodiscard]] Span whole() const { return {file_, 0, 0, 0}; }

  /// Reads `!tag` and `&anchor` from `offset` on.
  [[nodiscard]] Properties properties(std::size_t offset) const;
  /// From where the scalar with this value begins to where it ends; one that is not quoted and has
  /// several lines: to the end of the first. An empty one is where its tag is.
  [[nodiscard]] Extent scalar(const Properties& properties, std::string_view value) const;
  /// From `begin` to the next blank, line end or flow indicator.
  [[nodiscard]] Extent word(std::size_t begin) const;
  /// The first offset from `offset` on that is not a blank, line end or comment.
  [[nodiscard]] std::size_t skip_blank(std::size_t offset) const;
  /// The `-` of the empty list item in front of `offset`; npos if there is none.
  [[nodiscard]] std::size_t dash_before(std::size_t offset) const;
  /// Just past the closing mark of the quoted scalar at `begin`; npos if it is never closed.
  [[nodiscard]] std::size_t quoted_end(std::size_t begin) const;
  [[nodiscard]] std::size_t line_begin(std::size_t offset) const;
  [[nodiscard]] std::size_t line_end(std::size_t offset) const;
  /// The plain null (`~`, `null`) written at `offset`; empty if there is none.
  [[nodiscard]] Extent null_at(std::size_t offset) const;
  /// Whether a `:` follows on the same line.
  [[nodiscard]] bool colon_follows(std::size_t offset) const;

 private:
  [[nodiscard]] char at(std::size_t offset) const {
    return offset < text_.size() ? text_[offset] : '\0';
  }
  [[nodiscard]] bool text_at_same_line(const Properties& properties) const;
  /// Code points in front of `offset`, in constant time however long the lines are.
  [[nodiscard]] std::size_t code_points_before(std::size_t offset) const;
  [[nodiscard]] std::size_t tag_end(std::size_t begin) const;

  FileId file_;
  std::string_view text_;
  std::vector<std::size_t> line_starts_;
  std::vector<std::size_t> counts_;  // code points in front of every kStride-th byte
};

}  // namespace eagerx::gen
