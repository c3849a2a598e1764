// The whole model is untrusted, and only what leads to the action is read.
#include "generator/formats/onnx/read_onnx.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "generator/formats/onnx/external.hpp"
#include "generator/formats/onnx/graph.hpp"
#include "generator/formats/onnx/guard.hpp"
#include "generator/formats/onnx/inputs.hpp"
#include "generator/formats/onnx/node.hpp"
#include "generator/formats/onnx/onnx.pb.h"
#include "generator/formats/onnx/outputs.hpp"
#include "generator/network/graph/ends.hpp"
#include "generator/network/graph/evaluate.hpp"
#include "generator/network/graph/lower.hpp"
#include "generator/network/limits.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

// Between these versions none of the supported operators changed its meaning.
constexpr std::int64_t kOldestOpset = 9;
constexpr std::int64_t kNewestOpset = 23;

std::optional<onnx::ModelProto> parse(std::string_view bytes, PolicyProblem& problem) {
  constexpr char kIrVersionTag = '\x08';  // how every ONNX file begins
  const bool onnx_like = bytes.front() == kIrVersionTag;
  const bool is_small = is_onnx_of_few_parts(bytes);
  if (!is_small && onnx_like) {
    return refuse(problem, "E0619", "has more parts than any ONNX network needs",
                  "use a smaller network, or check where the file comes from");
  }
  onnx::ModelProto model;
  const bool parsed = is_small &&
                      bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
                      model.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  if (!parsed && onnx_like) {
    return refuse(problem, "E0604", "is a damaged or truncated ONNX file",
                  "copy or export the file again");
  }
  if (!parsed || (!model.has_ir_version() && !model.has_graph())) {
    return refuse(problem, "E0603", "is not an ONNX file",
                  "export the actor with `torch.onnx.export`");
  }
  return model;
}

std::optional<std::int64_t> checked_opset(const onnx::ModelProto& model, PolicyProblem& problem) {
  std::optional<std::int64_t> opset;
  for (const onnx::OperatorSetIdProto& set : model.opset_import()) {
    if (set.domain().empty() || set.domain() == "ai.onnx") opset = set.version();
  }
  if (!model.has_graph() || !opset) {
    return refuse(problem, "E0605",
                  fmt::format("has no {}", model.has_graph() ? "operator set" : "graph"),
                  "copy or export the file again");
  }
  if (*opset < kOldestOpset || *opset > kNewestOpset) {
    return refuse(
        problem, "E0605", fmt::format("is written for ONNX opset {}", *opset),
        fmt::format("export it with an `opset_version` from {} to {}", kOldestOpset, kNewestOpset));
  }
  return opset;
}

bool remembers(const OnnxDependencies& needed) {
  return std::ranges::any_of(needed.nodes,
                             [](const auto* node) { return has_memory(node->op_type()); });
}

using GraphInputs = std::vector<const onnx::ValueInfoProto*>;
using InputSet = std::unordered_set<const onnx::ValueInfoProto*>;

/// The observation: the needed inputs in the order of the file. With a memory the first one, and
/// others are states.
std::optional<GraphInputs> find_observation(const onnx::GraphProto& graph,
                                            const OnnxDependencies& needed,
                                            PolicyProblem& problem) {
  const bool is_recurrent = remembers(needed);
  if (needed.inputs.empty()) {
    return refuse(problem, "E0620", "has an action that depends on no input", kExportActor);
  }
  GraphInputs found;
  const InputSet wanted(needed.inputs.begin(), needed.inputs.end());
  for (const onnx::ValueInfoProto& input : graph.input()) {
    const bool is_needed = wanted.contains(&input);
    if (is_needed && (found.empty() || !is_recurrent)) found.push_back(&input);
  }
  return found;
}

/// Every value that is computed or given, by name.
class ValueTable {
 public:
  ValueTable(const OnnxNames& names, std::deque<NetTensor>& made) : names_(names), made_(made) {}
  void set(std::string_view name, NetValue value) { values_[name] = std::move(value); }
  /// The value of `name`; tensors of the file are looked at when they are first asked for.
  const NetValue* get(std::string_view name) {
    const auto [place, fresh] = values_.try_emplace(name);
    const auto tensor = names_.tensors.find(name);
    if (fresh && !name.empty() && tensor != names_.tensors.end()) {
      place->second = tensor_value(*tensor->second, made_);
    }
    return &place->second;
  }

