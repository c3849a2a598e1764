#include "generator/frontend/outline/insert.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace eagerx::gen {
namespace {

/// The line ending of a text.
std::string_view newline_of(std::string_view text) {
  const std::size_t newline = text.find('\n');
  return newline != std::string_view::npos && newline > 0 && text[newline - 1] == '\r' ? "\r\n"
                                                                                       : "\n";
}

/// The end of the line that has byte `at`, before whatever ends it.
std::size_t line_end(std::string_view text, std::size_t at) {
  std::size_t end = std::min(text.find('\n', at), text.size());
  if (end > at && text[end - 1] == '\r') --end;
  return end;
}

std::size_t column_of(std::string_view text, std::size_t at) {
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return newline == std::string_view::npos ? at : at - newline - 1;
}

/// Behind the last entry of a collection in brackets; if it has none, behind the bracket.
std::optional<Splice> in_brackets(std::string_view text, const OutlineEntry& owner,
                                  const std::string& what) {
  const OutlineNode& node = owner.value;
  if (!node.entries.empty()) {
    const std::size_t end = end_of(text, node.entries.back());
    return Splice{{end, end}, ", " + what};
  }
  const char bracket = node.kind == OutlineNode::Kind::map ? '{' : '[';
  const std::size_t begin = text.find(bracket, std::max(owner.key_place.end, owner.whole.begin));
  if (begin == std::string_view::npos || begin >= owner.whole.end) return std::nullopt;
  return Splice{{begin + 1, begin + 1}, what};
}

/// On a line of its own behind the last entry.
Splice on_a_line(std::string_view text, const OutlineNode& node, const std::string& what) {
  const OutlineEntry& first = node.entries.front();
  const std::size_t begin = first.key.empty() ? first.whole.begin : first.key_place.begin;
  const std::size_t end = line_end(text, end_of(text, node.entries.back()));
  return {{end, end},
          fmt::format("{}{}{}", newline_of(text), std::string(column_of(text, begin), ' '), what)};
}

std::optional<Splice> added(std::string_view text, const OutlineEntry& owner,
                            OutlineNode::Kind kind, const std::string& in_flow,
                            const std::string& alone) {
  if (owner.value.kind != kind) return std::nullopt;
  if (owner.value.flow) return in_brackets(text, owner, in_flow);
  if (owner.value.entries.empty()) return std::nullopt;
  return on_a_line(text, owner.value, alone);
}

}  // namespace

std::vector<const OutlineEntry*> entries_around(const OutlineNode& top, std::size_t at) {
  std::vector<const OutlineEntry*> found;
  for (const OutlineNode* node = &top; node != nullptr;) {
    const OutlineEntry* inner = nullptr;
    for (const OutlineEntry& entry : node->entries) {
      if (entry.whole.begin <= at && at <= entry.whole.end) inner = &entry;
    }
    if (inner != nullptr) found.push_back(inner);
    node = inner != nullptr ? &inner->value : nullptr;
  }
  return found;
}

std::size_t end_of(std::string_view text, const OutlineEntry& owner) {
  std::size_t end = std::min(owner.whole.end, text.size());
  while (end > owner.whole.begin &&
         std::string_view(" \t\r\n").find(text[end - 1]) != std::string_view::npos)
    --end;
  return end;
}

std::optional<Splice> with_key(std::string_view text, const OutlineEntry& owner,
                               const std::string& key, const std::string& value) {
  const std::string what = fmt::format("{}: {}", key, value);
  return added(text, owner, OutlineNode::Kind::map, what, what);
}

std::optional<Splice> with_item(std::string_view text, const OutlineEntry& owner,
                                const std::string& item) {
  return added(text, owner, OutlineNode::Kind::list, item, "- " + item);
}

Splice with_section(std::string_view text, const std::string& key, const std::string& value) {
  const std::string_view newline = newline_of(text);
  const bool is_open = !text.empty() && text.back() != '\n';
  return {{text.size(), text.size()},
          fmt::format("{}{}:{}{}{}", is_open ? newline : "", key,
                      value.starts_with('\n') ? "" : " ", value, newline)};
}

}  // namespace eagerx::gen
