// eagerx-gen diff: differences in the meaning of two graphs.
#include "generator/analysis/compare/compare.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {
namespace {

struct DiffOptions : GraphOptions {
  std::string second_graph, second_variant;  // the graph empty: the same file
};

std::optional<GraphFacts> facts_of_graph(const GraphOptions& options) {
  Run run;
  if (!make(run, options)) {
    finish(run, options);
    return std::nullopt;
  }
  return facts_of(info_of(*run.plan, run.spec->budget, run.diagnostics));
}

int perform(const DiffOptions& options) {
  GraphOptions other = options;
  other.variant = options.second_variant;
  if (!options.second_graph.empty()) other.graph = options.second_graph;
  const auto first = facts_of_graph(options);
  const auto second = facts_of_graph(other);
  if (!first || !second) return kWrongUsage;
  const std::string text = differences(*first, *second);
  say("{}", text);
  return text.empty() ? kDone : kProblems;
}

Command table(DiffOptions& options) {
  return {.name = "diff",
          .about =
              "compare two graphs, or two variants of one: exit code 0 if they are equal, 1 if "
              "they differ, 2 if one has errors",
          .examples = {{"two files", "eagerx-gen diff robot.yaml other.yaml"},
                       {"two variants", "eagerx-gen diff robot.yaml --variant sim --to real"}},
          .arguments = joined(
              {{graph(options),
                reads(text("second", options.second_graph,
                           "the graph to compare with (default: the same file)", "OTHER.yaml")),
                text("--variant", options.variant, "variant of the first graph", "NAME"),
                text("--to", options.second_variant, "variant of the second graph", "NAME"),
                library(options)},
               diagnostics(options)}),
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command diff_command() {
  return with_options<DiffOptions>(table);
}

}  // namespace eagerx::gen
