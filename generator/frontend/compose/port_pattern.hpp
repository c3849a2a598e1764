// Ports of elements of arrays: `leg[*].torque`, `leg[i + 1].y`, `robot.torque[2]`.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/spec/settings.hpp"

namespace eagerx::gen {

/// The text between brackets: a number, or a name plus a number. The k-th `*` of a port is the name
/// "*k".
struct PatternIndex {
  std::string name;  // empty: a number
  std::int64_t offset = 0;
};

/// A port with indices: `leg`, [*], `.torque`.
struct PortPattern {
  std::vector<std::string> texts;  // one more than indices
  std::vector<PatternIndex> indices;
  Span span;

  /// Whether the last index is that of an element of a message: `robot.torque[*]`.
  [[nodiscard]] bool has_element() const;
};

/// nullopt and E0392 where brackets hold no index.
std::optional<PortPattern> parse_pattern(const Spanned<std::string>& port,
                                         Diagnostics& diagnostics);

/// One port that matches a pattern.
struct IndexedPort {
  std::string port;                     // `leg[0].torque`
  std::optional<std::int64_t> element;  // of its messages
};
struct IndexedConnection {
  IndexedPort from, to;
};

/// The number of elements of the array with this name; nullopt if it is not an array.
using CountOf = std::function<std::optional<std::int64_t>(const std::string&)>;

/// The ports of a pattern, for all values of its names.
std::vector<IndexedPort> indexed_ports(const PortPattern& pattern, const CountOf& count_of,
                                       Diagnostics& diagnostics);
/// The connections of two patterns, which share their names. Problems: E0391 counts that differ,
/// no value that fits, several messages for one input; E0392 an index out of range.
std::vector<IndexedConnection> indexed_connections(const PortPattern& from, const PortPattern& to,
                                                   const CountOf& count_of,
                                                   Diagnostics& diagnostics);

}  // namespace eagerx::gen
