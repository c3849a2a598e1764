// eagerx-gen policy: shows the contents of a weight file, and tests its answers.
#include <fmt/format.h>

#include <limits>

#include "generator/driver/commands/policy_file.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/policy/formats/golden.hpp"
#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/int8.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// In a network with branches: ", of the observation", ", of layers 2, 5".
std::string sources_of(const Network& network, std::size_t i) {
  if (network.is_chain()) return "";
  std::vector<std::string> names;
  for (const std::int32_t value : network.taken_by(i)) {
    names.push_back(value < 0 ? "the observation" : fmt::format("layer {}", value + 1));
  }
  return fmt::format(", of {}", join(names, ", "));
}

void print_layers(const Network& network) {
  LayerCost sum;
  std::size_t remembered = 0;
  std::size_t int8 = 0;
  say("layers\n");
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    const Layer& layer = network.layers[i];
    const LayerCost cost = cost_of(layer);
    sum.parameters += cost.parameters;
    sum.bytes += cost.bytes;
    sum.multiply_adds += cost.multiply_adds;
    remembered += layer.remembers();
    int8 += int8_bytes(layer);
    const bool plain = layer.is_dense() && layer.activation == Activation::identity && !layer.norm;
    say("  {}{} -> {}{}{}\n", network.is_chain() ? "" : fmt::format("{:<3} ", i + 1), layer.inputs,
        layer.outputs, plain ? "" : note_of(layer), sources_of(network, i));
  }
  say("parameters     {}\n", sum.parameters);
  say("flash          {} bytes, {} with `weights: int8`\n", sum.bytes, int8);
  say("multiply-adds  {}\n", sum.multiply_adds);
  if (remembered > 0) say("memory         {} bytes\n", remembered * sizeof(float));
}

std::string list_of(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(fmt::format("{:g}", value));
  return fmt::format("[{}]", join(texts, ", "));
}

void print_contract(const Network& network) {
  const PolicyContract& contract = network.contract;
  say("contract\n");
  if (!contract.algorithm.empty()) say("  trained by     {}\n", contract.algorithm);
  std::vector<std::string> parts;
  for (const auto& part : contract.observations) {
    parts.push_back(part.size == 1 ? part.name : fmt::format("{} ({})", part.name, part.size));
  }
  say("  observations   {}{}\n", network.inputs(),
      parts.empty() ? ", names not in the file" : fmt::format(": {}", join(parts, ", ")));
  if (const auto& statistics = network.normalization) {
    const bool clips = statistics->clip < std::numeric_limits<double>::max();
    const std::string value = fmt::format("(x - mean) / sqrt(var + {:g})", statistics->epsilon);
    say("  normalised     {}, from {}\n",
        clips ? fmt::format("clip({}, -{:g}, {:g})", value, statistics->clip, statistics->clip)
              : value,
        statistics->source);
    say("                 mean {}, var {}\n", list_of(statistics->mean),
        list_of(statistics->variance));
  } else {
    say("  normalised     by nothing but its own layers (give statistics with --normalize)\n");
  }
  const ActionKind kind = network.action_kind();
  const std::string bounds =
      contract.action_low.empty()
          ? "the graph's bounds"
          : fmt::format("{} … {}", list_of(contract.action_low), list_of(contract.action_high));
  switch (kind) {
    case ActionKind::squashed:
      say("  action         {}, from -1…1 to {}\n", network.outputs(), bounds);
      break;
    case ActionKind::raw:
      say("  action         {}, clipped to {}\n", network.outputs(), bounds);
      break;
    case ActionKind::argmax:
      if (contract.groups.size() > 1) {
        std::vector<std::int64_t> firsts = contract.first_choices;
        if (firsts.empty()) firsts = {0};
        say("  action         {} choices: of {} outputs the index of the largest, from {} on\n",
            contract.groups.size(), join(contract.groups, ", "), join(firsts, ", "));
        break;
      }
      say("  action         the index of the largest of {} outputs, from {} on\n",
          network.outputs(), contract.first_choice());
      break;
    case ActionKind::binary:
      say("  action         {}, 1 where an output is above 0, else 0\n", network.outputs());
      break;
  }
  say("  rate           {}\n",
      contract.rate_hz ? fmt::format("{:g} Hz", *contract.rate_hz) : "not in the file");
}

struct PolicyTestOptions : PolicyOptions {
  std::string golden;
};

int test(Run& run, const PolicyTestOptions& options, const Network& network) {
  const auto rows = read_golden(options.golden, options.golden, {}, run.diagnostics);
  const auto result =
      rows ? compare(network, *rows, options.golden, {}, run.diagnostics) : std::nullopt;
  if (!result) return finish(run, options);
  say("{} against {}: {}\n", options.policy.file, options.golden, counted(result->rows, "row"));
  if (!network.normalization && !rows->normalized.empty()) {
    say("normalised     taken from the rows, because there is no `--normalize`\n");
  }
  const GoldenErrors& outputs = result->outputs;
  say("largest error  {:.3g} (against float64)\n", outputs.ours);
  if (result->has_outputs) {
    say("file's own     {:.3g}; in row {} at most {:.3g} is allowed\n", outputs.theirs,
        outputs.worst + 1, outputs.limit);
  } else {
    say("file's own     not compared: the file has no outputs\n");
  }
  say("with int8      off by {}\n",
      to_string(rounding_error(network, with_int8_weights(network), &*rows)));
  if (result->actions) {
    say("actions        {:.3g} off; in row {} at most {:.3g} is allowed\n", result->actions->off,
        result->actions->worst + 1, result->actions->limit);
  } else if (!rows->actions.empty()) {
    say("actions        not compared: the file does not say their bounds\n");
  }
  return finish(run, options);
}

int perform(const PolicyTestOptions& options) {
  Run run;
  const auto network = read_policy_file(options.policy, run.diagnostics, true);
  return network ? test(run, options, *network) : finish(run, options);
}

int perform(const PolicyOptions& options) {
  Run run;
  const auto network = read_policy_file(options.policy, run.diagnostics);
  if (!network) return finish(run, options);
  say("{}: {}\n", options.policy.file, network->format);
  print_layers(*network);
  say("with int8      off by {}\n",
      to_string(rounding_error(*network, with_int8_weights(*network), nullptr)));
  print_contract(*network);
  for (const std::string& part : network->assumed) say("assumed        {}\n", part);
  if (!network->ignored.empty()) say("not used\n");
  for (const std::string& part : network->ignored) say("  {}\n", part);
  return finish(run, options);
}

Command table(PolicyOptions& options) {
  return {.name = "info",
          .about = "print layers, size, inputs and outputs of a policy",
          .examples = {{"an ONNX file", "eagerx-gen policy info swing_up.onnx"},
                       {"a model of Stable-Baselines3 with its statistics",
                        "eagerx-gen policy info sac.zip --normalize vec_normalize.pkl"}},
          .arguments = one_policy(options),
          .run = [&options] { return perform(options); }};
}

Command table(PolicyTestOptions& options) {
  return {
      .name = "test",
      .about = "compare the answers of a policy with known answers",
      .examples = {{"rows of a CSV file", "eagerx-gen policy test swing_up.onnx answers.csv"}},
      .arguments = joined(
          {one_policy(options),
           {required(reads(text("golden", options.golden, "table of observations and known answers",
                                "GOLDEN.csv|npz")))}}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command policy_info_command() {
  return with_options<PolicyOptions>(table);
}

Command policy_test_command() {
  return with_options<PolicyTestOptions>(table);
}

}  // namespace eagerx::gen
