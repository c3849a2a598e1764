#include "generator/frontend/outline/outline.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr int kMostDepth = 64;
constexpr char kMark = '\x01';  // in YAML no character may be this one

OutlineNode node_of(OutlineNode::Kind kind, bool is_flow = false) {
  OutlineNode node;
  node.kind = kind;
  node.flow = is_flow;
  return node;
}
OutlineNode scalar_from(std::size_t begin, std::size_t end) {
  OutlineNode node = node_of(OutlineNode::Kind::scalar);
  node.place = {begin, end};
  return node;
}

/// One pass over the text. `at_` is always at the next byte that is not read yet.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  OutlineNode whole() {
    OutlineNode top = block(0, 0);
    // A line that is less indented than the first one: what follows is read as more of the same.
    while (next_line()) {
      const std::size_t before = at_;
      OutlineNode more = block(0, 0);
      if (more.kind == top.kind) std::ranges::move(more.entries, std::back_inserter(top.entries));
      if (at_ == before) skip_line();
    }
    return top;
  }

 private:
  [[nodiscard]] bool ended() const { return at_ >= text_.size(); }
  [[nodiscard]] char here() const { return ended() ? '\n' : text_[at_]; }
  [[nodiscard]] char ahead(std::size_t by = 1) const {
    return at_ + by < text_.size() ? text_[at_ + by] : '\n';
  }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool ends_word(char c) { return is_blank(c) || c == '\n'; }
  void skip_blanks() {
    while (!ended() && is_blank(here())) ++at_;
  }
  void skip_line() {
    while (!ended() && here() != '\n') ++at_;
    if (!ended()) ++at_;
  }
  [[nodiscard]] std::size_t column() const {
    const std::size_t newline = at_ == 0 ? std::string_view::npos : text_.rfind('\n', at_ - 1);
    return newline == std::string_view::npos ? at_ : at_ - newline - 1;
  }
  [[nodiscard]] bool at_line_start() const { return at_ == 0 || text_[at_ - 1] == '\n'; }

  /// Goes to the first character of the next line that says something; false: there is none. Where
  /// a line has been begun, only blanks and a comment may still be on it.
  bool next_line() {
    while (!ended()) {
      skip_blanks();
      const bool document = at_line_start() && (text_.substr(at_).starts_with("---") ||
                                                text_.substr(at_).starts_with("..."));
      if (here() == '#' || document) {
        skip_line();
      } else if (here() == '\n') {
        if (!ended()) ++at_;
      } else {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool at_item() const { return here() == '-' && ends_word(ahead()); }

  /// A map, a list or a scalar whose first line is indented by at least `least`.
  OutlineNode block(std::size_t least, int depth) {
    const std::size_t start = at_;
    if (!next_line() || column() < least || depth > kMostDepth) {
      if (depth > kMostDepth)
        skip_line();
      else
        at_ = start;
      return {};
    }
    return at_item() ? list(column(), depth) : map_or_scalar(column(), depth);
  }

  OutlineNode list(std::size_t indent, int depth) {
    OutlineNode node = node_of(OutlineNode::Kind::list);
    while (next_line() && column() == indent && at_item()) {
      OutlineEntry item;
      item.whole.begin = at_++;
      skip_blanks();
      if (here() == '\n' || here() == '#') {
        item.value = block(indent + 1, depth + 1);
      } else {
        item.value = at_item() ? list(column(), depth + 1) : map_or_scalar(column(), depth + 1);
      }
      item.whole.end = at_;
      node.entries.push_back(std::move(item));
    }
    return node;
  }

  /// From the first key, or all of a value that is none.
  OutlineNode map_or_scalar(std::size_t indent, int depth) {
    if (here() == '{' || here() == '[') return rest_of(flow(indent, depth), indent);
    if (!line_has_key()) {
      // The beginning of a key, if keys follow.
      const std::size_t start = at_;
      OutlineNode word = scalar();
      const std::size_t after = at_;
      const bool continues = next_line() && column() == indent && !at_item() && line_has_key();
      at_ = after;
      if (!continues) return rest_of(std::move(word), indent);
      at_ = start;
    }
    return map(indent, depth);
  }

  OutlineNode map(std::size_t indent, int depth) {
    OutlineNode node = node_of(OutlineNode::Kind::map);
    while (next_line() && column() == indent && !at_item()) {
      OutlineEntry entry;
      entry.whole.begin = at_;
      entry.has_colon = line_has_key();
      const OutlineNode key = entry.has_colon ? key_text(":") : scalar();
      entry.key = key.text;
      entry.key_place = key.place;
      if (entry.has_colon) {
        skip_blanks();
        ++at_;  // the colon
        entry.value = value(indent, depth);
      } else if (here() == '\n' || here() == '#') {
        skip_deeper(indent);
      }
      entry.whole.end = at_;
      node.entries.push_back(std::move(entry));
    }
    return node;
  }

  /// Behind a colon.
  OutlineNode value(std::size_t indent, int depth) {
    skip_blanks();
    if (here() == '&' || here() == '!') {  // an anchor or a tag
      while (!ends_word(here())) ++at_;
      skip_blanks();
    }
    if (here() == '{' || here() == '[') return rest_of(flow(indent, depth + 1), indent);
    if (here() == '|' || here() == '>') {
      OutlineNode text = scalar_from(at_, at_ + 1);
      skip_line();
      skip_deeper(indent);
      return text;
    }
    if (here() != '\n' && here() != '#') return rest_of(scalar(), indent);
    const std::size_t start = at_;
    if (next_line() && column() == indent && at_item()) return list(indent, depth + 1);
    at_ = start;
    return block(indent + 1, depth + 1);
  }

  /// Lines that continue a value.
  OutlineNode rest_of(OutlineNode node, std::size_t indent) {
    skip_deeper(indent);
    return node;
  }
  void skip_deeper(std::size_t indent) {
    std::size_t start = at_;
    while (next_line() && !(column() <= indent)) {
      skip_line();
      start = at_;
    }
    at_ = start;
  }

  /// Whether there is a colon behind a word, outside of quotes.
  [[nodiscard]] bool line_has_key() const {
    std::size_t i = at_;
    if (const char quote = here(); quote == '"' || quote == '\'') {
      const std::size_t end = text_.find(quote, i + 1);
      if (end == std::string_view::npos) return false;
      i = end + 1;
      while (i < text_.size() && is_blank(text_[i])) ++i;
      return i < text_.size() && text_[i] == ':';
    }
    for (; i < text_.size() && text_[i] != '\n'; ++i) {
      if (text_[i] == '#' && i > at_ && is_blank(text_[i - 1])) return false;
      if (text_[i] == ':' && (i + 1 >= text_.size() || ends_word(text_[i + 1]))) return true;
    }
    return false;
  }

  OutlineNode quoted() {
    const char quote = here();
    OutlineNode node = scalar_from(at_, at_);
    ++at_;
    while (!ended() && here() != '\n' && here() != quote) node.text += text_[at_++];
    if (here() == quote) ++at_;
    node.place.end = at_;
    return node;
  }

  /// To the end of the line, or to one of `ends` and a blank.
  OutlineNode key_text(std::string_view ends) {
    if (here() == '"' || here() == '\'') return quoted();
    return plain([&](std::size_t i) {
      return ends.find(text_[i]) != std::string_view::npos &&
             (i + 1 >= text_.size() || ends_word(text_[i + 1]));
    });
  }
  OutlineNode scalar() {
    if (here() == '"' || here() == '\'') return quoted();
    return plain([](std::size_t /*i*/) { return false; });
  }
  template <class Ends>
  OutlineNode plain(const Ends& ends) {
    OutlineNode node = scalar_from(at_, at_);
    for (; !ended() && here() != '\n' && !ends(at_); ++at_) {
      if (here() == '#' && at_ > node.place.begin && is_blank(text_[at_ - 1])) break;
      if (!is_blank(here())) node.place.end = at_ + 1;
    }
    node.text = text_.substr(node.place.begin, node.place.end - node.place.begin);
    if (node.text.empty()) node.kind = OutlineNode::Kind::nothing;
    return node;
  }

  /// To the next thing within braces. False: a line begins that is no more in them, for it is as
  /// far to the left as what the braces belong to.
  bool next_in_flow(std::size_t indent) {
    while (!ended()) {
      skip_blanks();
      if (here() == '#') {
        while (!ended() && here() != '\n') ++at_;
      }
      if (here() != '\n') return true;
      std::size_t i = at_ + 1;
      while (i < text_.size() && is_blank(text_[i])) ++i;
      if (i < text_.size() && text_[i] != '\n' && text_[i] != '#' && text_[i] != '}' &&
          text_[i] != ']' && i - (at_ + 1) <= indent)
        return false;
      if (ended()) return false;
      ++at_;
    }
    return false;
  }

  OutlineNode flow(std::size_t indent, int depth) {
    const bool is_map = here() == '{';
    OutlineNode node = node_of(is_map ? OutlineNode::Kind::map : OutlineNode::Kind::list, true);
    ++at_;
    while (depth <= kMostDepth && next_in_flow(indent)) {
      if (here() == '}' || here() == ']') {
        ++at_;
        return node;
      }
      if (here() == ',') {
        ++at_;
        continue;
      }
      OutlineEntry entry;
      entry.whole.begin = at_;
      if (is_map) {
        const OutlineNode key = flow_word(true);
        entry.key = key.text;
        entry.key_place = key.place;
        skip_blanks();
        entry.has_colon = here() == ':';
        if (entry.has_colon) {
          ++at_;
          if (next_in_flow(indent)) entry.value = flow_value(indent, depth);
        }
      } else {
        entry.value = flow_value(indent, depth);
      }
      if (at_ == entry.whole.begin) ++at_;  // a stray character
      entry.whole.end = at_;
      node.entries.push_back(std::move(entry));
    }
    return node;
  }
  OutlineNode flow_value(std::size_t indent, int depth) {
    if (here() == '{' || here() == '[') return flow(indent, depth + 1);
    return flow_word(false);
  }
  OutlineNode flow_word(bool is_key) {
    if (here() == '"' || here() == '\'') return quoted();
    return plain([&](std::size_t i) {
      const char c = text_[i];
      if (c == ',' || c == '}' || c == ']' || c == '{' || c == '[') return true;
      return is_key && c == ':';
    });
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

struct Found {
  OutlinePath path;
  bool is_key;
  const OutlineNode* scalar;
  const OutlineEntry* entry;
};

/// Where the mark is.
std::optional<Found> find_mark(const OutlineNode& node, OutlinePath& path) {
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    const OutlineEntry& entry = node.entries[i];
    if (entry.key.find(kMark) != std::string::npos) return Found{path, true, nullptr, &entry};
    if (node.kind == OutlineNode::Kind::map) {
      path.emplace_back(entry.key);
    } else {
      path.emplace_back(i);
    }
    if (entry.value.text.find(kMark) != std::string::npos)
      return Found{path, false, &entry.value, &entry};
    if (auto found = find_mark(entry.value, path)) return found;
    path.pop_back();
  }
  return std::nullopt;
}

/// Only blanks and dashes of lists stand before it.
bool begins_line(std::string_view text, std::size_t at) {
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
  return text.substr(begin, at - begin).find_first_not_of(" -") == std::string_view::npos;
}

}  // namespace

const OutlineNode* OutlineNode::find(std::string_view key) const {
  if (kind != Kind::map) return nullptr;
  for (const OutlineEntry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

OutlineNode outline_of(std::string_view text) {
  return Scanner(text).whole();
}

const OutlineNode* node_at(const OutlineNode& top, const OutlinePath& path) {
  const OutlineNode* node = &top;
  for (const auto& step : path) {
    if (const auto* const key = std::get_if<std::string>(&step)) {
      node = node->find(*key);
    } else {
      const std::size_t place = std::get<std::size_t>(step);
      const bool is_there = node->kind == OutlineNode::Kind::list && place < node->entries.size();
      node = is_there ? &node->entries[place].value : nullptr;
    }
    if (node == nullptr) return nullptr;
  }
  return node;
}

Cursor cursor_at(std::string_view text, std::size_t at) {
  at = std::min(at, text.size());
  std::string marked(text);
  marked.insert(at, 1, kMark);
  const OutlineNode top = outline_of(marked);
  OutlinePath path;
  Cursor cursor;
  cursor.word = {at, at};
  std::optional<Found> found = find_mark(top, path);
  // A text of one word: the beginning of its first key.
  if (top.text.find(kMark) != std::string::npos) found = Found{{}, true, &top, nullptr};
  if (!found) return cursor;
  const bool is_entry = found->scalar == nullptr;
  const std::string& word = is_entry ? found->entry->key : found->scalar->text;
  const Bytes place = is_entry ? found->entry->key_place : found->scalar->place;
  cursor.path = std::move(found->path);
  cursor.is_key = found->is_key;
  cursor.typed = word.substr(0, word.find(kMark));
  cursor.word = {std::min(place.begin, at), std::max(place.end - 1, at)};  // without the mark
  const auto is_quote = [&](std::size_t i) { return text[i] == '"' || text[i] == '\''; };
  if (cursor.word.begin < at && is_quote(cursor.word.begin)) ++cursor.word.begin;
  if (cursor.word.end > at && is_quote(cursor.word.end - 1)) --cursor.word.end;
  cursor.may_be_key = !cursor.is_key && begins_line(text, cursor.word.begin);
  return cursor;
}

}  // namespace eagerx::gen
