// eagerx-gen policy compare: differences between the answers of two policies.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "generator/driver/commands/policy_file.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/difference.hpp"
#include "generator/policy/network/int8.hpp"
#include "generator/policy/network/observations.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostShown = 32;

/// Numbers of a vector, not more than a screen has.
std::string shown(const std::vector<double>& values) {
  const std::size_t count = std::min(values.size(), kMostShown);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) texts.push_back(fmt::format("{:.6g}", values[i]));
  return fmt::format("[{}{}]", join(texts, ", "), count < values.size() ? ", …" : "");
}

std::string row_of(const GoldenRows& rows, std::size_t row) {
  std::size_t start = row;
  while (!starts_episode(rows, start)) --start;
  if (rows.starts.empty()) return fmt::format("row {}", row + 1);
  return fmt::format("row {}, step {} of its episode", row + 1, row - start);
}

void print_outputs(const PolicyDifference& result) {
  say("output   largest     mean        range       allowed     in row\n");
  for (std::size_t i = 0; i < std::min(result.outputs.size(), kMostShown); ++i) {
    const OutputDifference& output = result.outputs[i];
    say("  {:<6} {:<11.3g} {:<11.3g} {:<11.3g} {:<11.3g} {}\n", i, output.largest, output.mean,
        output.range, output.allowed, output.row + 1);
  }
  if (result.outputs.size() > kMostShown) {
    say("  …      {} more: `--json` has all\n", result.outputs.size() - kMostShown);
  }
}

void print_layers(const Network& network, const PolicyDifference& result) {
  if (result.layers.empty()) {
    say("layers         not compared: {}\n", result.layers_differ);
    return;
  }
  say("layer    weights     largest     mean        in row\n");
  for (std::size_t i = 0; i < result.layers.size(); ++i) {
    const Layer& layer = network.layers[i];
    const LayerDifference& difference = result.layers[i];
    say("  {:<6} {:<11.3g} {:<11.3g} {:<11.3g} {:<6} {} -> {}{}\n", i + 1, difference.weights,
        difference.largest, difference.mean, difference.row + 1, layer.inputs, layer.outputs,
        note_of(layer));
  }
}

void print(const Network& a, const Network& b, const AskedRows& asked,
           const PolicyDifference& result) {
  say("first          {}: {}\n", a.file, a.format);
  say("second         {}: {}\n", b.file, b.format);
  say("observations   {}\n", asked.origin);
  print_outputs(result);
  const OutputDifference& worst = result.outputs[result.worst];
  if (worst.largest > 0.0) {
    say("farthest off   output {} in {}\n", result.worst, row_of(asked.rows, worst.row));
    say("  observation  {}\n", shown(result.observation));
    say("  first        {}\n", shown(result.first));
    say("  second       {}\n", shown(result.second));
  }
  if (result.actions) say("actions        at most {:.3g} off\n", *result.actions);
  if (result.choices) say("choices        another one in {}\n", counted(*result.choices, "row"));
  if (a.action_kind() != b.action_kind()) {
    say("actions        not compared: outputs are {} in the first, {} in the second\n",
        to_string(a.action_kind()), to_string(b.action_kind()));
  }
  print_layers(a, result);
}

Json json_of(const Difference& difference) {
  return {{"largest", difference.largest}, {"mean", difference.mean}, {"row", difference.row}};
}

Json json_list(const std::vector<double>& values) {
  Json list = Json::list();
  for (const double value : values) list.push_back(value);
  return list;
}

Json json_of(const Network& a, const Network& b, const AskedRows& asked,
             const PolicyDifference& result) {
  Json json = Json::object();
  json["first"] = a.file;
  json["second"] = b.file;
  json["observations"] = asked.origin;
  json["rows"] = result.rows;
  json["within"] = result.within();
  json["outputs"] = Json::list();
  for (const OutputDifference& output : result.outputs) {
    Json item = json_of(output);
    item["range"] = output.range;
    item["allowed"] = output.allowed;
    json["outputs"].push_back(std::move(item));
  }
  json["farthest"] = Json{{"output", result.worst},
                          {"row", result.outputs[result.worst].row},
                          {"observation", json_list(result.observation)},
                          {"first", json_list(result.first)},
                          {"second", json_list(result.second)}};
  if (result.actions) json["actions"] = *result.actions;
  if (result.choices) json["choices"] = *result.choices;
  if (result.layers.empty()) json["layers_differ"] = result.layers_differ;
  json["layers"] = Json::list();
  for (const LayerDifference& layer : result.layers) {
    Json item = json_of(layer);
    item["weights"] = layer.weights;
    json["layers"].push_back(std::move(item));
  }
  return json;
}

struct PolicyCompareOptions : PolicyOptions {
  PolicyFile second_policy;
  AskedOptions asked;
  std::optional<double> tolerance;
  bool int8 = false, json_output = false, said_too_often = false;
};

