#include "generator/backend/emit/lists.hpp"

#include <algorithm>
#include <optional>

#include "generator/backend/emit/line_passes.hpp"
#include "generator/backend/emit/scanner.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

// How clang-format chooses the columns: CommaSeparatedList in its FormatToken.cpp.

/// A way of clang-format to write a list in columns.
struct Columns {
  std::vector<std::size_t> widths;  // with the commas
  std::size_t lines = 1;
  std::size_t width = 0;
};

/// `count` columns; nullopt if the elements of one differ too much in length.
std::optional<Columns> columns_of_list(const Braces& braces, std::size_t count) {
  constexpr std::size_t kMostBlanks = 10;
  Columns columns;
  columns.widths.resize(count, 0);
  std::vector<std::size_t> least(count, kNone);
  const std::size_t elements = braces.elements.size();
  for (std::size_t i = 0; i < elements; ++i) {
    const std::size_t at = i % count;
    const bool last = i + 1 == elements;
    const std::size_t behind = !last ? 1 : at + 1 == count ? columns_of(braces.tail) : 0;
    const std::size_t size = columns_of(braces.elements[i]) + behind;
    columns.widths[at] = std::max(columns.widths[at], size);
    least[at] = std::min(least[at], size);
  }
  for (std::size_t at = 0; at + 1 < count; ++at)
    if (columns.widths[at] - least[at] > kMostBlanks) return std::nullopt;
  columns.lines = (elements + count - 1) / count;
  columns.width = count - 1;
  for (const std::size_t width : columns.widths) columns.width += width;
  return columns;
}

/// The widest of them that fits, or one with fewer columns in as many lines.
Columns best_columns(const Braces& braces, std::size_t room) {
  constexpr std::size_t kMost = kColumns / 3;
  std::optional<Columns> best;
  for (std::size_t count = std::min(kMost, braces.elements.size()); count > 0; --count) {
    auto columns = columns_of_list(braces, count);
    if (!columns || (columns->width > room && count > 1)) continue;
    if (best && columns->lines > best->lines) break;
    best = std::move(columns);
  }
  return *best;
}

std::string in_columns(const Braces& braces, const Columns& columns, std::size_t indent) {
  std::string result;
  for (std::size_t i = 0; i < braces.elements.size(); ++i) {
    const std::size_t at = i % columns.widths.size();
    const bool last = i + 1 == braces.elements.size();
    std::string element = std::string(braces.elements[i]) + (last ? "" : ",");
    if (!last && at + 1 < columns.widths.size())
      element.append(columns.widths[at] - columns_of(element) + 1, ' ');
    if (i > 0 && at == 0) result += '\n' + std::string(indent, ' ');
    result += element;
  }
  return result + std::string(braces.tail);
}

}  // namespace

bool has_columns(const Braces& braces) {
  constexpr std::size_t kFew = 6, kFewWithin = 20;
  const std::size_t elements = braces.elements.size();
  if (elements < kFew || braces.is_designated() || !braces.head.ends_with('{')) return false;
  if (ranges::any_of(braces.elements, [](const auto& each) { return each.starts_with('{'); }))
    return false;
  int depth = 0;
  for (Scanner scan(braces.head); scan.next();) depth = scan.depth();
  const bool is_within = depth > 1 || braces.head == "{" || braces.head.starts_with('.');
  return elements >= kFewWithin || !is_within;
}

std::string wrapped_list(const Braces& braces, std::size_t indent, std::size_t deeper) {
  const std::size_t aligned = indent + columns_of(braces.head);
  const std::string begin = std::string(indent, ' ') + std::string(braces.head);
  const Columns aligned_list = best_columns(braces, kColumns - std::min(aligned, kColumns));
  const Columns indented_list = best_columns(braces, kColumns - deeper);
  if (aligned_list.lines <= indented_list.lines + 1)
    return begin + in_columns(braces, aligned_list, aligned);
  return begin + '\n' + std::string(deeper, ' ') + in_columns(braces, indented_list, deeper);
}

}  // namespace eagerx::gen
