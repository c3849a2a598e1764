#include "generator/graph/resolve/float_range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace eagerx::gen {
namespace {

/// Whether rounding to float makes it infinite: at half a unit in the last place above the largest
/// float.
bool overflows(double value) {
  return std::isfinite(value) && std::isinf(static_cast<float>(value));
}

bool overflows(const ConfigValue& item) {
  if (!item.given) return false;
  if (const auto* one = std::get_if<double>(&item.value)) return overflows(*one);
  const auto* list = std::get_if<std::vector<double>>(&item.value);
  return list != nullptr && ranges::any_of(*list, [](double v) { return overflows(v); });
}

void check_floats(const Config& config, Diagnostics& diagnostics) {
  for (const ConfigValue& item : config) {
    if (const auto* model = std::get_if<std::shared_ptr<const ModelUse>>(&item.value))
      if (*model != nullptr) check_floats((*model)->config, diagnostics);
    if (!overflows(item)) continue;
    auto& problem = diagnostics.error(
        "E0323", item.span, fmt::format("`{}` is out of range", item.parameter->name.value));
    problem.label = fmt::format("with `real: float` the largest number is {:.3g}",
                                std::numeric_limits<float>::max());
    problem.help = "write a smaller number, or `real: double` in the graph";
  }
}

void check_floats(const std::optional<Processor>& processor, Diagnostics& diagnostics) {
  if (!processor) return;
  for (const Processor* stage : processor->stages()) check_floats(stage->config, diagnostics);
}

void check_floats(const std::vector<State>& states, Diagnostics& diagnostics) {
  for (const State& state : states) {
    check_floats(state.config, diagnostics);
    check_floats(state.processor, diagnostics);
  }
}

}  // namespace

void check_float_range(UnresolvedGraph& draft) {
  if (draft.graph.double_precision) return;
  for (const GraphNode& node : draft.graph.nodes) {
    // Parameters of engine nodes come from the object's, which are checked below.
    if (node.role != NodeRole::engine_node) check_floats(node.config, draft.diagnostics);
    for (const Input& input : node.inputs) check_floats(input.processor, draft.diagnostics);
    for (const Output& output : node.outputs) check_floats(output.processor, draft.diagnostics);
    check_floats(node.states, draft.diagnostics);
  }
  for (const Object& object : draft.graph.objects) {
    check_floats(object.config, draft.diagnostics);
    check_floats(object.states, draft.diagnostics);
  }
}

}  // namespace eagerx::gen
