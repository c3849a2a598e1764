// Checks actions against the ranges of their actuators.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/analysis/plausibility/plausibility.hpp"

namespace eagerx::gen {
namespace {

/// A bound of an element as a message can hold it.
double bound(const Space& space, const std::vector<double>& bounds, std::size_t element,
             double otherwise) {
  if (bounds.empty()) return otherwise;
  const double value = bounds[bounds.size() == 1 ? 0 : element];
  return space.dtype == Dtype::float32 ? static_cast<double>(static_cast<float>(value)) : value;
}

/// The range of an element, in words: "-2 to 2".
std::string range(const Space& space, std::size_t element) {
  const auto text = [&](const std::vector<double>& bounds) {
    const double value = bounds[bounds.size() == 1 ? 0 : element];
    return space.dtype == Dtype::float32 ? fmt::format("{}", static_cast<float>(value))
                                         : fmt::format("{}", value);
  };
  if (space.low.empty() && space.high.empty()) return "any number";
  if (space.high.empty()) return "at least " + text(space.low);
  if (space.low.empty()) return "at most " + text(space.high);
  return text(space.low) + " to " + text(space.high);
}

/// The first element that may leave the actuator's space.
std::optional<std::size_t> first_outside(const Space& action, const Space& actuator) {
  if (actuator.low.empty() && actuator.high.empty()) return std::nullopt;
  const double lowest = lowest_of(action.dtype), highest = highest_of(action.dtype);
  for (std::size_t i = 0; i < action.size(); ++i) {
    const bool below =
        bound(action, action.low, i, lowest) < bound(actuator, actuator.low, i, lowest);
    const bool above =
        bound(action, action.high, i, highest) > bound(actuator, actuator.high, i, highest);
    if (below || above) return i;
  }
  return std::nullopt;
}

void check(const Output& action, const Input& input, Diagnostics& diagnostics) {
  const Space& actuator = *input.actuator_space;
  const auto element = first_outside(action.space, actuator);
  if (!element) return;
  const std::string which = action.space.size() == 1 ? "" : fmt::format("element {} of ", *element);
  auto& problem = diagnostics.warning(
      "W0101", action.span,
      fmt::format("{}`actions.{}` may be {}, but `{}` takes {}", which, action.name,
                  range(action.space, *element), input.written, range(actuator, *element)));
  problem.label = "values outside are clipped and counted";
  problem.notes.push_back({"connected here", input.span, ""});
  problem.help = fmt::format(
      "write `actions: {{{}: {{space: {{like: {}}}}}}}`, or convert it with a processor",
      action.name, input.written);
}

}  // namespace

void check_actions(const CheckedGraph& checked, Diagnostics& diagnostics) {
  for (const auto& node : checked.graph.nodes) {
    for (const auto& input : node.inputs) {
      if (!input.actuator_space || input.source_node != Graph::kEnvironment) continue;
      check(checked.graph.environment().outputs[input.source_output], input, diagnostics);
    }
  }
}

}  // namespace eagerx::gen
