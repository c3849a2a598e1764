// Safe outputs of a graph without an engine, and keys of `safety:` that do nothing.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

void report_idle(Span span, std::string_view key, std::string_view why, Diagnostics& diagnostics) {
  diagnostics.warning("W0109", span, fmt::format("`{}` does nothing: {}", key, why)).help =
      "leave it out";
}

/// Zero, moved into its space: one number, or a list where the elements differ.
std::string zero_within(const Space& space) {
  const auto bound = [](const std::vector<double>& bounds, std::size_t i, double without) {
    return bounds.empty() ? without : bounds[std::min(i, bounds.size() - 1)];
  };
  std::vector<std::string> numbers;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::max(space.low.size(), space.high.size()); ++i) {
    const double least = bound(space.low, i, -kInfinity), most = bound(space.high, i, kInfinity);
    const double value = std::max(least, std::min(0.0, most));
    numbers.push_back(value == 0.0 ? "0.0" : fmt::format("{}", value));
  }
  if (numbers.empty()) return "0.0";
  const bool is_one = ranges::all_of(numbers, [&](const auto& x) { return x == numbers.front(); });
  return is_one ? numbers.front() : fmt::format("[{}]", join(numbers, ", "));
}

void check_idle_keys(const CheckedGraph& checked, Diagnostics& diagnostics) {
  if (!checked.spec.safety) return;
  const SafetySpec& safety = *checked.spec.safety;
  const Setting* const nodes = find_named(safety.settings, "nodes");
  if (checked.spec.has_engine()) {
    constexpr const char* kAgent = "this graph has an engine, so its observations go to the agent";
    if (safety.outputs_span) report_idle(*safety.outputs_span, "outputs", kAgent, diagnostics);
    if (nodes != nullptr) report_idle(nodes->span, "nodes", kAgent, diagnostics);
    for (const Setting& frozen : safety.frozen)
      report_idle(frozen.span, "frozen." + frozen.name, kAgent, diagnostics);
    return;
  }
  if (checked.graph.safety.outputs.empty()) {
    constexpr const char* kNone = "this graph has no safe outputs";
    if (nodes != nullptr) report_idle(nodes->span, "nodes", kNone, diagnostics);
    for (const Setting& frozen : safety.frozen)
      report_idle(frozen.span, "frozen." + frozen.name, kNone, diagnostics);
    return;
  }
  for (const Setting& action : safety.actions) {
    report_idle(action.span, "actions." + action.name,
                "without an engine, actions are measurements, and `outputs` take over",
                diagnostics);
  }
}

}  // namespace

void check_outputs(const CheckedGraph& checked, Diagnostics& diagnostics) {
  check_idle_keys(checked, diagnostics);
  check_safe_outputs(checked.graph, diagnostics);
}

void check_safe_outputs(const Graph& graph, Diagnostics& diagnostics) {
  const Safety& safety = graph.safety;
  if (safety.undeclared.empty()) return;
  std::vector<std::string> names, values, many;
  for (const std::size_t i : safety.undeclared) {
    const Input& input = graph.environment().inputs[i];
    names.push_back("`" + input.written + "`");
    if (input.window != 1) many.push_back("`" + input.written + "`");
    values.push_back(input.name + ": " + (input.window == 1 ? zero_within(input.space) : "none"));
  }
  const Input& first = graph.environment().inputs[safety.undeclared.front()];
  auto& problem = diagnostics.warning(
      "W0111", first.span,
      fmt::format("nothing says what {} {} while a measurement is missing or wrong",
                  join(names, ", "), names.size() == 1 ? "is" : "are"));
  problem.label = many.empty()
                      ? "zero, moved into its space"
                      : fmt::format("{} would leave as the nodes made it", join(many, ", "));
  problem.help = fmt::format(
      "write `safety: {{outputs: {{{}}}}}` with values that are safe, or {} if nothing acts on "
      "what "
      "leaves",
      join(values, ", "), graph.cut ? "`none` instead of a value" : "`outputs: none`");
}

}  // namespace eagerx::gen
