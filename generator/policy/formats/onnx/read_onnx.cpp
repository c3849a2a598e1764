// The whole model is untrusted. Only nodes on the way to the action are read.
#include "generator/policy/formats/onnx/read_onnx.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "generator/policy/formats/onnx/external.hpp"
#include "generator/policy/formats/onnx/graph.hpp"
#include "generator/policy/formats/onnx/guard.hpp"
#include "generator/policy/formats/onnx/inputs.hpp"
#include "generator/policy/formats/onnx/node.hpp"
#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/formats/onnx/outputs.hpp"
#include "generator/policy/network/graph/ends.hpp"
#include "generator/policy/network/graph/evaluate.hpp"
#include "generator/policy/network/graph/lower.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

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

using GraphInputs = std::vector<const onnx::ValueInfoProto*>;

/// From the graph of a file, whose action is known, to the network.
class Reading {
 public:
  Reading(const onnx::GraphProto& graph, std::int64_t opset, const OnnxNames& names,
          const OnnxAction& chosen, PolicyProblem& problem)
      : graph_(graph),
        opset_(opset),
        names_(names),
        chosen_(chosen),
        problem_(problem),
        wanted_(chosen.needed.inputs.begin(), chosen.needed.inputs.end()) {
    is_recurrent_ = ranges::any_of(chosen.needed.nodes,
                                   [](const auto* node) { return has_memory(node->op_type()); });
  }

  std::optional<Network> run() {
    if (wanted_.empty()) {
      return refuse(problem_, "E0620", "has an action that depends on no input", kExportActor);
    }
    const GraphInputs observation = find_observation();
    state_.is_sequence = is_sequence(*observation.front());
    state_.follows_time = is_recurrent_ && state_.is_sequence && wanted_.size() == 1;
    const auto observed = set_observation(observation);
    if (!observed) return std::nullopt;
    if (is_recurrent_ && !set_states(*observation.front())) return std::nullopt;
    evaluate_nodes(chosen_.needed);
    const auto result = action_of(*value(output(chosen_.output)), kExportActor, problem_);
    if (!result) return std::nullopt;
    if (result->is_choice) network_.action = ActionKind::argmax;
    network_.contract.groups = result->groups;
    if (is_recurrent_) take_other_outputs();
    if (!check_states(result->step)) return std::nullopt;
    std::unordered_set<const NetTensor*> used;
    const auto inputs = static_cast<std::uint32_t>(state_.observed);
    auto layers = make_layers(state_.steps, result->step, inputs, used, problem_);
    if (!layers) return std::nullopt;
    network_.layers = std::move(*layers);
    if (state_.has_halves ||
        observation.front()->type().tensor_type().elem_type() == onnx::TensorProto::FLOAT16) {
      network_.assumed.push_back(
          "float32 where the file calculates in float16: answers differ by what that rounds");
    }
    network_.ignored = ignored_parts(used);
    if (ranges::any_of(network_.layers,
                       [](const Layer& layer) { return layer.depends_on_shape(); })) {
      const auto first = observed->begin() + (observed->size() > 1 ? 1 : 0);
      network_.input_shape.assign(first, observed->end());
    }
    return std::move(network_);
  }

 private:
  const std::string& output(int i) const { return graph_.output(i).name(); }

  /// The value of `name`; tensors of the file are looked at when they are first asked for.
  const NetValue* value(std::string_view name) {
    const auto [place, fresh] = values_.try_emplace(name);
    const auto tensor = names_.tensors.find(name);
    if (fresh && !name.empty() && tensor != names_.tensors.end()) {
      place->second = tensor_value(*tensor->second, state_.made);
    }
    return &place->second;
  }

  /// The needed inputs in the order of the file. With a memory the first one, and others are
  /// states.
  GraphInputs find_observation() const {
    GraphInputs found;
    for (const onnx::ValueInfoProto& input : graph_.input()) {
      const bool is_needed = wanted_.contains(&input);
      if (is_needed && (found.empty() || !is_recurrent_)) found.push_back(&input);
    }
    return found;
  }

  /// Sets the inputs of an observation of several parts, which come one after the other.
  bool set_parts(const GraphInputs& inputs) {
    for (const onnx::ValueInfoProto* input : inputs) {
      const auto shape = input_shape(*input, false, problem_);
      if (!shape) return false;
      const std::int64_t count = element_count(*shape).value_or(kMaxValues);
      if (count > kMaxValues - state_.observed) {
        return refuse(problem_, "E0608", "has inputs of an impossible size", kExportActor);
      }
      values_[input->name()] = observation_part(state_, input->name(), *shape);
      network_.contract.observations.push_back(
          {printable(input->name()), static_cast<std::uint64_t>(count)});
    }
    return true;
  }

  /// Sets the observation, whose shape is the result: the only input, or the parts of it.
  std::optional<Dims> set_observation(const GraphInputs& inputs) {
    if (inputs.size() > 1) {
      return set_parts(inputs) ? std::optional(Dims{state_.observed}) : std::nullopt;
    }
    auto shape = input_shape(*inputs.front(), is_recurrent_, problem_);
    if (!shape) return std::nullopt;
    NetValue first = data_value(-1, *shape);
    first.time = state_.follows_time ? 3 : 0;  // [batch, time, …] or [time, batch, …]
    state_.observed = element_count(*shape).value_or(0);
    values_[inputs.front()->name()] = std::move(first);
    return shape;
  }

