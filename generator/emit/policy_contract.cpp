#include "generator/emit/policy_contract.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/emit/policy_world.hpp"

namespace eagerx::gen {
namespace {

struct Sum {
  std::uint64_t total = 0;
  std::vector<std::string> parts;
  void add(const std::string& name, std::uint64_t size) {
    total += size;
    parts.push_back(fmt::format("{} ({})", name, size));
  }
};

Diagnostic& report(const char* code, const Graph& graph, std::string_view verb,
                   std::uint64_t wanted, const Sum& there, std::string_view what, Span place,
                   Diagnostics& diagnostics) {
  auto& problem = diagnostics.error(
      code, graph.agent.span,
      fmt::format("the policy `{}` {} {} numbers, but the {} of this graph have {}",
                  graph.agent.file, verb, wanted, what, there.total));
  problem.notes.push_back(
      {fmt::format("in the policy's order: {}", fmt::join(there.parts, ", ")), place, ""});
  problem.help = what == "observations"
                     ? "connect the observations that it was trained with, in that order (`agent: "
                       "{policy: …, observations: […]}`), or convert one with a processor"
                     : "connect the actions that it was trained with";
  return problem;
}

/// As many numbers as several observations of one kind have are probably a stack of frames.
void suggest_stack(const Graph& graph, const Network& network, const Sum& observed,
                   Diagnostic& problem) {
  constexpr std::uint64_t kMostFrames = 16;
  if (observed.total == 0 || network.inputs() % observed.total != 0 || observed.parts.size() != 1) {
    return;
  }
  const std::uint64_t frames = network.inputs() / observed.total;
  const auto& input = graph.environment().inputs[graph.agent.observations.front()];
  if (frames < 2 || frames > kMostFrames || input.window != 1) return;
  problem.help += fmt::format(
      "; a stack of the last {} comes from `window: {}` on the connection to "
      "`observations.{}`",
      frames, frames, input.name);
}

bool bounded(const Space& space) {
  return !space.low.empty() && !space.high.empty();
}

}  // namespace

bool check_policy(const Graph& graph, const Network& network, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const GraphNode& environment = graph.environment();
  Sum observed, acted;
  for (const std::size_t i : graph.agent.observations) {
    const Input& input = environment.inputs[i];
    if (input.window == 0) {
      diagnostics.error(
          "E0703", input.span,
          fmt::format(
              "the policy cannot take `observations.{}`: with window 0 it has no fixed size",
              input.name));
      continue;
    }
    observed.add(input.name, input.window * input.space.size());
  }
  for (const auto& action : environment.outputs) {
    acted.add(action.name, action.space.size());
    if (!bounded(action.space)) {
      diagnostics
          .error("E0703", action.span,
                 fmt::format("`actions.{}` has no bounds to scale or clip the policy's output to",
                             action.name))
          .help =
          fmt::format("give them: `actions: {{{}: {{space: {{low: …, high: …}}}}}}`", action.name);
    }
  }
  if (diagnostics.error_count() != errors_before) return false;
  const Span seen = graph.agent.observations.empty()
                        ? graph.span
                        : environment.inputs[graph.agent.observations.front()].span;
  if (observed.total != network.inputs()) {
    suggest_stack(graph, network, observed,
                  report("E0701", graph, "takes", network.inputs(), observed, "observations", seen,
                         diagnostics));
  }
  const bool chooses = graph.agent.output.value_or(to_string(network.action_kind())) == "argmax";
  if (!chooses && acted.total != network.outputs())
    report("E0702", graph, "gives", network.outputs(), acted, "actions",
           environment.outputs.front().span, diagnostics);
  if (diagnostics.error_count() == errors_before) check_policy_world(graph, network, diagnostics);
  return diagnostics.error_count() == errors_before;
}

}  // namespace eagerx::gen
