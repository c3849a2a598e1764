// Inserts keys and items into a text in the style of their neighbors.
#include <fmt/format.h>

#include <array>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/tools/edit/written.hpp"

namespace eagerx::gen {
namespace {

/// The order in which people write a graph's sections.
constexpr std::array kSections = {"extends",     "name",    "rate",   "real",    "library",
                                  "engine",      "objects", "nodes",  "actions", "observations",
                                  "connections", "task",    "render", "agent",   "safety"};

std::size_t rank_of(std::string_view section) {
  return static_cast<std::size_t>(ranges::find(kSections, section) - kSections.begin());
}

/// Sections whose entries are each on a line of their own.
bool has_lines(const OutlinePath& path) {
  if (path.size() != 1) return false;
  constexpr std::array kOnLines = {"objects", "nodes", "actions", "connections", "variants"};
  const auto* const key = std::get_if<std::string>(&path.front());
  return key != nullptr && ranges::contains(kOnLines, *key);
}

/// Behind the last entry of a collection in braces or brackets: behind its comma if it has one.
bool put_in_flow(Written& written, const OutlineNode& node, std::size_t bracket,
                 const std::string& what) {
  if (node.entries.empty()) {
    written.replace({bracket + 1, bracket + 1}, what);
    return true;
  }
  const OutlineEntry& last = node.entries.back();
  const std::size_t end = written.end_of(last);
  if (node.entries.size() > 1) {
    const OutlineEntry& before = node.entries[node.entries.size() - 2];
    const std::string_view gap = written.in(written.end_of(before), last.whole.begin);
    if (gap.find('\n') != std::string_view::npos) {
      // Each on a line of its own, and so is this one.
      const std::size_t begin = written.line_begin(last.whole.begin);
      const std::string indent(last.whole.begin - begin, ' ');
      written.replace({end, end}, "," + written.newline() + indent + what);
      return true;
    }
  }
  written.replace({end, end}, ", " + what);
  return true;
}

/// Below the line that ends at or behind `end`.
bool put_on_lines(Written& written, std::size_t end, std::size_t indent,
                  const std::vector<std::string>& lines) {
  const std::size_t place = written.line_end(end);
  std::string text;
  for (const std::string& line : lines) text += written.newline() + std::string(indent, ' ') + line;
  written.replace({place, place}, text);
  return true;
}

/// The value of a key that has none yet, or an empty one in brackets, becomes lines below it.
bool open_below(Written& written, const OutlinePath& path, const std::vector<std::string>& lines) {
  const OutlineEntry* owner = written.entry(path);
  const std::size_t key = written.column(owner->whole.begin);
  const std::size_t indent = key + written.step();
  std::size_t end = written.value_begin(*owner);
  if (owner->value.kind != OutlineNode::Kind::nothing) {
    const std::size_t bracket = written.bracket_of(*owner);
    const std::size_t close = written.end_of(*owner);
    if (!written.is_blank(bracket + 1, close - 1)) return false;  // a comment
    written.replace({end, close}, "");
  }
  return put_on_lines(written, end, indent, lines);
}

bool insert_section(Written& written, const std::string& line) {
  const OutlineNode& top = written.top();
  const std::size_t rank = rank_of(line.substr(0, line.find(':')));
  const OutlineEntry* before = nullptr;
  for (const OutlineEntry& entry : top.entries) {
    if (rank_of(entry.key) <= rank) before = &entry;
  }
  if (before != nullptr)
    return put_on_lines(written, written.end_of(*before), written.column(before->whole.begin),
                        {line});
  if (!top.entries.empty()) {
    const std::size_t begin = written.line_begin(top.entries.front().whole.begin);
    written.replace({begin, begin}, line + written.newline());
    return true;
  }
  const std::size_t end = written.size();
  const bool is_open = end > 0 && written.text().back() != '\n';
  written.replace({end, end}, (is_open ? written.newline() : "") + line + written.newline());
  return true;
}

}  // namespace

bool insert_key(Written& written, const OutlinePath& path, const std::string& key,
                const std::string& value) {
  using Kind = OutlineNode::Kind;
  const std::string line = fmt::format("{}: {}", yaml_text(key), value);
  const OutlineNode* const node = written.node(path);
  if (node == nullptr) return false;
  if (path.empty()) {
    if (node->kind == Kind::map && node->flow)
      return put_in_flow(written, *node, written.text().find('{'), line);
    return (node->kind == Kind::map || node->kind == Kind::nothing) &&
           insert_section(written, line);
  }
  const OutlineEntry& owner = *written.entry(path);
  if (node->kind == Kind::nothing) {
    if (!owner.has_colon && !owner.key.empty()) return false;  // half a key
    if (!owner.key.empty() && !written.is_in_flow(path)) return open_below(written, path, {line});
    const std::size_t begin = written.value_begin(owner);
    written.replace({begin, begin}, " {" + line + "}");
    return true;
  }
  if (node->kind != Kind::map) return false;
  if (!node->flow && node->entries.empty()) return false;
  if (!node->flow)
    return put_on_lines(written, written.end_of(node->entries.back()),
                        written.column(node->entries.front().whole.begin), {line});
  if (node->entries.empty() && has_lines(path) && open_below(written, path, {line})) return true;
  return put_in_flow(written, *node, written.bracket_of(owner), line);
}

bool insert_item(Written& written, const OutlinePath& path, const std::string& item,
                 const std::vector<std::string>& lines, bool may_open) {
  using Kind = OutlineNode::Kind;
  const OutlineNode* const node = written.node(path);
  if (node == nullptr || path.empty()) return false;
  const OutlineEntry& owner = *written.entry(path);
  const std::vector<std::string> one = {"- " + item};
  if (node->kind == Kind::nothing) {
    if (!owner.has_colon) return false;
    if (may_open && !written.is_in_flow(path)) return open_below(written, path, one);
    const std::size_t begin = written.value_begin(owner);
    written.replace({begin, begin}, " [" + item + "]");
    return true;
  }
  const bool is_empty_map = node->kind == Kind::map && node->flow && node->entries.empty();
  if (node->kind != Kind::list && !is_empty_map) return false;
  if (!node->flow && node->entries.empty()) return false;
  if (!node->flow) {
    const OutlineNode& last = node->entries.back().value;
    const bool on_lines = last.kind == Kind::map && !last.flow && !lines.empty();
    return put_on_lines(written, written.end_of(node->entries.back()),
                        written.column(node->entries.front().whole.begin), on_lines ? lines : one);
  }
  if (node->entries.empty() && may_open && open_below(written, path, one)) return true;
  return !is_empty_map && put_in_flow(written, *node, written.bracket_of(owner), item);
}

bool make_map_of_names(Written& written, const OutlinePath& path) {
  const OutlineNode* const node = written.node(path);
  const OutlineEntry* const owner = written.entry(path);
  if (owner == nullptr || node->kind != OutlineNode::Kind::list || !node->flow) return false;
  const std::size_t begin = written.bracket_of(*owner), end = written.end_of(*owner);
  if (end == 0 || written.text()[end - 1] != ']' || written.has_comment(begin, end)) return false;
  std::string map;
  for (const OutlineEntry& item : node->entries) {
    if (item.value.kind != OutlineNode::Kind::scalar) return false;
    map += fmt::format("{}{}: {{}}", map.empty() ? "" : ", ", yaml_text(item.value.text));
  }
  written.replace({begin, end}, "{" + map + "}");
  return true;
}

}  // namespace eagerx::gen
