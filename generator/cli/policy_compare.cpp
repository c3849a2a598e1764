// eagerx-gen policy compare: how far the answers of two policies are apart.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/cli/pipeline.hpp"
#include "generator/cli/policy_file.hpp"
#include "generator/json/json.hpp"
#include "generator/network/cost.hpp"
#include "generator/network/difference.hpp"
#include "generator/network/int8.hpp"
#include "generator/network/observations.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostShown = 32;

/// Numbers of a vector, not more than a screen has.
std::string shown(const std::vector<double>& values) {
  const std::size_t count = std::min(values.size(), kMostShown);
  const std::vector<double> first(values.begin(),
                                  values.begin() + static_cast<std::ptrdiff_t>(count));
  return fmt::format("[{:.6g}{}]", fmt::join(first, ", "), count < values.size() ? ", …" : "");
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
  if (result.choices) say("choices        another one in {} rows\n", *result.choices);
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

}  // namespace

int policy_compare_command(const Options& options) {
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
  // What remembers says what is drawn, and statistics and bounds say where.
  const bool by_second = b->has_memory() && !a->has_memory();
  const auto asked = asked_rows(by_second ? *b : *a, options, run.diagnostics);
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

}  // namespace eagerx::gen
