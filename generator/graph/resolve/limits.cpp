#include "generator/graph/resolve/limits.hpp"

#include <fmt/format.h>

#include <tuple>

#include "generator/frontend/parameters/requirements.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

void add_port(Facts& facts, const std::string& port, const Space& space) {
  facts[fmt::format("size({})", port)] = static_cast<std::int64_t>(space.size());
  facts[fmt::format("dtype({})", port)] = std::string(to_string(space.dtype));
}

Facts facts_of(const GraphNode& node) {
  Facts facts;
  // Zero is a rate that was refused.
  if (node.rate_hz != Rational()) facts["rate"] = node.rate_hz.to_double();
  for (const auto& input : node.inputs) {
    const std::string port = "inputs." + input.name;
    add_port(facts, port, input.space);
    facts[fmt::format("window({})", port)] = static_cast<std::int64_t>(input.window);
  }
  for (const auto& output : node.outputs) add_port(facts, "outputs." + output.name, output.raw);
  for (const auto& state : node.states) add_port(facts, "states." + state.name, state.received());
  return facts;
}

Facts facts_of(const Processor& processor) {
  Facts facts;
  add_port(facts, "inputs.input", processor.input);
  add_port(facts, "outputs.output", processor.output);
  return facts;
}

bool runs_vectorized(const Entity& entity, const Config& config, Facts facts) {
  if (entity.vectorized.empty()) return false;
  const auto is_vectorized = [](const ConfigValue& value) {
    const auto* const model = std::get_if<std::shared_ptr<const ModelUse>>(&value.value);
    return model == nullptr || *model == nullptr || (*model)->implementation->vectorized;
  };
  if (!ranges::all_of(config, is_vectorized)) return false;
  add_config(facts, config);
  return holds(entity.vectorized, facts).value_or(false);
}

/// The element of `actions.torque[2]`: the stage that compose/ has made of it, whose type and index
/// are at one place.
std::optional<std::int64_t> element_of(const Processor& stage) {
  if (stage.config.size() != 1) return std::nullopt;
  const Span& index = stage.config.front().span;
  if (std::tie(index.file, index.line, index.column) !=
      std::tie(stage.span.file, stage.span.line, stage.span.column))
    return std::nullopt;
  const auto* const indices = std::get_if<std::vector<std::int64_t>>(&stage.config.front().value);
  return indices != nullptr && indices->size() == 1 ? std::optional(indices->front())
                                                    : std::nullopt;
}

/// Whether the message has the element that a connection takes of it.
bool has_element(const Processor& stage, Diagnostics& diagnostics) {
  const auto element = element_of(stage);
  const std::size_t size = stage.input.size();
  if (!element || static_cast<std::size_t>(*element) < size) return true;
  diagnostics
      .error("E0392", stage.span,
             fmt::format("there is no element {}: the message has {}", *element,
                         counted(size, "element")))
      .help =
      size == 1 ? "write `[0]`, or no index" : fmt::format("write `[0]` to `[{}]`", size - 1);
  return false;
}

/// Without the first `known` stages.
void check(const std::optional<Processor>& processor, Diagnostics& diagnostics,
           std::size_t known = 0) {
  if (!processor) return;
  const auto stages = processor->stages();
  for (std::size_t i = known; i < stages.size(); ++i)
    if (has_element(*stages[i], diagnostics))
      check_requirements(*stages[i]->entity, stages[i]->config, facts_of(*stages[i]),
                         stages[i]->span, diagnostics);
}

void check(const GraphNode& node, Diagnostics& diagnostics) {
  if (node.entity != nullptr)
    check_requirements(*node.entity, node.config, facts_of(node), node.span, diagnostics);
  // A sensor's own were checked with the sensor.
  for (const auto& input : node.inputs) check(input.processor, diagnostics, input.of_sensor);
  for (const auto& output : node.outputs) check(output.processor, diagnostics);
  for (const auto& state : node.states) check(state.processor, diagnostics);
  for (const auto& reset_target : node.reset_targets) check(reset_target.processor, diagnostics);
}

void check(const Object& object, Diagnostics& diagnostics) {
  if (object.entity == nullptr) return;
  check_requirements(*object.entity, object.config, Facts{}, object.span, diagnostics);
  for (const auto& state : object.states) {
    check(state.processor, diagnostics);
    if (state.engine_state == nullptr) continue;
    Facts facts;
    add_port(facts, "states.space", state.received());
    check_requirements(*state.engine_state, state.config, std::move(facts), state.span,
                       diagnostics);
  }
}

}  // namespace

bool runs_vectorized(const GraphNode& node) {
  return runs_vectorized(*node.entity, node.config, facts_of(node));
}
bool runs_vectorized(const Processor& processor) {
  return ranges::all_of(processor.stages(), [](const Processor* stage) {
    return runs_vectorized(*stage->entity, stage->config, facts_of(*stage));
  });
}

bool check_limits(const Processor& processor, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  check(std::optional(processor), diagnostics);
  return diagnostics.error_count() == errors_before;
}

void check_limits(UnresolvedGraph& draft) {
  const auto& complete = draft.graph.nodes;
  for (std::size_t n = 0; n < draft.nodes.size(); ++n) {
    // After other problems the ports are not known; what is said of parameters and rates still is.
    check(complete.empty() ? draft.nodes[n].node : complete[n], draft.diagnostics);
  }
  for (const auto& object : draft.graph.objects) check(object, draft.diagnostics);
}

}  // namespace eagerx::gen
