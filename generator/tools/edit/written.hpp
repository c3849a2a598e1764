// A YAML text with its outline and layout. Inside edit/ only.
#pragma once

#include <string>
#include <string_view>

#include "generator/tools/edit/edit.hpp"

namespace eagerx::gen {

class Written {
 public:
  explicit Written(std::string_view text);

  [[nodiscard]] const OutlineNode& top() const { return top_; }
  /// The text, with its byte order mark.
  [[nodiscard]] std::string whole() const { return mark_ + text_; }
  [[nodiscard]] std::string_view in(std::size_t begin, std::size_t end) const {
    return std::string_view(text_).substr(begin, end - begin);
  }
  [[nodiscard]] std::string_view in(Bytes bytes) const { return in(bytes.begin, bytes.end); }
  /// Changes the text, and invalidates earlier results.
  void replace(Bytes place, std::string_view with);

  /// Of a path that is not empty: its key or item, or nullptr.
  [[nodiscard]] const OutlineEntry* entry(const OutlinePath& path) const;
  [[nodiscard]] const OutlineNode* node(const OutlinePath& path) const {
    return node_at(top_, path);
  }
  /// Whether something around it is in braces or brackets.
  [[nodiscard]] bool is_in_flow(const OutlinePath& path) const;

  /// Where the last character of an entry ends.
  [[nodiscard]] std::size_t end_of(const OutlineEntry& entry) const;
  /// Behind its colon or dash; of an item in brackets where it begins.
  [[nodiscard]] std::size_t value_begin(const OutlineEntry& entry) const;
  /// The brace or bracket of a value that begins with one.
  [[nodiscard]] std::size_t bracket_of(const OutlineEntry& entry) const;
  /// Whether it is `- …` on a line.
  [[nodiscard]] bool has_dash(const OutlineEntry& entry) const;

  [[nodiscard]] std::size_t line_begin(std::size_t at) const;
  /// The end of the line, without its newline.
  [[nodiscard]] std::size_t line_end(std::size_t at) const;
  /// Where the next line begins, or the text ends.
  [[nodiscard]] std::size_t next_line(std::size_t at) const;
  [[nodiscard]] std::size_t column(std::size_t at) const { return at - line_begin(at); }
  [[nodiscard]] bool is_blank(std::size_t begin, std::size_t end) const;
  [[nodiscard]] bool has_comment(std::size_t begin, std::size_t end) const;
  [[nodiscard]] std::size_t size() const { return text_.size(); }
  [[nodiscard]] const std::string& text() const { return text_; }

  /// "\n" or "\r\n", as its first line ends.
  [[nodiscard]] const std::string& newline() const { return newline_; }
  /// Number of blanks by which a section is indented.
  [[nodiscard]] std::size_t step() const;

 private:
  std::string mark_, text_, newline_;
  OutlineNode top_;
};

/// All keys and values in order, without layout and without the entry at `left_out`.
std::string content_of(const OutlineNode& top, const OutlinePath& left_out = {});

// The parts of structural changes. False: it is not possible there.

/// Adds a key at the end of the map at `path`, or at its place among the sections of a graph.
bool insert_key(Written& written, const OutlinePath& path, const std::string& key,
                const std::string& value);
/// Adds an item at the end of the list at `path`; `lines`: the same on lines, for a list that has
/// its items on such. An empty list becomes one of lines with `may_open`.
bool insert_item(Written& written, const OutlinePath& path, const std::string& item,
                 const std::vector<std::string>& lines, bool may_open);
/// Takes away one entry.
bool take_away(Written& written, const OutlinePath& path);
/// Makes `{a: {}, b: {}}` of a list of names in brackets.
bool make_map_of_names(Written& written, const OutlinePath& path);

}  // namespace eagerx::gen