 private:
  const OnnxNames& names_;
  std::deque<NetTensor>& made_;
  std::unordered_map<std::string_view, NetValue> values_;  // its elements never move
};

/// Sets the inputs of an observation of several parts, which come one after the other.
bool set_parts(const GraphInputs& inputs, NetCall::State& state, ValueTable& values,
               Network& network, PolicyProblem& problem) {
  for (const onnx::ValueInfoProto* input : inputs) {
    const auto shape = input_shape(*input, false, problem);
    if (!shape) return false;
    const std::int64_t count = element_count(*shape).value_or(kMaxValues);
    if (count > kMaxValues - state.observed) {
      return refuse(problem, "E0608", "has inputs of an impossible size", kExportActor);
    }
    values.set(input->name(), observation_part(state, input->name(), *shape));
    network.contract.observations.push_back(
        {printable(input->name()), static_cast<std::uint64_t>(count)});
  }
  return true;
}

/// Sets the observation, whose shape is the result: the only input, or the parts of it.
std::optional<Dims> set_observation(const GraphInputs& inputs, bool is_recurrent,
                                    NetCall::State& state, ValueTable& values, Network& network,
                                    PolicyProblem& problem) {
  if (inputs.size() > 1) {
    if (!set_parts(inputs, state, values, network, problem)) return std::nullopt;
    return Dims{state.observed};
  }
  NetValue first;
  first.kind = Kind::data;
  first.shape = input_shape(*inputs.front(), is_recurrent, problem);
  if (!first.shape) return std::nullopt;
  first.time = state.follows_time ? 3 : 0;  // [batch, time, …] or [time, batch, …]
  state.observed = element_count(*first.shape).value_or(0);
  const Dims shape = *first.shape;
  values.set(inputs.front()->name(), std::move(first));
  return shape;
}

/// Sets the inputs behind the observation that may be states.
bool set_states(const onnx::GraphProto& graph, const OnnxNames& names,
                const OnnxDependencies& needed, const onnx::ValueInfoProto& observation,
                ValueTable& values, PolicyProblem& problem) {
  const InputSet wanted(needed.inputs.begin(), needed.inputs.end());
  for (const onnx::ValueInfoProto& input : graph.input()) {
    if (&input == &observation || !names.inputs.contains(input.name())) continue;
    PolicyProblem why;
    auto value = state_value(input, why);
    const bool needs = wanted.contains(&input);
    if (!value && needs) {
      problem = why;
      return false;
    }
    if (value) values.set(input.name(), std::move(*value));
  }
  return true;
}

void evaluate_nodes(const OnnxDependencies& needed, std::int64_t opset, NetCall::State& state,
                    ValueTable& values, std::unordered_set<const onnx::NodeProto*>& done) {
  for (const onnx::NodeProto* node : needed.nodes) {
    if (!done.insert(node).second) continue;
    std::vector<const NetValue*> inputs;
    for (const std::string& input : node->input()) inputs.push_back(values.get(input));
    if (node->output_size() == 0) continue;
    const NetNode used = node_of(*node, opset, inputs, state.made);
    const NetCall call(used, std::move(inputs), state);
    const NetValue first = evaluate(call);
    for (int i = 0; i < node->output_size(); ++i) {
      if (node->output(i).empty()) continue;
      values.set(node->output(i), i == 0 ? first : later_output(call, first, i));
    }
  }
}

/// The outputs that are not the action: among them are new states.
std::vector<const NetValue*> other_outputs(const onnx::GraphProto& graph, const OnnxAction& chosen,
                                           const OnnxNames& names, std::int64_t opset,
                                           NetCall::State& state, ValueTable& values,
                                           std::unordered_set<const onnx::NodeProto*>& done) {
  constexpr std::int64_t kSteps = 16;  // of the budget, for each node that is walked over
  std::vector<const NetValue*> others;
  for (int i = 0; i < graph.output_size(); ++i) {
    if (i == chosen.output) continue;
    PolicyProblem ignored;
    const auto more = state.budget >= 0 ? walk_back(graph.output(i).name(), names, ignored)
                                        : std::optional<OnnxDependencies>();
    if (more) {
      state.budget -= kSteps * static_cast<std::int64_t>(more->nodes.size());
      evaluate_nodes(*more, opset, state, values, done);
    }
    others.push_back(values.get(graph.output(i).name()));
  }
  return others;
}

