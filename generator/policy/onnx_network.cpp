#include "generator/policy/onnx_network.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxLayers = 256;
constexpr std::int64_t kMaxParameters = std::int64_t{16} << 20U;  // as many as the file can hold

constexpr const char* kExportHelp =
    "export the actor alone: Linear layers with LayerNorm or not, and an activation after them";

/// The bias as `outputs` values, with its factor applied; NaN and infinity are caught later.
std::optional<std::vector<float>> read_bias(const OnnxDense& dense, std::size_t outputs,
                                            PolicyProblem& problem) {
  std::vector<float> bias(outputs, 0.0F);
  if (!dense.bias) return bias;
  const std::optional<std::vector<float>> values = read_floats(*dense.bias, problem);
  if (!values) return std::nullopt;
  for (std::size_t i = 0; i < outputs; ++i) {
    bias[i] = dense.bias_scale * (values->size() == 1 ? values->front() : (*values)[i]);
  }
  return bias;
}

std::optional<DenseLayer> make_layer(const OnnxDense& dense, PolicyProblem& problem) {
  std::optional<std::vector<float>> weights = read_floats(dense.weights, problem);
  if (!weights) return std::nullopt;
  for (float& weight : *weights) weight *= dense.scale;
  DenseLayer layer;
  layer.outputs = static_cast<std::uint32_t>(dense.weights.dims[0]);
  layer.inputs = static_cast<std::uint32_t>(dense.weights.dims[1]);
  std::optional<std::vector<float>> bias = read_bias(dense, layer.outputs, problem);
  if (!bias) return std::nullopt;
  for (const std::vector<float>* values : {&*weights, &*bias}) {
    for (const float value : *values) {
      if (std::isfinite(value)) continue;
      problem = {"E0616",
                 fmt::format("has a layer whose factors turn `{}` into NaN or infinity",
                             printable(dense.weights.tensor->name())),
                 "export the actor again"};
      return std::nullopt;
    }
  }
  layer.weights = std::move(*weights);
  layer.bias = std::move(*bias);
  return layer;
}

/// The steps from the observation to `last`; nothing if they are too many or too large.
std::optional<std::vector<const OnnxStep*>> path_to(const std::vector<OnnxStep>& steps,
                                                    std::int32_t last, PolicyProblem& problem) {
  std::vector<const OnnxStep*> path;
  std::int64_t parameters = 0;
  for (std::int32_t at = last; at >= 0; at = path.back()->before) {
    path.push_back(&steps[static_cast<std::size_t>(at)]);
    if (const auto* dense = std::get_if<OnnxDense>(&path.back()->what); dense != nullptr) {
      parameters +=
          element_count(dense->weights.dims).value_or(kMaxParameters) + dense->weights.dims[0];
    }
    if (parameters > kMaxParameters || path.size() > 2 * kMaxLayers) {
      problem = {
          "E0619",
          fmt::format("has more than {} layers or {} parameters", kMaxLayers, kMaxParameters),
          "use a smaller network"};
      return std::nullopt;
    }
  }
  return std::vector<const OnnxStep*>(path.rbegin(), path.rend());
}

/// Puts `activation` on the last layer. Only relu after relu changes nothing.
bool activate(std::vector<DenseLayer>& layers, const OnnxActivation& activation,
              const std::string& node, PolicyProblem& problem) {
  Activation* before = layers.empty() ? nullptr : &layers.back().activation;
  const bool same =
      before != nullptr && *before == activation.kind && activation.kind == Activation::relu;
  if (before == nullptr || (*before != Activation::identity && !same)) {
    problem = {"E0613", fmt::format("has an activation that follows no layer (node `{}`)", node),
               kExportHelp};
    return false;
  }
  if (!std::isfinite(activation.slope)) {
    problem = {"E0616", fmt::format("has an activation without a finite slope (node `{}`)", node),
               "export the actor again"};
    return false;
  }
  *before = activation.kind;
  layers.back().slope = activation.slope;
  return true;
}

/// Puts a LayerNorm between the last layer and its activation.
bool normalize(std::vector<DenseLayer>& layers, const OnnxNorm& norm, const std::string& node,
               PolicyProblem& problem) {
  DenseLayer* layer = layers.empty() ? nullptr : &layers.back();
  if (layer == nullptr || layer->norm || layer->activation != Activation::identity ||
      !(norm.epsilon >= 0.0F)) {
    problem = {"E0613", fmt::format("has a LayerNorm that follows no layer (node `{}`)", node),
               kExportHelp};
    return false;
  }
  auto gamma = read_floats(norm.gamma, problem);
  if (!gamma) return false;
  std::vector<float> beta(gamma->size(), 0.0F);
  if (norm.beta) {
    auto values = read_floats(*norm.beta, problem);
    if (!values) return false;
    beta = std::move(*values);
  }
  layer->norm = LayerNorm{std::move(*gamma), std::move(beta), norm.epsilon};
  return true;
}

}  // namespace

std::optional<std::vector<DenseLayer>> make_layers(
    const std::vector<OnnxStep>& steps, std::int32_t last,
    std::unordered_set<const onnx::TensorProto*>& used, PolicyProblem& problem) {
  const auto path = path_to(steps, last, problem);
  if (!path) return std::nullopt;
  std::vector<DenseLayer> layers;
  for (const OnnxStep* step : *path) {
    if (const auto* activation = std::get_if<OnnxActivation>(&step->what)) {
      if (!activate(layers, *activation, step->node, problem)) return std::nullopt;
      continue;
    }
    if (const auto* norm = std::get_if<OnnxNorm>(&step->what)) {
      if (!normalize(layers, *norm, step->node, problem)) return std::nullopt;
      used.insert(norm->gamma.tensor);
      if (norm->beta) used.insert(norm->beta->tensor);
      continue;
    }
    const auto& dense = std::get<OnnxDense>(step->what);
    std::optional<DenseLayer> layer = make_layer(dense, problem);
    if (!layer) return std::nullopt;
    layers.push_back(std::move(*layer));
    used.insert(dense.weights.tensor);
    if (dense.bias) used.insert(dense.bias->tensor);
  }
  if (layers.empty()) {
    problem = {"E0620", "has no layer between its input and its first output", kExportHelp};
    return std::nullopt;
  }
  return layers;
}

}  // namespace eagerx::gen
