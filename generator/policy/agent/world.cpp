#include "generator/policy/agent/world.hpp"

#include <fmt/format.h>

#include "generator/policy/agent/world_checks.hpp"

namespace eagerx::gen {
namespace {

void miss_rate(const PolicyUse& use, Diagnostics& diagnostics) {
  auto& problem = diagnostics.warning(
      "W0116", use.span, fmt::format("the training rate of the policy `{}` is unknown", use.file));
  problem.label = fmt::format("{} Hz here", use.rate_hz.to_string());
  const std::string place = use.is_agent ? "agent: {policy: …" : "policy: {file: …";
  problem.help =
      fmt::format("write the rate of the training: `{}, trained_at: {} Hz}}`, if it is that", place,
                  use.rate_hz.to_string());
}

/// Of a policy that does not fit, it is not asked for.
void check_rate(const PolicyUse& use, const Network& network, bool fits, Diagnostics& diagnostics) {
  const auto& in_file = network.contract.rate_hz;
  const auto said =
      use.trained_at ? std::optional(use.trained_at->value.to_double()) : std::optional<double>();
  if (in_file && said && !same_number(*in_file, *said)) {
    diagnostics
        .error("E0707", use.trained_at->span,
               fmt::format("the policy `{}` was not trained at {:g} Hz: its file says {:g} Hz",
                           use.file, *said, *in_file))
        .help = "leave `trained_at` out";
    return;
  }
  const auto rate = in_file ? in_file : said;
  const double ours = use.rate_hz.to_double();
  if (!rate && fits) miss_rate(use, diagnostics);
  if (!rate) return;
  if (same_number(*rate, ours)) return;
  diagnostics
      .error("E0707", use.span,
             fmt::format("the policy `{}` was trained at {:g} Hz, but the {} runs at {:g} Hz",
                         use.file, *rate, use.is_agent ? "graph" : "node", ours))
      .help = fmt::format("set `rate: {:g}`, and let nodes run faster behind it", *rate);
}

}  // namespace

void check_policy_world(const PolicyUse& use, const Network& network, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  check_policy_actions(use, network, diagnostics);
  check_policy_observations(use, network, diagnostics);
  check_rate(use, network, diagnostics.error_count() == errors_before, diagnostics);
}

}  // namespace eagerx::gen
