// Tables of runs (`--csv` of a program) as transitions to learn from.
#pragma once

#include <string>
#include <string_view>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/sac/memory.hpp"
#include "targets/environments/train/statistics.hpp"

namespace eagerx::train::sac {

struct Log {
  std::size_t transitions = 0;
  std::size_t left_out = 0;  // with numbers that are missing or not finite
};

/// Adds the transitions of a table to the memory, its observations to `observations` [width], its
/// discounted returns to `returns` [1], and to `rewards` [2] what Model::rewards has. Actions are
/// brought from their bounds to -1…1. A last line without an end is left out: the program was
/// killed there. `name` is the file's. Throws Problem with the line for a table that is not one of
/// the graph's.
Log read_log(std::string_view text, const std::string& name, const Description& description,
             float discount, Memory& memory, Sums& observations, Sums& returns, Sums& rewards);

}  // namespace eagerx::train::sac
