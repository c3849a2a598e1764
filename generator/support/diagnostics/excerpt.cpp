#include "generator/support/diagnostics/excerpt.hpp"

#include <algorithm>
#include <vector>

#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxWidth = 100;  // of the shown part, in terminal columns
constexpr std::size_t kBefore = 30;     // columns kept in front of the span when the line is cut
constexpr std::string_view kTab = "    ";
constexpr std::string_view kUnknown = "\xef\xbf\xbd";  // U+FFFD
constexpr std::string_view kCut = "\xe2\x80\xa6";      // …

constexpr std::size_t kNear = 300;  // code points on either side of the span that are looked at

/// Start of the code point number `count` from `at` on.
std::size_t advance(std::string_view line, std::size_t at, std::size_t count) {
  for (; count > 0 && at < line.size(); --count) at += decode_utf8(line, at).size;
  return at;
}

/// A code point as it is drawn.
struct Cell {
  std::string_view text;
  std::size_t width;
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  cells.reserve(line.size());
  for (std::size_t at = 0; at < line.size();) {
    const CodePoint point = decode_utf8(line, at);
    if (point.value == U'\t') {
      cells.push_back({kTab, kTab.size()});
    } else if (!point.valid || is_unprintable(point.value)) {
      cells.push_back({kUnknown, 1});
    } else {
      cells.push_back({line.substr(at, point.size), display_width(point.value)});
    }
    at += point.size;
  }
  while (!cells.empty() && (cells.back().text == " " || cells.back().text == kTab)) {
    cells.pop_back();
  }
  return cells;
}

std::size_t width_of(const std::vector<Cell>& cells, std::size_t begin, std::size_t end) {
  std::size_t width = 0;
  for (std::size_t i = begin; i < std::min(end, cells.size()); ++i) width += cells[i].width;
  return width;
}

/// Half-open range of cells.
struct Part {
  std::size_t begin;
  std::size_t end;
};

/// The part of the line to show: all of it, or a stretch around cell `span_begin`.
Part part_around(const std::vector<Cell>& cells, std::size_t span_begin, bool whole_line) {
  if (whole_line && width_of(cells, 0, cells.size()) <= kMaxWidth) return {0, cells.size()};
  std::size_t begin = span_begin;
  std::size_t before = 0;
  while (begin > 0 && before + cells[begin - 1].width <= kBefore) before += cells[--begin].width;
  std::size_t end = begin;
  std::size_t width = 0;
  while (end < cells.size() && width + cells[end].width <= kMaxWidth) width += cells[end++].width;
  // Near the end of the line there is room for more of what comes before.
  while (begin > 0 && width + cells[begin - 1].width <= kMaxWidth) width += cells[--begin].width;
  return {begin, end};
}

}  // namespace

Excerpt make_excerpt(std::string_view line, std::uint32_t column, std::uint32_t length) {
  const std::size_t first =
      std::min<std::size_t>(column > 0 ? column - 1 : 0, count_code_points(line));
  // Lines can have megabytes: only the neighbourhood is drawn.
  const std::size_t skipped = first > kNear ? first - kNear : 0;
  const std::size_t begin = advance(line, 0, skipped);
  const std::size_t end = advance(line, begin, first - skipped + kNear);
  const std::vector<Cell> cells = cells_of(line.substr(begin, end - begin));
  const bool cut_before = begin > 0;
  const bool cut_after = end < line.size();
  const std::size_t span_begin = std::min<std::size_t>(first - skipped, cells.size());
  const std::size_t span_end = span_begin + std::max<std::size_t>(length, 1);
  const Part part = part_around(cells, span_begin, !cut_before && !cut_after);

  Excerpt excerpt;
  const bool dots_before = cut_before || part.begin > 0;
  if (dots_before) excerpt.text += kCut;
  for (std::size_t i = part.begin; i < part.end; ++i) excerpt.text += cells[i].text;
  if (cut_after || part.end < cells.size()) excerpt.text += kCut;
  excerpt.caret_column = (dots_before ? 1 : 0) + width_of(cells, part.begin, span_begin);
  excerpt.caret_width =
      std::max<std::size_t>(width_of(cells, span_begin, std::min(span_end, part.end)), 1);
  return excerpt;
}

}  // namespace eagerx::gen
