// ONNX files: the whole model is untrusted, and only what leads to the first output is read.
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <onnx/onnx_pb.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "generator/policy/formats.hpp"
#include "generator/policy/onnx_graph.hpp"
#include "generator/policy/onnx_network.hpp"
#include "generator/policy/onnx_value.hpp"

namespace eagerx::gen {
namespace {

using Kind = OnnxValue::Kind;

// Between these versions none of the supported operators changed its meaning.
constexpr std::int64_t kOldestOpset = 9;
constexpr std::int64_t kNewestOpset = 21;

constexpr std::int64_t kMaxStateLayers = 64;

constexpr const char* kExportHelp =
    "export the actor alone with `torch.onnx.export`: one observation in, the action first";

std::optional<onnx::ModelProto> parse(std::string_view bytes, PolicyProblem& problem) {
  constexpr char kIrVersionTag = '\x08';  // how every ONNX file begins
  onnx::ModelProto model;
  const bool parsed = bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
                      model.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
  const bool onnx_like = bytes.front() == kIrVersionTag;
  if (!parsed && onnx_like) {
    problem = {"E0604", "is a damaged or truncated ONNX file", "copy or export the file again"};
    return std::nullopt;
  }
  if (!parsed || (!model.has_ir_version() && !model.has_graph())) {
    problem = {"E0603", "is not an ONNX file", "export the actor with `torch.onnx.export`"};
    return std::nullopt;
  }
  return model;
}

std::optional<std::int64_t> checked_opset(const onnx::ModelProto& model, PolicyProblem& problem) {
  std::optional<std::int64_t> opset;
  for (const onnx::OperatorSetIdProto& set : model.opset_import()) {
    if (set.domain().empty() || set.domain() == "ai.onnx") opset = set.version();
  }
  if (!model.has_graph() || !opset) {
    problem = {"E0605", fmt::format("has no {}", model.has_graph() ? "operator set" : "graph"),
               "copy or export the file again"};
    return std::nullopt;
  }
  if (*opset < kOldestOpset || *opset > kNewestOpset) {
    problem = {
        "E0605", fmt::format("is written for ONNX opset {}", *opset),
        fmt::format("export it with an `opset_version` from {} to {}", kOldestOpset, kNewestOpset)};
    return std::nullopt;
  }
  return opset;
}

bool is_recurrent(const onnx::NodeProto& node) {
  return node.op_type() == "GRU" || node.op_type() == "LSTM";
}

/// Types whose numbers float32 holds, so that an observation comes through unchanged.
bool is_number(int type) {
  return type == onnx::TensorProto::FLOAT || type == onnx::TensorProto::DOUBLE ||
         type == onnx::TensorProto::UINT8 || type == onnx::TensorProto::INT8;
}

/// The shape of one observation: a batch axis becomes 1, and so does one of time, if there is a
/// memory.
std::optional<Dims> input_shape(const onnx::ValueInfoProto& input, bool has_memory,
                                PolicyProblem& problem) {
  const std::string name = printable(input.name());
  const onnx::TypeProto::Tensor& type = input.type().tensor_type();
  const auto fail = [&](const std::string& what) {
    problem = {"E0608", fmt::format("has input `{}` {}", name, what), kExportHelp};
    return std::nullopt;
  };
  if (!input.type().has_tensor_type() || !type.has_shape() || type.shape().dim_size() == 0) {
    return fail("of unknown shape");
  }
  if (!is_number(type.elem_type())) {
    const int number = type.elem_type();
    return fail(fmt::format(
        "of type {}",
        onnx::TensorProto::DataType_IsValid(number)
            ? onnx::TensorProto::DataType_Name(static_cast<onnx::TensorProto::DataType>(number))
            : fmt::format("number {}", number)));
  }
  Dims shape;
  const int rank = type.shape().dim_size();
  for (int i = 0; i < rank; ++i) {
    const auto& dim = type.shape().dim(i);
    const bool batch = i == 0 && rank > 1;
    const bool time = has_memory && rank == 3 && i <= 1;
    if ((batch || time) && dim.has_dim_value() && dim.dim_value() > 1) {
      return fail(fmt::format("with a batch of {}: one observation at a time is evaluated",
                              dim.dim_value()));
    }
    if (!batch && !time && dim.dim_value() < 1) return fail("of unknown size");
    shape.push_back(batch || time ? 1 : dim.dim_value());
  }
  constexpr int kMaxRank = 8;
  if (rank > kMaxRank || element_count(shape).value_or(kMaxElements) > kMaxValues) {
    return fail("of an impossible size");
  }
  return shape;
}

/// Whether batch and time are axes of any length.
bool is_sequence(const onnx::ValueInfoProto& input) {
  const onnx::TensorShapeProto& shape = input.type().tensor_type().shape();
  return shape.dim_size() == 3 && !shape.dim(0).has_dim_value() && !shape.dim(1).has_dim_value();
}

/// The state of the layers of a GRU or LSTM: [layers, 1, values].
std::optional<OnnxValue> state_value(const onnx::ValueInfoProto& input, PolicyProblem& problem) {
  const onnx::TensorShapeProto& shape = input.type().tensor_type().shape();
  const auto size = [&](int i) { return shape.dim(i).dim_value(); };
  const bool fits = shape.dim_size() == 3 && size(0) >= 1 && size(0) <= kMaxStateLayers &&
                    size(1) <= 1 && size(2) >= 1 && size(2) <= kMaxValues;
  if (!fits) {
    return refuse(problem, "E0608",
                  fmt::format("has input `{}`, which is no state: [layers, 1, values]",
                              printable(input.name())),
                  "export the actor with the observation first, then its states");
  }
  OnnxValue value;
  value.kind = Kind::state;
  value.shape = Dims{size(0), 1, size(2)};
  value.state.name = input.name();
  value.slots = size(0);
  return value;
}

/// The observation: the first input that is needed, in the order of the file. Others are states, if
/// something takes them.
std::optional<const onnx::ValueInfoProto*> find_observation(const onnx::GraphProto& graph,
                                                            const OnnxDependencies& needed,
                                                            PolicyProblem& problem) {
  const bool has_memory = std::any_of(needed.nodes.begin(), needed.nodes.end(),
                                      [](const auto* node) { return is_recurrent(*node); });
  if (needed.inputs.empty() || (needed.inputs.size() > 1 && !has_memory)) {
    std::vector<std::string> names;
    for (const auto* input : needed.inputs)
      names.push_back(fmt::format("`{}`", printable(input->name())));
    problem = {needed.inputs.empty() ? "E0620" : "E0607",
               needed.inputs.empty()
                   ? std::string("has a first output that depends on no input")
                   : fmt::format("has {} inputs ({}); an actor has one, the observation",
                                 names.size(), fmt::join(names, ", ")),
               kExportHelp};
    return std::nullopt;
  }
  for (const onnx::ValueInfoProto& input : graph.input()) {
    const auto found = std::find(needed.inputs.begin(), needed.inputs.end(), &input);
    if (found != needed.inputs.end()) return *found;
  }
  return needed.inputs.front();
}

/// Every value that is computed or given, by name.
class Values {
 public:
  explicit Values(const OnnxNames& names) : names_(names) {}
  void set(std::string_view name, OnnxValue value) { values_[name] = std::move(value); }
  /// The value of `name`; tensors of the file are looked at when they are first asked for.
  const OnnxValue* get(std::string_view name) {
    const auto [place, fresh] = values_.try_emplace(name);
    const auto tensor = names_.tensors.find(name);
    if (fresh && !name.empty() && tensor != names_.tensors.end()) {
      OnnxValue& value = place->second;
      const auto constant = make_constant(*tensor->second, value.problem);
      value.kind = constant ? Kind::constant : Kind::other;
      if (constant) {
        value.shape = constant->dims;
        value.constant = *constant;
      }
    }
    return &place->second;
  }

