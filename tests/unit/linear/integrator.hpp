// An integrator with proportional control, whose loop has closed forms.
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "generator/tools/linear/sampled_system.hpp"

namespace eagerx::gen {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kPeriod = 0.01;
inline constexpr double kGain = 20.0;  // 1/s

/// x' = x + k·h·u and y = −x, `messages` times in a hyperperiod: y is sent, and u is what comes of
/// it.
inline SampledSystem integrator(std::size_t messages) {
  const double step = kGain * kPeriod;
  SampledSystem system;
  system.period_s = kPeriod * static_cast<double>(messages);
  system.state = {{"x", 0.0}};
  system.opened = messages;
  system.a = {{1.0}};
  system.b = {std::vector<double>(messages, step)};
  for (std::size_t i = 0; i < messages; ++i) {
    system.inputs.push_back({"y", "", 0, 0});
    system.outputs.push_back({"y", "", 0, 0});
    system.c.push_back({-1.0});
    auto& row = system.d.emplace_back(messages, 0.0);
    for (std::size_t k = 0; k < i; ++k) row[k] = -step;
  }
  return system;
}

}  // namespace eagerx::gen