/// Whether `output` is the new state for input `source`, which layer `step` takes as its own.
bool gives_back(const NetValue& output, const NetStateSource& source, bool is_cell,
                const std::vector<NetStep>& steps) {
  for (std::size_t slot = 0; slot < output.remembered.size(); ++slot) {
    const NetRemembered& part = output.remembered[slot];
    const auto* work = std::get_if<NetRecurrence>(&steps[static_cast<std::size_t>(part.step)].what);
    const auto& from = is_cell ? work->c : work->h;
    if (part.is_cell != is_cell || !from || from->name != source.name ||
        from->slot != static_cast<std::int64_t>(slot)) {
      return false;
    }
  }
  return source.slot < static_cast<std::int64_t>(output.remembered.size());
}

/// Every state on the way to the action comes back as an output, layer by layer: E0641.
bool check_states(const std::vector<NetStep>& steps, std::int32_t last,
                  const std::vector<const NetValue*>& outputs, PolicyProblem& problem) {
  std::unordered_set<std::string> taken;
  const auto path = steps_to(steps, last, problem);
  if (!path) return false;
  for (const std::int32_t at : *path) {
    const auto* work = std::get_if<NetRecurrence>(&steps[static_cast<std::size_t>(at)].what);
    if (work == nullptr) continue;
    for (const bool is_cell : {false, true}) {
      const auto& source = is_cell ? work->c : work->h;
      if (!source) continue;
      const bool found = std::any_of(outputs.begin(), outputs.end(), [&](const NetValue* output) {
        return gives_back(*output, *source, is_cell, steps);
      });
      const std::string key = fmt::format("{}/{}", source->name, source->slot);
      if (found && taken.insert(key).second) continue;
      return refuse(problem, "E0641",
                    found
                        ? fmt::format("starts two layers from the same state, input `{}`",
                                      printable(source->name))
                        : fmt::format("takes a state as input `{}`, but none of its outputs is the "
                                      "new state of the same layers",
                                      printable(source->name)),
                    "export the new state too: `return action, state`");
    }
  }
  return true;
}

/// Other outputs, inputs and tensors that have no part in the action.
std::vector<std::string> ignored_parts(const onnx::GraphProto& graph, const OnnxAction& chosen,
                                       const std::unordered_set<const NetTensor*>& used,
                                       const std::vector<const NetValue*>& others,
                                       ValueTable& values) {
  std::vector<std::string> ignored;
  for (int i = 0; i < graph.output_size(); ++i) {
    if (i == chosen.output) continue;
    const auto at = static_cast<std::size_t>(i < chosen.output ? i : i - 1);
    if (at < others.size() && !others[at]->remembered.empty()) continue;  // a state: kept
    ignored.push_back(fmt::format("output `{}`", printable(graph.output(i).name())));
  }
  std::unordered_set<std::string_view> tensors;
  for (const onnx::TensorProto& tensor : graph.initializer()) {
    tensors.insert(tensor.name());
    if (used.contains(values.get(tensor.name())->constant.tensor)) continue;
    const Dims dims(tensor.dims().begin(), tensor.dims().end());
    ignored.push_back(fmt::format("tensor `{}` {}", printable(tensor.name()), show(dims)));
  }
  const InputSet wanted(chosen.needed.inputs.begin(), chosen.needed.inputs.end());
  for (const onnx::ValueInfoProto& input : graph.input()) {
    if (wanted.contains(&input) || tensors.contains(input.name())) continue;
    ignored.push_back(fmt::format("input `{}`", printable(input.name())));
  }
  return ignored;
}

