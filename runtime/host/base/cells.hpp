// Lines of tables of comma-separated values (RFC 4180), each row on a line of its own.
#pragma once

#include <string_view>
#include <vector>

namespace eagerx::host {

/// Raw cells of a line; quoted text is one cell.
inline std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  bool is_quoted = false;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') is_quoted = !is_quoted;
    if (i < line.size() && (line[i] != ',' || is_quoted)) continue;
    cells.push_back(line.substr(first, i - first));
    first = i + 1;
  }
  return cells;
}

}  // namespace eagerx::host
