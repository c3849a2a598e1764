// The sampled loop of a graph: x' = A·x + B·u, y = C·x + D·u over one hyperperiod.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// A number that the program remembers from one hyperperiod to the next.
struct StateWord {
  std::string name;
  double value = 0.0;  // where it was linearized
  bool is_message = false;
};

/// An element of the messages of a port.
struct SampledPort {
  std::string name, unit;
  std::size_t channel = 0, element = 0;
};

/// Rows of numbers: [rows][columns].
using Rows = std::vector<std::vector<double>>;

/// x is the state at an instant at which all rates are due, after the environment has observed. An
/// input is added to each message of a hyperperiod, an output is the last message in it. The
/// opened loop has an input and an output for each message of one, behind the others.
struct SampledSystem {
  double period_s = 0.0;
  std::uint64_t steps = 1;  // of the environment in a hyperperiod
  std::vector<StateWord> state;
  std::vector<SampledPort> inputs, outputs;
  Rows a, b, c, d;
  std::size_t opened = 0;               // messages of the opened port in a hyperperiod
  std::vector<std::string> unchanging;  // numbers of the program that nothing changes
  std::vector<std::string> losing;      // ports of nodes whose derivatives are not known
  std::vector<std::string> smoothing;   // and of those whose steps count with their mean slope
  double drift = 0.0;                   // of A to the next hyperperiod, of its largest element
};

/// What the program of target linearize printed, with all numbers of its state; nothing if it is
/// none of this graph's.
std::optional<SampledSystem> read_whole_system(const Json& printed, const Plan& plan);
/// The same from its text, without the numbers that neither change nor matter.
std::optional<SampledSystem> read_system(std::string_view text, const Plan& plan);

}  // namespace eagerx::gen
