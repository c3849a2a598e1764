// Removes entries from a text, with their commas or lines.
#include <algorithm>

#include "generator/tools/edit/written.hpp"

namespace eagerx::gen {
namespace {

/// Only blanks and at most one comma.
bool is_separator(std::string_view gap) {
  return gap.find_first_not_of(" \t\r\n,") == std::string_view::npos;
}

/// The line at `at`, if nothing is left on it.
void drop_empty_line(Written& written, std::size_t at) {
  const std::size_t begin = written.line_begin(at), end = written.line_end(at);
  if (begin > 0 && written.is_blank(begin, end))
    written.replace({begin, written.next_line(at)}, "");
}

bool out_of_flow(Written& written, const OutlineNode& node, std::size_t index) {
  const auto& entries = node.entries;
  const OutlineEntry& entry = entries[index];
  const std::size_t begin = entry.whole.begin, end = written.end_of(entry);
  if (index + 1 < entries.size()) {
    const std::size_t next = entries[index + 1].whole.begin;
    const std::string_view gap = written.in(end, next);
    if (is_separator(gap) && gap.find('\n') == std::string_view::npos) {
      written.replace({begin, next}, "");
      return true;
    }
  }
  if (index > 0) {
    const std::size_t before = written.end_of(entries[index - 1]);
    if (is_separator(written.in(before, begin))) {
      written.replace({before, end}, "");
      return true;
    }
  }
  // There is a comment between it and the others, which stays.
  const std::size_t comma = written.text().find_first_not_of(" \t", end);
  const bool has_comma = comma != std::string::npos && written.text()[comma] == ',';
  written.replace({begin, has_comma ? comma + 1 : end}, "");
  drop_empty_line(written, begin);
  return true;
}

/// The replacement of the only entry of a value, behind the key or dash of its owner.
bool empty_value(Written& written, const OutlinePath& owner_path, OutlineNode::Kind kind) {
  const OutlineEntry* const owner = written.entry(owner_path);
  if (owner == nullptr) return owner_path.empty();
  const std::size_t at = written.value_begin(*owner);
  written.replace({at, at}, kind == OutlineNode::Kind::map ? " {}" : " []");
  return true;
}

bool out_of_lines(Written& written, const OutlineNode& node, const OutlinePath& owner,
                  std::size_t index) {
  const OutlineEntry& entry = node.entries[index];
  const OutlineNode::Kind kind = node.kind;
  const bool is_only = node.entries.size() == 1;
  const std::size_t begin = entry.whole.begin, end = written.end_of(entry);
  const std::size_t line = written.line_begin(begin);
  if (!written.is_blank(line, begin)) {
    // Behind a dash: the next key takes its place.
    if (is_only) {
      written.replace({begin, end}, kind == OutlineNode::Kind::map ? "{}" : "[]");
      return true;
    }
    if (index != 0) return false;  // on the line of another entry: it is half written
    const std::size_t next = node.entries[1].whole.begin;
    if (written.has_comment(written.next_line(end), next)) return false;
    written.replace({begin, next}, "");
    return true;
  }
  std::size_t first = line;
  const std::size_t stop = written.next_line(end);
  const bool is_last_line = stop == written.size() && written.line_end(end) == written.size();
  if (is_last_line && first > 0) first = written.line_end(written.line_begin(first - 1));
  written.replace({first, stop}, "");
  return !is_only || empty_value(written, owner, kind);
}

}  // namespace

bool take_away(Written& written, const OutlinePath& path) {
  const OutlineEntry* const entry = written.entry(path);
  if (entry == nullptr) return false;
  const OutlinePath owner(path.begin(), path.end() - 1);
  const OutlineNode& node = *written.node(owner);
  const auto index = static_cast<std::size_t>(entry - node.entries.data());
  return node.flow ? out_of_flow(written, node, index) : out_of_lines(written, node, owner, index);
}

}  // namespace eagerx::gen
