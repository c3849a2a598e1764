#include "generator/driver/commands/check_targets.hpp"

#include <set>
#include <utility>

#include "generator/analysis/info/info.hpp"
#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/backend/emit/emit.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/pipeline/check_variants.hpp"
#include "generator/graph/cut/cut.hpp"

namespace eagerx::gen {
namespace {

/// Checks the figures of the plan. `size` checks those of an image.
void check_budget(Run& run) {
  const auto& budget = run.spec->budget;
  if (budget && budget->is_of_plan())
    check_plan_budget(info_of(*run.plan, budget, run.diagnostics), *budget, run.diagnostics);
}

/// Whether the graph is as it is written: what is said of another variant says little of it.
bool is_as_written(const GraphOptions& options) {
  return options.engine.empty() && options.real.empty() && options.split.empty() &&
         options.of.empty() && options.targets.empty() && !options.engine_rate_hz &&
         !options.rate_hz;
}

std::set<std::string> names_in(const Graph& graph) {
  std::set<std::string> names;
  for (const auto& node : graph.nodes) names.insert(node.name);
  return names;
}

/// Everything besides the graph itself, for these targets.
void check_graph(Run& run, const std::vector<const Target*>& targets, const std::string& output) {
  check_budget(run);
  check_headers(*run.plan, output, run.diagnostics);
  // Errors first: they may be why something looks odd.
  if (!run.diagnostics.has_errors())
    check_plausibility({*run.spec, *run.graph, *run.plan, targets}, run.diagnostics);
}

/// Replaces a graph without problems by the nodes of `--of`; false if that is not possible.
bool cut_graph(Run& run, const GraphOptions& options, const std::string& output) {
  check_graph(run, {}, output);
  if (run.diagnostics.has_errors()) return false;
  auto graph =
      cut_out(*run.graph, {options.of, run.composites, run.safety_of_cut}, run.diagnostics);
  if (!graph) return false;
  const std::set<std::string> inside = names_in(*graph);
  std::erase_if(run.policies.nodes, [&](const NodeNetwork& policy) {
    return !inside.contains(run.spec->nodes[policy.spec].name.value);
  });
  run.policies.agent.reset();
  run.graph = std::move(graph);
  run.plan = make_plan(*run.graph, run.diagnostics);
  if (run.plan) check_safe_outputs(*run.graph, run.diagnostics);
  return run.plan.has_value();
}

}  // namespace

std::optional<std::vector<const Target*>> check_targets(Run& run, const GraphOptions& options,
                                                        const std::string& output) {
  const bool cut = !options.of.empty();
  if (cut && !cut_graph(run, options, output)) return std::nullopt;
  auto targets = find_targets(run, options);
  if (!cut) check_graph(run, targets, output);
  const bool complete = !run.diagnostics.has_errors() && is_as_written(options);
  allow_warnings(run.spec->allow, complete, run.diagnostics);
  if (options.warnings_as_errors) run.diagnostics.raise_warnings();
  return run.diagnostics.has_errors() ? std::nullopt : std::optional(std::move(targets));
}

bool check_text(Run& run, const GraphOptions& options, const std::string& text) {
  if (!make_of_text(run, options, text) || !check_targets(run, options)) return false;
  if (options.variant.empty()) check_variants(run, options);
  return !run.diagnostics.has_errors();
}

}  // namespace eagerx::gen
