#include "generator/policy/agent/weights.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

#include "generator/policy/agent/world_checks.hpp"
#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/int8.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Rounds the weights if the graph wants them in eight bits, and says what that costs. E0709.
void round_weights(Network& network, const AgentSpec& policy, const GoldenRows* rows,
                   Diagnostics& diagnostics) {
  const bool int8 = policy.weights && policy.weights->value == "int8";
  if (policy.max_error && !int8) {
    diagnostics.error("E0206", policy.max_error->span, "`max_error` needs `weights: int8`");
  }
  if (!int8) return;
  Network rounded = with_int8_weights(network);
  const RoundingError error = rounding_error(network, rounded, rows);
  network = std::move(rounded);
  if (policy.max_error && !(error.largest <= policy.max_error->value)) {
    diagnostics
        .error("E0709", policy.max_error->span,
               fmt::format("with weights of eight bits the policy `{}` is farther off than {:g}",
                           network.file, policy.max_error->value))
        .help = fmt::format("its error against float32: {}", to_string(error));
    return;
  }
  diagnostics.note(
      policy.weights->span,
      fmt::format("weights of eight bits, error against float32: {}", to_string(error)));
}

/// Contradictions of `network` and the graph to actions from -1 to 1. E0704, E0705.
bool check_normalized_actions(const Network& network, const AgentSpec& policy,
                              Diagnostics& diagnostics) {
  const Span span = policy.normalize_actions->span;
  if (policy.output) {
    diagnostics
        .error(
            "E0704", policy.output->span,
            "`output` and `normalize_actions` both define how the policy's outputs are converted")
        .help = "leave `output` out: from -1 to 1 all of them mean the same";
    return false;
  }
  if (network.action && is_choice(*network.action)) {
    diagnostics
        .error("E0704", span,
               fmt::format("the policy `{}` chooses whole numbers, which `normalize_actions` does "
                           "not scale",
                           network.file))
        .help = "leave `normalize_actions` out";
    return false;
  }
  const PolicyContract& contract = network.contract;
  for (std::size_t i = 0; i < network.outputs(); ++i) {
    const double low = bound_of(contract.action_low, i, network.outputs()).value_or(-1.0);
    const double high = bound_of(contract.action_high, i, network.outputs()).value_or(1.0);
    if (low == -1.0 && high == 1.0) continue;
    diagnostics
        .error("E0705", span,
               fmt::format("the policy `{}` was trained with actions from {:g} to {:g}, not from "
                           "-1 to 1",
                           network.file, low, high))
        .help = "leave `normalize_actions` out";
    return false;
  }
  return true;
}

/// Actions of the training were from -1 to 1, as squashed ones are: the others are clipped first.
void normalize_actions(Network& network) {
  const std::uint32_t count = network.outputs();
  if (network.action_kind() != ActionKind::squashed) {
    using Operation = Elementwise::Operation;
    network.layers.push_back(layer_of(Elementwise{Operation::at_least}, count, count, {-1.0F}));
    network.layers.push_back(layer_of(Elementwise{Operation::at_most}, count, count, {1.0F}));
  }
  network.action = ActionKind::squashed;
  network.contract.action_low.clear();
  network.contract.action_high.clear();
}

/// Checks the policy against the rows that the graph names, and gives the program some to check.
void add_known_answers(Network& network, const AgentSpec& policy, const fs::path& folder,
                       Diagnostics& diagnostics) {
  const auto& golden = policy.golden;
  const bool normalizes = policy.normalize_actions && policy.normalize_actions->value &&
                          check_normalized_actions(network, policy, diagnostics);
  if (!golden) {
    if (normalizes) normalize_actions(network);
    network.self_test = self_test_rows(network, nullptr);
    return round_weights(network, policy, nullptr, diagnostics);
  }
  const std::string path = (folder / golden->value).string();
  const auto rows = read_golden(path, golden->value, golden->span, diagnostics);
  if (!rows || !check_normalized(network, *rows, golden->value, golden->span, diagnostics)) {
    return;
  }
  if (compare(network, *rows, golden->value, golden->span, diagnostics)) {
    if (normalizes) normalize_actions(network);
    network.self_test = self_test_rows(network, &*rows);
    round_weights(network, policy, &*rows, diagnostics);
  }
}

}  // namespace

std::optional<Network> read_weights(const AgentSpec& policy, const std::string& graph_file,
                                    Diagnostics& diagnostics) {
  const fs::path folder = fs::path(graph_file).parent_path();
  PolicyRequest request;
  request.path = (folder / policy.file.value).string();
  request.name = policy.file.value;
  request.span = policy.file.span;
  if (policy.normalize) {
    request.normalize_path = (folder / policy.normalize->value).string();
    request.normalize_name = policy.normalize->value;
    request.normalize_span = policy.normalize->span;
  }
  ReadContext& said = request.context;
  if (policy.activation) said.activation = activation_of(policy.activation->value);
  if (policy.output_activation) {
    said.output_activation = activation_of(policy.output_activation->value);
  }
  said.state_dependent_std = policy.state_dependent_std && policy.state_dependent_std->value;
  if (policy.actor) said.actor = policy.actor->value;
  for (const auto& layer : policy.layers) said.layers.push_back(layer.value);
  for (const auto& size : policy.input_sizes) said.input_sizes.push_back(size.value);
  said.has_answers = policy.golden.has_value();
  if (policy.output_name) said.output_name = policy.output_name->value;
  auto network = read_policy(request, diagnostics);
  if (!network) return network;
  for (const auto& what : network->assumed) {
    diagnostics.note(policy.file.span, fmt::format("`{}` does not say it, so this is assumed: {}",
                                                   policy.file.value, what));
  }
  if (policy.profile && policy.profile->value == "fast") network->profile = Profile::fast;
  add_known_answers(*network, policy, folder, diagnostics);
  return network;
}

}  // namespace eagerx::gen