 private:
  const OnnxNames& names_;
  std::unordered_map<std::string_view, OnnxValue> values_;  // its elements never move
};

void evaluate_nodes(const OnnxDependencies& needed, OnnxCall::State& state, Values& values,
                    std::unordered_set<const onnx::NodeProto*>& done) {
  for (const onnx::NodeProto* node : needed.nodes) {
    if (!done.insert(node).second) continue;
    std::vector<const OnnxValue*> inputs;
    for (const std::string& input : node->input()) inputs.push_back(values.get(input));
    const OnnxCall call(*node, std::move(inputs), state);
    if (node->output_size() == 0) continue;
    const OnnxValue first = evaluate(call);
    for (int i = 0; i < node->output_size(); ++i) {
      if (node->output(i).empty()) continue;
      values.set(node->output(i), i == 0 ? first : later_output(call, first, i));
    }
  }
}

/// Whether `output` is the new state for input `source`, which layer `step` takes as its own.
bool gives_back(const OnnxValue& output, const OnnxStateSource& source, bool is_cell,
                const std::vector<OnnxStep>& steps) {
  for (std::size_t slot = 0; slot < output.remembered.size(); ++slot) {
    const OnnxRemembered& part = output.remembered[slot];
    const auto* work =
        std::get_if<OnnxRecurrence>(&steps[static_cast<std::size_t>(part.step)].what);
    const auto& from = is_cell ? work->c : work->h;
    if (part.is_cell != is_cell || !from || from->name != source.name ||
        from->slot != static_cast<std::int64_t>(slot)) {
      return false;
    }
  }
  return source.slot < static_cast<std::int64_t>(output.remembered.size());
}

/// Every state on the way to the action comes back as an output, layer by layer: E0641.
bool check_states(const std::vector<OnnxStep>& steps, std::int32_t last,
                  const std::vector<const OnnxValue*>& outputs, PolicyProblem& problem) {
  std::unordered_set<std::string> taken;
  for (std::int32_t at = last; at >= 0; at = steps[static_cast<std::size_t>(at)].before) {
    const auto* work = std::get_if<OnnxRecurrence>(&steps[static_cast<std::size_t>(at)].what);
    if (work == nullptr) continue;
    for (const bool is_cell : {false, true}) {
      const auto& source = is_cell ? work->c : work->h;
      if (!source) continue;
      const bool found = std::any_of(outputs.begin(), outputs.end(), [&](const OnnxValue* output) {
        return gives_back(*output, *source, is_cell, steps);
      });
      const std::string key = fmt::format("{}/{}", source->name, source->slot);
      if (found && taken.insert(key).second) continue;
      problem = {"E0641",
                 found ? fmt::format("starts two layers from the same state, input `{}`",
                                     printable(source->name))
                       : fmt::format("takes a state as input `{}`, but none of its outputs is the "
                                     "new state of the same layers",
                                     printable(source->name)),
                 "export the new state too: `return action, state`"};
      return false;
    }
  }
  return true;
}

/// Other outputs, inputs and tensors that have no part in the action.
std::vector<std::string> ignored_parts(const onnx::GraphProto& graph,
                                       const OnnxDependencies& needed,
                                       const std::unordered_set<const onnx::TensorProto*>& used,
                                       const std::vector<const OnnxValue*>& others) {
  std::vector<std::string> ignored;
  for (int i = 1; i < graph.output_size(); ++i) {
    const auto at = static_cast<std::size_t>(i) - 1;
    if (at < others.size() && !others[at]->remembered.empty()) continue;  // a state: kept
    ignored.push_back(fmt::format("output `{}`", printable(graph.output(i).name())));
  }
  std::unordered_set<std::string_view> tensors;
  for (const onnx::TensorProto& tensor : graph.initializer()) {
    tensors.insert(tensor.name());
    if (used.contains(&tensor)) continue;
    const Dims dims(tensor.dims().begin(), tensor.dims().end());
    ignored.push_back(fmt::format("tensor `{}` {}", printable(tensor.name()), show(dims)));
  }
  for (const onnx::ValueInfoProto& input : graph.input()) {
    const bool taken =
        std::find(needed.inputs.begin(), needed.inputs.end(), &input) != needed.inputs.end();
    if (taken || tensors.contains(input.name())) continue;
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

}  // namespace

std::optional<Network> read_onnx(std::string_view bytes, PolicyProblem& problem) {
  const std::optional<onnx::ModelProto> model = parse(bytes, problem);
  if (!model) return std::nullopt;
  const std::optional<std::int64_t> opset = checked_opset(*model, problem);
  if (!opset) return std::nullopt;
  const onnx::GraphProto& graph = model->graph();
  if (graph.output_size() == 0) {
    problem = {"E0606", "has a graph without an output", kExportHelp};
    return std::nullopt;
  }
  const std::optional<OnnxNames> names = collect_names(graph, problem);
  if (!names) return std::nullopt;
  const std::string& action = graph.output(0).name();
  const std::optional<OnnxDependencies> needed = walk_back(action, *names, problem);
  if (!needed) return std::nullopt;
  const auto observation = find_observation(graph, *needed, problem);
  if (!observation) return std::nullopt;

  OnnxCall::State state;
  state.opset = *opset;
  state.is_sequence = is_sequence(**observation);
  Values values(*names);
  const bool has_memory = std::any_of(needed->nodes.begin(), needed->nodes.end(),
                                      [](const auto* node) { return is_recurrent(*node); });
  OnnxValue first;
  first.kind = Kind::data;
  first.shape = input_shape(**observation, has_memory, problem);
  if (!first.shape) return std::nullopt;
  const Dims observed = *first.shape;
  for (const onnx::ValueInfoProto& input : graph.input()) {
    if (&input == *observation || !has_memory || !names->inputs.contains(input.name())) continue;
    PolicyProblem why;
    auto value = state_value(input, why);
    const bool needs =
        std::find(needed->inputs.begin(), needed->inputs.end(), &input) != needed->inputs.end();
    if (!value && needs) {
      problem = why;
      return std::nullopt;
    }
    if (value) values.set(input.name(), std::move(*value));
  }
  values.set((*observation)->name(), std::move(first));
  std::unordered_set<const onnx::NodeProto*> done;
  evaluate_nodes(*needed, state, values, done);
  const OnnxValue result = *values.get(action);
  if (result.kind != Kind::data) {
    problem = result.kind == Kind::other
                  ? result.problem
                  : PolicyProblem{"E0620", "has a first output that is constant", kExportHelp};
    return std::nullopt;
  }
  std::vector<const OnnxValue*> others;
  for (int i = 1; has_memory && i < graph.output_size(); ++i) {
    PolicyProblem ignored;
    const auto more = walk_back(graph.output(i).name(), *names, ignored);
    if (more) evaluate_nodes(*more, state, values, done);
    others.push_back(values.get(graph.output(i).name()));
  }
  if (!check_states(state.steps, result.step, others, problem)) return std::nullopt;
  std::unordered_set<const onnx::TensorProto*> used;
  const auto inputs = static_cast<std::uint32_t>(element_count(observed).value_or(0));
  std::optional<std::vector<DenseLayer>> layers =
      make_layers(state.steps, result.step, inputs, used, problem);
  if (!layers) return std::nullopt;
  Network network;
  network.format = describe(*model, *opset);
  network.layers = std::move(*layers);
  network.ignored = ignored_parts(graph, *needed, used, others);
  if (std::any_of(network.layers.begin(), network.layers.end(),
                  [](const DenseLayer& layer) { return layer.depends_on_shape(); })) {
    network.input_shape.assign(observed.begin() + (observed.size() > 1 ? 1 : 0), observed.end());
  }
  return network;
}

}  // namespace eagerx::gen
