// ONNX files: the whole model is untrusted, and only what leads to the first output is read.
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <onnx/onnx_pb.h>

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

/// The shape of one observation: a batch axis becomes 1.
std::optional<Dims> input_shape(const onnx::ValueInfoProto& input, PolicyProblem& problem) {
  const std::string name = printable(input.name());
  const onnx::TypeProto::Tensor& type = input.type().tensor_type();
  const auto fail = [&](const std::string& what) {
    problem = {"E0608", fmt::format("has input `{}` {}", name, what), kExportHelp};
    return std::nullopt;
  };
  if (!input.type().has_tensor_type() || !type.has_shape() || type.shape().dim_size() == 0) {
    return fail("of unknown shape");
  }
  if (type.elem_type() != onnx::TensorProto::FLOAT &&
      type.elem_type() != onnx::TensorProto::DOUBLE) {
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
    if (batch && dim.has_dim_value() && dim.dim_value() > 1) {
      return fail(fmt::format("with a batch of {}: one observation at a time is evaluated",
                              dim.dim_value()));
    }
    if (!batch && dim.dim_value() < 1) return fail("of unknown size");
    shape.push_back(batch ? 1 : dim.dim_value());
  }
  constexpr int kMaxRank = 8;
  if (rank > kMaxRank || !element_count(shape)) return fail("of an impossible size");
  return shape;
}

std::optional<OnnxValue> input_value(const OnnxDependencies& needed, PolicyProblem& problem) {
  if (needed.inputs.size() != 1) {
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
  OnnxValue value;
  value.kind = Kind::data;
  value.shape = input_shape(*needed.inputs.front(), problem);
  return value.shape ? std::optional(std::move(value)) : std::nullopt;
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

void evaluate_nodes(const OnnxDependencies& needed, OnnxCall::State& state, Values& values) {
  for (const onnx::NodeProto* node : needed.nodes) {
    std::vector<const OnnxValue*> inputs;
    for (const std::string& input : node->input()) inputs.push_back(values.get(input));
    const OnnxCall call(*node, std::move(inputs), state);
    for (int i = 0; i < node->output_size(); ++i) {
      if (node->output(i).empty()) continue;
      values.set(node->output(i),
                 i == 0 ? evaluate(call) : call.misused("whose second output is used"));
    }
  }
}

/// Other outputs, inputs and tensors that have no part in the action.
std::vector<std::string> ignored_parts(const onnx::GraphProto& graph,
                                       const OnnxDependencies& needed,
                                       const std::unordered_set<const onnx::TensorProto*>& used) {
  std::vector<std::string> ignored;
  for (int i = 1; i < graph.output_size(); ++i) {
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
    if (&input == needed.inputs.front() || tensors.contains(input.name())) continue;
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
  std::optional<OnnxValue> observation = input_value(*needed, problem);
  if (!observation) return std::nullopt;

  OnnxCall::State state{*opset, {}, {}};
  Values values(*names);
  values.set(needed->inputs.front()->name(), std::move(*observation));
  evaluate_nodes(*needed, state, values);
  const OnnxValue& result = *values.get(action);
  if (result.kind != Kind::data) {
    problem = result.kind == Kind::other
                  ? result.problem
                  : PolicyProblem{"E0620", "has a first output that is constant", kExportHelp};
    return std::nullopt;
  }
  std::unordered_set<const onnx::TensorProto*> used;
  std::optional<std::vector<DenseLayer>> layers =
      make_layers(state.steps, result.step, used, problem);
  if (!layers) return std::nullopt;
  Network network;
  network.format = describe(*model, *opset);
  network.layers = std::move(*layers);
  network.ignored = ignored_parts(graph, *needed, used);
  return network;
}

}  // namespace eagerx::gen
