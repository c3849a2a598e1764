// The outline of a YAML file that is being edited: keys, values, and their places. It continues
// with the complete lines of a file that read/ rejects.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace eagerx::gen {

/// Bytes of a text: [begin, end).
struct Bytes {
  std::size_t begin = 0, end = 0;
};

struct OutlineEntry;

/// A value; nothing where none was written yet.
struct OutlineNode {
  enum class Kind : unsigned char { nothing, map, list, scalar };
  Kind kind = Kind::nothing;
  std::string text;                   // of a scalar, without quotes
  Bytes place;                        // of a scalar, with quotes
  bool flow = false;                  // of a map or list: in braces or brackets
  std::vector<OutlineEntry> entries;  // of a map or list, as they stand

  /// The value of a key, or nullptr.
  [[nodiscard]] const OutlineNode* find(std::string_view key) const;
};

/// A key and its value, or an item of a list. A key without a colon is one that is being typed.
struct OutlineEntry {
  std::string key;  // without quotes; empty: an item
  Bytes key_place;
  Bytes whole;  // from the key, or the dash, to the end of the value
  bool has_colon = false;
  OutlineNode value;
};

/// At most 64 levels of nesting; deeper values are left out.
OutlineNode outline_of(std::string_view text);

/// From the top to a place: keys, and places in lists.
using OutlinePath = std::vector<std::variant<std::string, std::size_t>>;

/// The value at `path`, or nullptr.
const OutlineNode* node_at(const OutlineNode& top, const OutlinePath& path);

/// Position of the text cursor or the pointer.
struct Cursor {
  OutlinePath path = {};  // of the map or list that it is in; of a value of a key: of that value
  bool is_key = false;
  bool may_be_key = false;  // a value on a line of its own: of the map that `path` then is
  std::string typed = {};   // of the word, up to the cursor
  Bytes word = {};          // which a completion replaces, in the text
};

/// The place of the word at byte `at`, which may be empty.
Cursor cursor_at(std::string_view text, std::size_t at);

}  // namespace eagerx::gen
