// Reads untrusted JSON: from a server's client, a library, another program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::host {

struct JsonValue {
  enum class Kind : std::uint8_t { null, boolean, number, text, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0.0;
  std::string text;
  std::vector<JsonValue> items;    // of an array or an object
  std::vector<std::string> names;  // [items] of an object

  /// The first of this name; null if there is none, or this is not an object.
  const JsonValue* find(std::string_view name) const;
  bool is(Kind which) const { return kind == which; }
};

inline constexpr int kDeepestJson = 16;
inline constexpr std::size_t kMostJsonValues = 20'000;

/// Parses a JSON text (RFC 8259); nullopt if it is invalid, is nested deeper than kDeepestJson, or
/// has more than `most_values`. Numbers become the nearest double; numbers beyond the range of
/// double are invalid. Strings are taken unchanged, except for escapes.
std::optional<JsonValue> read_json(std::string_view text,
                                   std::size_t most_values = kMostJsonValues);

}  // namespace eagerx::host