int perform(const PolicyCompareOptions& options) {
  Run run;
  auto a = read_policy_file(options.policy, run.diagnostics);
  const bool itself = options.second_policy.file.empty();
  auto b = itself ? a : read_policy_file(options.second_policy, run.diagnostics);
  if (!a || !b) return finish(run, options);
  if (options.int8) {
    b = with_int8_weights(std::move(*b));
    b->file += " with weights of eight bits";
  }
  // Before rows of one are found not to fit the other.
  if (!check_sizes(*a, *b, run.diagnostics)) return finish(run, options);
  // A policy with memory needs sequences of observations; statistics and bounds say where to
  // sample.
  const bool by_second = b->has_memory() && !a->has_memory();
  const auto asked = asked_rows(by_second ? *b : *a, options.asked, run.diagnostics);
  if (!asked || !check_work(*b, asked->rows.observations.size(), run.diagnostics)) {
    return finish(run, options);
  }
  const auto result = difference_of(*a, *b, asked->rows, options.tolerance, run.diagnostics);
  if (!result) return finish(run, options);
  if (options.json_output) {
    say_text(dump_json(json_of(*a, *b, *asked, *result)) + "\n");
  } else {
    print(*a, *b, *asked, *result);
  }
  if (!result->within()) {
    const OutputDifference& worst = result->outputs[result->worst];
    run.diagnostics.error(
        "E0758", {},
        fmt::format("output {} of the policy `{}` is {:.3g} off that of `{}`, more than {:.3g}",
                    result->worst, b->file, worst.largest, a->file, worst.allowed));
  }
  return finish(run, options);
}

/// Once for both files; twice, first for the first; `-` for nothing.
Argument for_both(PolicyCompareOptions& options, const Saying& saying) {
  Argument argument{
      saying.names, std::string(saying.about) + "; give it twice for different values, - for none",
      saying.type, [&options, member = saying.member](const std::vector<std::string>& values) {
        const auto said = [](const std::string& value) {
          return value == "-" ? std::string() : value;
        };
        options.policy.*member = said(values.front());
        options.second_policy.*member = said(values.back());
        options.said_too_often |= values.size() > 2;
      }};
  argument.repeated = true;
  argument.use = saying.use;
  return argument;
}

Arguments two_policies(PolicyCompareOptions& options) {
  Arguments all = {
      required(reads(text("first", options.policy.file, "policy file", "FIRST"))),
      reads(text("second", options.second_policy.file,
                 "policy file to compare with (default with --int8: the first)", "SECOND")),
      flag("--int8", options.int8,
           "round the weights of the second policy to eight bits, as `weights: int8` does")};
  for (const Saying& saying : sayings()) all.push_back(for_both(options, saying));
  all.push_back(flag("--state-dependent-std", options.policy.state_dependent_std,
                     std::string("for the first file: ") + kDeviations));
  return joined({std::move(all), diagnostics(options)});
}

std::string check_two(const PolicyCompareOptions& options) {
  if (options.said_too_often) return "an option is there more than twice: there are two files";
  if (options.second_policy.file.empty() && !options.int8) {
    return "a second file is missing, or --int8";
  }
  return check_asked(options.asked);
}

Argument tolerance(PolicyCompareOptions& options) {
  const auto parsed = [](const std::string& text) -> std::optional<double> {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || !std::isfinite(value) || value < 0.0) {
      return std::nullopt;
    }
    return value;
  };
  return checked(
      {"--tolerance",
       "allowed difference of an output (default: 1e-5 of its range, and at least 1e-5)", "X",
       [&options, parsed](const std::vector<std::string>& values) {
         options.tolerance = parsed(values.front());
       }},
      [parsed](const std::string& text) { return parsed(text).has_value(); },
      "is not a number from 0 on");
}

Command table(PolicyCompareOptions& options) {
  return {.name = "compare",
          .about =
              "compare the answers of two policies: exit code 1 if they differ by more than the "
              "tolerance",
          .examples = {{"a trained policy and its export",
                        "eagerx-gen policy compare sac.zip sac.onnx"},
                       {"with statistics for the first one only",
                        "eagerx-gen policy compare ppo.zip ppo.onnx --normalize stats.pkl "
                        "--normalize -"},
                       {"the error of eight-bit weights",
                        "eagerx-gen policy compare sac.zip --int8 --tolerance 0.05"}},
          .arguments = joined({two_policies(options),
                               asked(options.asked),
                               {tolerance(options), flag("--json", options.json_output,
                                                         "print the differences as JSON")}}),
          .check = [&options] { return check_two(options); },
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command policy_compare_command() {
  return with_options<PolicyCompareOptions>(table);
}

}  // namespace eagerx::gen
