// The worst margins over the corners of what a reset samples.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/tools/linear/hyperperiod.hpp"
#include "generator/tools/linear/modes.hpp"

namespace eagerx::gen {

/// NAME=VALUE,… of each state with a sampled parameter or delay.
using Corner = std::vector<std::string>;

/// Parameters and delays with a range from which a reset samples them: elements of
/// Hyperperiod::states.
std::vector<std::size_t> sampled_parameters(const Hyperperiod& there);
/// All combinations of the ends of their ranges, at most 2^8; nothing if there are more.
std::optional<std::vector<Corner>> corners_of(const Hyperperiod& there);

/// Figures of several loops, each the worst, and the corners with them.
struct WorstMargins {
  std::size_t corners = 0;
  Margins margins;
  std::string stability_at, phase_at, gain_at, least_gain_at, delay_at;  // "robot.mass=0.6"

  void take(const Margins& found, const Corner& corner);
};

}  // namespace eagerx::gen
