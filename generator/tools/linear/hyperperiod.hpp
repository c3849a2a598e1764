// What a graph does in one hyperperiod, from a point: the state after it, what its ports sent, and
// the derivatives of both.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/tools/linear/sampled_system.hpp"

namespace eagerx::gen {

/// An element of a state that a reset sets: "pendulum.model_state[1]".
struct ResetElement {
  std::string state;
  std::size_t element = 0;
  double value = 0.0;                             // that was set
  std::optional<double> low, high;                // of its space, where it is bounded
  std::optional<double> sample_low, sample_high;  // from which a reset samples it
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t word = kNone;  // the number of the program that it is, unchanged
};

/// x' = F(x, u), y = G(x, u), with x all numbers of the program.
struct Hyperperiod {
  SampledSystem system;             // at x
  std::vector<double> after_reset;  // x right after a reset
  std::vector<double> next;         // x'
  std::vector<double> observed;     // y
  std::vector<double> later;        // x'' after another one: not F(x', u) if F depends on the time
  std::vector<ResetElement> states;
  // Numbers of nodes that depend on nothing but themselves, such as a filter's covariance, and that
  // were brought to rest.
  std::vector<std::size_t> settled;
};

/// Whether a number stays what it is, or changes in the same way, whatever the others are: a
/// parameter, or a clock.
bool is_constant(const SampledSystem& system, std::size_t word);

/// Whether a reset sets it, and nothing else: a parameter of an object or a node, or a delay.
bool is_parameter(const Hyperperiod& there, const ResetElement& element);

/// What the program of target linearize printed; nothing if it is none of this graph's.
std::optional<Hyperperiod> read_hyperperiod(std::string_view text, const Plan& plan);

}  // namespace eagerx::gen
