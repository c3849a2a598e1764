#include "generator/cli/pipeline.hpp"
#include "generator/compare/compare.hpp"

namespace eagerx::gen {
namespace {

std::optional<GraphFacts> facts_of_graph(const Options& options) {
  Run run;
  if (!make(run, options)) {
    finish(run, options);
    return std::nullopt;
  }
  return facts_of(info_of(*run.plan, run.spec->budget, run.diagnostics));
}

}  // namespace

int diff_command(const Options& options) {
  Options other = options;
  other.variant = options.second_variant;
  if (!options.second_graph.empty()) other.graph = options.second_graph;
  const auto first = facts_of_graph(options);
  const auto second = facts_of_graph(other);
  if (!first || !second) return kWrongUsage;
  const std::string text = differences(*first, *second);
  say("{}", text);
  return text.empty() ? kDone : kProblems;
}

}  // namespace eagerx::gen