std::string describe(const onnx::ModelProto& model, std::int64_t opset) {
  std::string text = fmt::format("ONNX opset {}", opset);
  if (!model.producer_name().empty()) {
    text += fmt::format(", exported by {}", printable(model.producer_name()));
    if (!model.producer_version().empty()) {
      text += fmt::format(" {}", printable(model.producer_version()));
    }
  }
  return text;
}

/// Steps a second in training, from the metadata `rate`, as in safetensors files. False: it makes
/// no sense.
bool read_rate(const onnx::ModelProto& model, std::optional<double>& rate_hz,
               PolicyProblem& problem) {
  for (const onnx::StringStringEntryProto& note : model.metadata_props()) {
    if (note.key() != "rate") continue;
    double rate = 0.0;
    const std::string& text = note.value();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rate);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || !std::isfinite(rate) || rate <= 0.0) {
      return refuse(
          problem, "E0626",
          fmt::format("has metadata `rate: {}` that makes no sense", printable(note.value())),
          "correct it, or leave it out");
    }
    rate_hz = rate;
  }
  return true;
}

}  // namespace

std::optional<Network> read_onnx(std::string_view bytes, std::string_view output,
                                 const FilesBeside& files, PolicyProblem& problem) {
  std::optional<onnx::ModelProto> model = parse(bytes, problem);
  if (!model) return std::nullopt;
  if (model->has_graph() && !take_external_values(*model->mutable_graph(), files, problem)) {
    return std::nullopt;
  }
  const std::optional<std::int64_t> opset = checked_opset(*model, problem);
  if (!opset) return std::nullopt;
  const onnx::GraphProto& graph = model->graph();
  if (graph.output_size() == 0) {
    return refuse(problem, "E0606", "has a graph without an output", kExportActor);
  }
  const std::optional<OnnxNames> names = collect_names(graph, problem);
  if (!names) return std::nullopt;
  const std::optional<OnnxAction> chosen = choose_action(graph, *names, output, problem);
  if (!chosen) return std::nullopt;
  const std::string& action = graph.output(chosen->output).name();
  const OnnxDependencies* needed = &chosen->needed;
  const auto observation = find_observation(graph, *needed, problem);
  if (!observation) return std::nullopt;

  Network network;
  NetCall::State state;
  state.is_sequence = is_sequence(*observation->front());
  ValueTable values(*names, state.made);
  const bool is_recurrent = remembers(*needed);
  const bool is_alone = needed->inputs.size() == 1;
  state.follows_time = is_recurrent && state.is_sequence && is_alone && observation->size() == 1;
  const auto observed =
      set_observation(*observation, is_recurrent, state, values, network, problem);
  if (!observed) return std::nullopt;
  if (is_recurrent && !set_states(graph, *names, *needed, *observation->front(), values, problem)) {
    return std::nullopt;
  }
  std::unordered_set<const onnx::NodeProto*> done;
  evaluate_nodes(*needed, *opset, state, values, done);
  const auto result = action_of(*values.get(action), kExportActor, problem);
  if (!result) return std::nullopt;
  if (result->is_choice) network.action = ActionKind::argmax;
  const auto others = is_recurrent
                          ? other_outputs(graph, *chosen, *names, *opset, state, values, done)
                          : std::vector<const NetValue*>();
  if (!check_states(state.steps, result->step, others, problem)) return std::nullopt;
  std::unordered_set<const NetTensor*> used;
  const auto inputs = static_cast<std::uint32_t>(state.observed);
  std::optional<std::vector<Layer>> layers =
      make_layers(state.steps, result->step, inputs, used, problem);
  if (!layers) return std::nullopt;
  // Who names the output knows what it is.
  if (output.empty() && !leads_to_outputs(graph, *names, *chosen, problem)) return std::nullopt;
  if (!read_rate(*model, network.contract.rate_hz, problem)) return std::nullopt;
  network.format = describe(*model, *opset);
  network.layers = std::move(*layers);
  network.ignored = ignored_parts(graph, *chosen, used, others, values);
  if (std::any_of(network.layers.begin(), network.layers.end(),
                  [](const Layer& layer) { return layer.depends_on_shape(); })) {
    network.input_shape.assign(observed->begin() + (observed->size() > 1 ? 1 : 0), observed->end());
  }
  return network;
}

}  // namespace eagerx::gen
