#include "generator/tools/edit/written.hpp"

#include <algorithm>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t\r\n";

bool is_same(const OutlinePath::value_type& step, const OutlineNode& node, std::size_t index) {
  if (node.kind == OutlineNode::Kind::list) {
    const auto* const place = std::get_if<std::size_t>(&step);
    return place != nullptr && *place == index;
  }
  const auto* const key = std::get_if<std::string>(&step);
  return key != nullptr && *key == node.entries[index].key;
}

void add_content(const OutlineNode& node, const OutlinePath& left_out, std::size_t depth,
                 bool on_way, std::string& text) {
  if (node.kind == OutlineNode::Kind::scalar) text += "=" + node.text;
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    const bool on = on_way && depth < left_out.size() && is_same(left_out[depth], node, i);
    if (on && depth + 1 == left_out.size()) continue;
    // An entry without other content counts as missing.
    std::string inner;
    add_content(node.entries[i].value, left_out, depth + 1, on, inner);
    if (on && inner.empty()) continue;
    text += "(" + node.entries[i].key + inner + ")";
  }
}

}  // namespace

Written::Written(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) {
    mark_ = kByteOrderMark;
    text.remove_prefix(kByteOrderMark.size());
  }
  text_ = text;
  const std::size_t newline = text.find('\n');
  const bool has_return =
      newline != std::string_view::npos && newline > 0 && text[newline - 1] == '\r';
  newline_ = has_return ? "\r\n" : "\n";
  top_ = outline_of(text_);
}

void Written::replace(Bytes place, std::string_view with) {
  text_.replace(place.begin, place.end - place.begin, with);
  top_ = outline_of(text_);
}

const OutlineEntry* Written::entry(const OutlinePath& path) const {
  if (path.empty()) return nullptr;
  const OutlineNode* const parent = node({path.begin(), path.end() - 1});
  if (parent == nullptr) return nullptr;
  for (std::size_t i = 0; i < parent->entries.size(); ++i) {
    if (is_same(path.back(), *parent, i)) return &parent->entries[i];
  }
  return nullptr;
}

bool Written::is_in_flow(const OutlinePath& path) const {
  OutlinePath above;
  for (const auto& step : path) {
    const OutlineNode* const around = node(above);
    if (around != nullptr && around->flow) return true;
    above.push_back(step);
  }
  return false;
}

std::size_t Written::end_of(const OutlineEntry& entry) const {
  // A value on several lines ends with its last entry; comments and empty lines after it belong to
  // no value.
  const OutlineNode& value = entry.value;
  if (!value.flow && !value.entries.empty()) return end_of(value.entries.back());
  std::size_t end = std::min(entry.whole.end, text_.size());
  while (end > entry.whole.begin && kBlanks.find(text_[end - 1]) != std::string_view::npos) --end;
  return end;
}

bool Written::has_dash(const OutlineEntry& entry) const {
  const std::size_t at = entry.whole.begin;
  if (!entry.key.empty() || at >= text_.size() || text_[at] != '-') return false;
  return at + 1 >= text_.size() || kBlanks.find(text_[at + 1]) != std::string_view::npos;
}

std::size_t Written::value_begin(const OutlineEntry& entry) const {
  if (has_dash(entry)) return entry.whole.begin + 1;
  if (entry.key.empty()) return entry.whole.begin;
  if (!entry.has_colon) return entry.key_place.end;
  return std::min(text_.find(':', entry.key_place.end), text_.size() - 1) + 1;
}

std::size_t Written::bracket_of(const OutlineEntry& entry) const {
  return text_.find(entry.value.kind == OutlineNode::Kind::map ? '{' : '[', value_begin(entry));
}

std::size_t Written::line_begin(std::size_t at) const {
  const std::size_t newline = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
  return newline == std::string::npos ? 0 : newline + 1;
}

std::size_t Written::line_end(std::size_t at) const {
  std::size_t end = std::min(text_.find('\n', at), text_.size());
  while (end > at && text_[end - 1] == '\r') --end;
  return end;
}

std::size_t Written::next_line(std::size_t at) const {
  const std::size_t newline = text_.find('\n', at);
  return newline == std::string::npos ? text_.size() : newline + 1;
}

bool Written::is_blank(std::size_t begin, std::size_t end) const {
  return in(begin, end).find_first_not_of(kBlanks) == std::string_view::npos;
}

bool Written::has_comment(std::size_t begin, std::size_t end) const {
  char quote = '\0';
  for (std::size_t i = begin; i < end; ++i) {
    const char c = text_[i];
    if (quote != '\0') {
      if (c == quote || c == '\n') quote = '\0';
    } else if (c == '"' || c == '\'') {
      if (i == 0 || std::string_view(" [{,:\t\n").find(text_[i - 1]) != std::string_view::npos)
        quote = c;
    } else if (c == '#' && (i == 0 || kBlanks.find(text_[i - 1]) != std::string_view::npos)) {
      return true;
    }
  }
  return false;
}

std::size_t Written::step() const {
  constexpr std::size_t kUsual = 2;
  for (const OutlineEntry& section : top_.entries) {
    const OutlineNode& value = section.value;
    if (value.flow || value.kind != OutlineNode::Kind::map || value.entries.empty()) continue;
    const std::size_t found = column(value.entries.front().key_place.begin);
    if (found > 0) return found;
  }
  return kUsual;
}

std::string content_of(const OutlineNode& top, const OutlinePath& left_out) {
  std::string text;
  add_content(top, left_out, 0, true, text);
  return text;
}

}  // namespace eagerx::gen
