// One connection seen from its reader: which messages a tick has, once start-up is over.
#pragma once

#include <optional>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

/// Times are in quanta of the plan's grid.
struct PathEdge {
  std::size_t node = 0, input = 0;                  // the reader
  std::int64_t source_period = 1, period = 1;       // of both ends
  std::int64_t a = 1, b = 1, x = 0, off = 0;        // as in Reception, with the longest delay
  std::int64_t received = 1;                        // messages at tick n: received + cum(n + off)
  std::int64_t window = 1;                          // 0: the new ones, or the last if none is new
  std::int64_t settled = 0;                         // the first tick of which all this is true
  std::int64_t newest_bound = 0, oldest_bound = 0;  // most that a message can be behind

  /// Number of the newest message at tick n, and of the oldest in its window.
  [[nodiscard]] std::int64_t newest(std::int64_t n) const { return total(n) - 1; }
  [[nodiscard]] std::int64_t oldest(std::int64_t n) const;

 private:
  [[nodiscard]] std::int64_t total(std::int64_t n) const;
};

/// nullopt if its numbers do not fit.
std::optional<PathEdge> make_path_edge(const Plan& plan, std::size_t node, std::size_t input);

}  // namespace eagerx::gen
