#include "generator/policy/agent/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/policy/agent/world.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

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

Diagnostic& report(const char* code, const PolicyUse& use, bool takes, std::uint64_t wanted,
                   const Sum& there, Span place, Diagnostics& diagnostics) {
  auto& problem = diagnostics.error(
      code, use.span,
      fmt::format("the policy `{}` {} {} numbers, but the {} have {}", use.file,
                  takes ? "takes" : "gives", wanted, takes ? use.takes : use.gives, there.total));
  problem.notes.push_back(
      {fmt::format("in the policy's order: {}", join(there.parts, ", ")), place, ""});
  if (!use.is_agent) {
    problem.help = takes ? "connect what it was trained with, in the order of `inputs: […]`"
                         : "give the outputs the shapes that it was trained with";
    return problem;
  }
  problem.help = takes
                     ? "connect the observations that it was trained with, in that order (`agent: "
                       "{policy: …, observations: […]}`), or convert one with a processor"
                     : "connect the actions that it was trained with";
  return problem;
}

bool has_processor(const Input* input) {
  return input->processor && input->processor->stages().size() > input->of_sensor;
}

/// The wrong one is the observation that the training knows with another size, or the only one with
/// a processor: its connection is marked.
void mark_connection(const PolicyUse& use, const Network& network, const Sum& observed,
                     Diagnostic& problem) {
  const auto numbers = [](const Input* input) { return input->window * input->space.size(); };
  const Input* wrong = nullptr;
  std::uint64_t wanted = 0;
  for (const NamedPart& part : network.contract.observations) {
    const auto found = ranges::find(use.inputs, part.name, &Input::name);
    if (found == use.inputs.end() || numbers(*found) == part.size) continue;
    if (wrong != nullptr) return;
    wrong = *found;
    wanted = part.size;
  }
  if (wrong == nullptr && std::ranges::count_if(use.inputs, has_processor) == 1) {
    wrong = *ranges::find_if(use.inputs, has_processor);
    if (network.inputs() + numbers(wrong) <= observed.total) return;  // it is not this one alone
    wanted = network.inputs() + numbers(wrong) - observed.total;
  }
  if (wrong == nullptr) return;
  problem.notes.insert(problem.notes.begin(), {"the policy", problem.span, ""});
  problem.span = has_processor(wrong) ? wrong->processor->span : wrong->span;
  problem.label = fmt::format("gives {}, where {} would fit", numbers(wrong), wanted);
  problem.help = fmt::format("{} that `{}{}` had in the training",
                             has_processor(wrong) ? "write the processor" : "add the processor",
                             use.in, wrong->name);
}

/// As many numbers as several observations of one kind have are probably a stack of frames.
void suggest_stack(const PolicyUse& use, const Network& network, const Sum& observed,
                   Diagnostic& problem) {
  constexpr std::uint64_t kMostFrames = 16;
  if (observed.total == 0 || network.inputs() % observed.total != 0 || observed.parts.size() != 1) {
    return;
  }
  const std::uint64_t frames = network.inputs() / observed.total;
  const Input& input = *use.inputs.front();
  if (frames < 2 || frames > kMostFrames || input.window != 1) return;
  problem.help += fmt::format(
      "; a stack of the last {} comes from `window: {}` on the connection to "
      "`{}{}`",
      frames, frames, use.in, input.name);
}

void report_unbounded(const PolicyUse& use, const Output& output, Diagnostics& diagnostics) {
  diagnostics
      .error("E0703", output.span,
             fmt::format("`{}{}` has no bounds to scale or clip the policy's output to", use.out,
                         output.name))
      .help = fmt::format("give them: `{}: {{{}: {{space: {{low: …, high: …}}}}}}`",
                          use.is_agent ? "actions" : "outputs", output.name);
}

bool bounded(const Space& space) {
  return !space.low.empty() && !space.high.empty();
}

/// Twice as many numbers are probably means and deviations, as of rsl_rl's `state_dependent_std`.
void suggest_means(const Network& network, const Sum& given, Diagnostic& problem) {
  if (given.total == 0 || network.outputs() != 2 * given.total) return;
  problem.help +=
      "; if the second half are deviations, as rsl_rl's, say `state_dependent_std: true` with "
      "the policy";
}

}  // namespace

bool check_policy(const PolicyUse& use, const Network& network, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  Sum taken, given;
  for (const Input* input : use.inputs) {
    if (input->window == 0) {
      diagnostics.error(
          "E0703", input->span,
          fmt::format("the policy cannot take `{}{}`: with window 0 it has no fixed size", use.in,
                      input->name));
      continue;
    }
    taken.add(input->name, input->window * input->space.size());
  }
  for (const Output* output : use.outputs) {
    given.add(output->name, output->raw.size());
    if (!bounded(output->raw)) report_unbounded(use, *output, diagnostics);
  }
  if (diagnostics.error_count() != errors_before) return false;
  if (taken.total != network.inputs()) {
    auto& problem = report("E0701", use, true, network.inputs(), taken, use.place, diagnostics);
    suggest_stack(use, network, taken, problem);
    mark_connection(use, network, taken, problem);
  }
  if (use.kind(network) != ActionKind::argmax && given.total != network.outputs()) {
    auto& problem = report("E0702", use, false, network.outputs(), given, use.outputs.front()->span,
                           diagnostics);
    suggest_means(network, given, problem);
  }
  if (diagnostics.error_count() == errors_before) check_policy_world(use, network, diagnostics);
  return diagnostics.error_count() == errors_before;
}

}  // namespace eagerx::gen