  /// Sets the inputs behind the observation that may be states.
  bool set_states(const onnx::ValueInfoProto& observation) {
    for (const onnx::ValueInfoProto& input : graph_.input()) {
      if (&input == &observation || !names_.inputs.contains(input.name())) continue;
      PolicyProblem why;
      auto state = state_value(input, why);
      if (!state && wanted_.contains(&input)) {
        problem_ = why;
        return false;
      }
      if (state) values_[input.name()] = std::move(*state);
    }
    return true;
  }

  void evaluate_nodes(const OnnxDependencies& needed) {
    for (const onnx::NodeProto* node : needed.nodes) {
      if (!done_.insert(node).second) continue;
      std::vector<const NetValue*> inputs;
      for (const std::string& input : node->input()) inputs.push_back(value(input));
      if (node->output_size() == 0) continue;
      const NetNode used = node_of(*node, opset_, inputs, state_.made);
      const NetCall call(used, std::move(inputs), state_);
      const NetValue first = evaluate(call);
      for (int i = 0; i < node->output_size(); ++i) {
        if (node->output(i).empty()) continue;
        values_[node->output(i)] = i == 0 ? first : later_output(call, first, i);
      }
    }
  }

  /// The outputs that are not the action: among them are new states.
  void take_other_outputs() {
    constexpr std::int64_t kSteps = 16;  // of the budget, for each node that is walked over
    for (int i = 0; i < graph_.output_size(); ++i) {
      if (i == chosen_.output) continue;
      PolicyProblem ignored;
      const auto more = state_.budget >= 0 ? walk_back(output(i), names_, ignored) : std::nullopt;
      if (more) {
        state_.budget -= kSteps * static_cast<std::int64_t>(more->nodes.size());
        evaluate_nodes(*more);
      }
      others_.push_back(value(output(i)));
    }
  }

  /// Whether `given` is the new state for input `source`, which layers take as their own.
  bool gives_back(const NetValue& given, const NetStateSource& source, bool is_cell) const {
    for (std::size_t slot = 0; slot < given.remembered.size(); ++slot) {
      const NetRemembered& part = given.remembered[slot];
      const NetStateSource* from = state_before(state_.steps, part);
      if (part.is_cell != is_cell || from == nullptr || from->name != source.name ||
          from->slot != static_cast<std::int64_t>(slot)) {
        return false;
      }
    }
    return source.slot < static_cast<std::int64_t>(given.remembered.size());
  }

  /// Every state on the way to the action comes back as an output, layer by layer: E0641.
  bool check_states(std::int32_t last) {
    std::unordered_set<std::string> taken;
    const auto path = steps_to(state_.steps, last, problem_);
    if (!path) return false;
    for (const std::int32_t at : *path) {
      for (const bool is_cell : {false, true}) {
        const NetStateSource* source = state_before(state_.steps, {at, is_cell});
        if (source == nullptr) continue;
        const bool found = ranges::any_of(
            others_, [&](const NetValue* given) { return gives_back(*given, *source, is_cell); });
        const std::string key = fmt::format("{}/{}", source->name, source->slot);
        if (found && taken.insert(key).second) continue;
        return refuse(problem_, "E0641",
                      found ? fmt::format("starts two layers from the same state, input `{}`",
                                          printable(source->name))
                            : fmt::format("takes a state as input `{}`, but none of its outputs is "
                                          "the new state of the same layers",
                                          printable(source->name)),
                      "export the new state too: `return action, state`");
      }
    }
    return true;
  }

  /// Other outputs, inputs and tensors that have no part in the action.
  std::vector<std::string> ignored_parts(const std::unordered_set<const NetTensor*>& used) {
    std::vector<std::string> ignored;
    for (int i = 0; i < graph_.output_size(); ++i) {
      if (i == chosen_.output) continue;
      const auto at = static_cast<std::size_t>(i < chosen_.output ? i : i - 1);
      if (at < others_.size() && !others_[at]->remembered.empty()) continue;  // a state: kept
      ignored.push_back(fmt::format("output `{}`", printable(output(i))));
    }
    for (const onnx::TensorProto& tensor : graph_.initializer()) {
      if (used.contains(value(tensor.name())->constant.tensor)) continue;
      const Dims dims(tensor.dims().begin(), tensor.dims().end());
      ignored.push_back(fmt::format("tensor `{}` {}", printable(tensor.name()), show(dims)));
    }
    for (const onnx::ValueInfoProto& input : graph_.input()) {
      if (wanted_.contains(&input) || names_.tensors.contains(input.name())) continue;
      ignored.push_back(fmt::format("input `{}`", printable(input.name())));
    }
    return ignored;
  }

  const onnx::GraphProto& graph_;
  std::int64_t opset_;
  const OnnxNames& names_;
  const OnnxAction& chosen_;
  PolicyProblem& problem_;
  std::unordered_set<const onnx::ValueInfoProto*> wanted_;
  bool is_recurrent_ = false;
  NetCall::State state_;
  std::unordered_map<std::string_view, NetValue> values_;  // its elements never move
  std::unordered_set<const onnx::NodeProto*> done_;
  std::vector<const NetValue*> others_;  // the outputs but the action, where there is a memory
  Network network_;
};

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
                                 const FilesInFolder& files, PolicyProblem& problem) {
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
  std::optional<Network> network = Reading(graph, *opset, *names, *chosen, problem).run();
  if (!network) return std::nullopt;
  // Who names the output knows what it is.
  if (output.empty() && !leads_to_outputs(graph, *names, *chosen, problem)) return std::nullopt;
  if (!read_rate(*model, network->contract.rate_hz, problem)) return std::nullopt;
  network->format = describe(*model, *opset);
  return network;
}

}  // namespace eagerx::gen
