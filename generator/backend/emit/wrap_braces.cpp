#include "generator/backend/emit/wrap_braces.hpp"

#include <algorithm>

#include "generator/backend/emit/scanner.hpp"

namespace eagerx::gen {

std::optional<Braces> braces_at(std::string_view line, std::size_t brace) {
  Braces result;
  int depth = 0, outside = 0;
  std::size_t begin = brace + 1;
  for (Scanner scan(line); scan.next();) {
    const std::size_t at = scan.at();
    if (at < brace) outside = scan.depth();
    if (at <= brace || scan.in_literal()) continue;
    depth = scan.depth() - outside;
    if (line[at] == ',' && depth == 1) {
      result.elements.push_back(line.substr(begin, at - begin));
      begin = at + 1;
      if (begin < line.size() && line[begin] == ' ') ++begin;
    } else if ((line[at] == '}' || line[at] == ')' || line[at] == '>') && depth == 0) {
      if (at > begin) result.elements.push_back(line.substr(begin, at - begin));
      result.head = line.substr(0, brace + 1);
      result.tail = line.substr(at);
      return result;
    }
  }
  return std::nullopt;
}

bool all_fit(const Braces& braces, std::size_t indent) {
  for (const auto& element : braces.elements) {
    const bool last = &element == &braces.elements.back();
    if (indent + columns_of(element) + (last ? columns_of(braces.tail) : 1) > kColumns)
      return false;
  }
  return true;
}

std::string in_lines(const Braces& braces, std::size_t indent, bool one_a_line) {
  std::string result;
  std::size_t column = indent;
  for (std::size_t i = 0; i < braces.elements.size(); ++i) {
    const bool last = i + 1 == braces.elements.size();
    const std::size_t size =
        columns_of(braces.elements[i]) + (last ? columns_of(braces.tail) : std::size_t{1});
    if (indent + size > kColumns) {
      const std::string text =
          std::string(braces.elements[i]) + (last ? std::string(braces.tail) : ",");
      const std::size_t brace = text.find('{');
      const auto inner =
          brace == kNone || one_a_line || i == 0 ? std::nullopt : braces_at(text, brace);
      if (!last || !inner || inner->elements.empty()) return {};
      return result + '\n' + wrapped_braces(*inner, indent, indent + 4);
    }
    if (i > 0 && (one_a_line || column + 1 + size > kColumns)) {
      result += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (i > 0) {
      result += ' ';
      ++column;
    }
    result += braces.elements[i];
    result += last ? braces.tail : std::string_view(",");
    column += size;
  }
  return result;
}

namespace {

/// `{` and each element in a line of its own.
std::string one_below_another(const Braces& braces, std::size_t indent, std::size_t deeper) {
  std::string result = std::string(indent, ' ') + std::string(braces.head) + "\n";
  for (std::size_t i = 0; i < braces.elements.size(); ++i) {
    const bool last = i + 1 == braces.elements.size();
    const std::string line =
        std::string(braces.elements[i]) + (last ? std::string(braces.tail) : ",");
    const std::size_t brace = line.find('{');
    const auto inner = brace == kNone || deeper + columns_of(line) <= kColumns
                           ? std::nullopt
                           : braces_at(line, brace);
    const std::size_t call = line.find('(');
    if (inner && !inner->elements.empty()) {
      result += wrapped_braces(*inner, deeper, deeper + 4);
    } else if (deeper + columns_of(line) > kColumns && call != kNone) {
      result += std::string(deeper, ' ') + line.substr(0, call + 1) + '\n' +
                std::string(deeper + 4, ' ') + line.substr(call + 1);
    } else {
      result += std::string(deeper, ' ') + line;
    }
    if (!last) result += '\n';
  }
  return result;
}

}  // namespace

std::string wrapped_braces(const Braces& braces, std::size_t indent, std::size_t deeper) {
  if (braces.elements.size() == 1 && braces.elements.front().starts_with('{')) {  // `{{a, b}}`
    std::string text(braces.head);
    text += braces.elements.front();
    text += braces.tail;
    if (const auto inner = braces_at(text, braces.head.size()); inner && !inner->elements.empty())
      return wrapped_braces(*inner, indent, deeper);
  }
  if (has_columns(braces)) return wrapped_list(braces, indent, deeper);
  const std::string begin(indent, ' ');
  const std::size_t aligned = indent + columns_of(braces.head);
  std::string all;
  for (const auto& element : braces.elements)
    all += (all.empty() ? "" : ", ") + std::string(element);
  all += braces.tail;
  const bool fits_below = deeper + columns_of(all) <= kColumns;
  const std::string aside = in_lines(braces, aligned, braces.is_designated());
  const auto lines = std::ranges::count(aside, '\n') + 1;
  if (!aside.empty() && !(fits_below && lines > 2)) return begin + std::string(braces.head) + aside;
  if (braces.elements.size() == 1 && braces.is_designated()) {
    const std::string_view element = braces.elements.front();
    const std::size_t value = element.find(" = ");
    if (value != kNone && element.find('{') == kNone) {
      const std::string below = std::string(aligned + 4, ' ') +
                                std::string(element.substr(value + 3)) + std::string(braces.tail);
      if (columns_of(below) <= kColumns)
        return begin + std::string(braces.head) + std::string(element.substr(0, value + 2)) + '\n' +
               below;
    }
  }
  if (fits_below) return begin + std::string(braces.head) + '\n' + std::string(deeper, ' ') + all;
  std::string below = one_below_another(braces, indent, deeper);
  if (braces.elements.size() != 1 || !braces.is_designated()) return below;
  // `{.a = {{b, c`: on one line, unless the rest then takes as many lines.
  const std::string text =
      std::string(braces.head) + std::string(braces.elements.front()) + std::string(braces.tail);
  const std::size_t brace = text.find('{', braces.head.size());
  const auto inner = brace == kNone ? std::nullopt : braces_at(text, brace);
  if (!inner || inner->elements.empty()) return below;
  std::string in_line = wrapped_braces(*inner, indent, deeper);
  return std::ranges::count(in_line, '\n') < std::ranges::count(below, '\n') ? in_line : below;
}

}  // namespace eagerx::gen
