// Modules of an actor as layers: Linear, LayerNorm, and what other files have.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "generator/formats/actor/parts.hpp"
#include "generator/network/limits.hpp"

namespace eagerx::gen {
namespace {

class Layers {
 public:
  Layers(const ActorParts& parts, const ActorLayout& layout, Activation activation)
      : parts_(parts),
        table_(parts.table),
        network_(parts.network),
        problem_(parts.problem),
        layout_(layout),
        activation_(activation) {}

  bool add(const ActorModule& module) {
    if (network_.layers.size() >= kMaxLayers) {
      return fail("E0619", fmt::format("has more than {} layers", kMaxLayers));
    }
    if (module.recurrent) return add_recurrent(module);
    if (is_batch_norm(table_, module.base)) {
      if (!add_batch_norm(parts_, module.base)) return false;
      return activate(module);
    }
    const StoredTensor* weight = table_.find(module.base + ".weight");
    if (weight == nullptr) return missing(module.base + ".weight");
    const bool added = weight->shape.size() == 1 ? add_norm(module.base, *weight)
                                                 : add_dense(module.base, *weight);
    if (!added) return false;
    if (module.is_limited && parts_.facts.limit > 0.0) {
      add_limits(network_, static_cast<float>(parts_.facts.limit));
    }
    return activate(module);
  }

 private:
  Refused fail(const char* code, std::string message, std::string help = kOtherActor) const {
    return parts_.fail(code, std::move(message), std::move(help));
  }

  bool add_recurrent(const ActorModule& module) {
    std::vector<std::string> names;
    auto layer = recurrent_layer(table_, module.base, *module.recurrent, names, problem_);
    if (!layer) return false;
    if (!network_.layers.empty() && network_.outputs() != layer->inputs) {
      return fail("E0618", fmt::format("gives {} values to its memory `{}`, which takes {}",
                                       network_.outputs(), printable(module.base), layer->inputs));
    }
    parts_.used.insert(names.begin(), names.end());
    network_.layers.push_back(std::move(*layer));
    return true;
  }

  bool activate(const ActorModule& module) {
    if (module.activation_after) {
      network_.layers.back().activation = activation_;
      network_.layers.back().slope = default_slope(activation_);
    }
    return true;
  }
  Refused missing(const std::string& name) {
    return fail("E0624", fmt::format("has an actor without tensor `{}`", printable(name)));
  }

  /// The bias of `base` with `count` values; nothing if there is none or a problem.
  std::optional<std::vector<float>> bias_of(const std::string& base, std::int64_t count,
                                            bool required) {
    const std::string name = base + ".bias";
    const StoredTensor* bias = table_.find(name);
    if (bias == nullptr) {
      if (!required) return std::vector<float>(static_cast<std::size_t>(count), 0.0F);
      return missing(name);
    }
    if (bias->shape != Dims{count}) {
      return refuse(problem_, "E0618",
                    fmt::format("has tensor `{}` of shape {} for {} outputs", printable(name),
                                show(bias->shape), count),
                    kOtherActor);
    }
    parts_.used.insert(name);
    return floats_of(name, *bias, problem_);
  }

  bool add_dense(const std::string& base, const StoredTensor& weight) {
    const std::string name = base + ".weight";
    if (weight.shape.size() != 2 || weight.shape[0] < 1 || weight.shape[1] < 1) {
      return fail("E0628",
                  fmt::format("has tensor `{}` of shape {}", printable(name), show(weight.shape)),
                  "layers are Linear, with a matrix, and LayerNorm");
    }
    const std::int64_t outputs = weight.shape[0];
    const std::int64_t inputs = weight.shape[1];
    if (!network_.layers.empty() && network_.outputs() != inputs) {
      return fail("E0618",
                  fmt::format("multiplies {} values by tensor `{}`, which takes {}",
                              network_.outputs(), printable(name), inputs),
                  kOtherActor);
    }
    auto weights = floats_of(name, weight, problem_);
    if (!weights) return false;
    auto bias = bias_of(base, outputs, layout_.has_bias);
    if (!bias) return false;
    parts_.used.insert(name);
    Layer layer;
    layer.inputs = static_cast<std::uint32_t>(inputs);
    layer.outputs = static_cast<std::uint32_t>(outputs);
    layer.weights = std::move(*weights);
    layer.bias = std::move(*bias);
    network_.layers.push_back(std::move(layer));
    return true;
  }

  bool add_norm(const std::string& base, const StoredTensor& weight) {
    const std::string name = base + ".weight";
    Layer* layer = network_.layers.empty() ? nullptr : &network_.layers.back();
    if (layer == nullptr || !layer->is_dense() || layer->norm ||
        layer->activation != Activation::identity) {
      return fail("E0628",
                  fmt::format("has a LayerNorm that does not directly follow a Linear: `{}`",
                              printable(name)),
                  "put the LayerNorm between Linear and activation");
    }
    if (weight.shape != Dims{std::int64_t{layer->outputs}}) {
      return fail("E0618", fmt::format("has tensor `{}` of shape {} for {} values", printable(name),
                                       show(weight.shape), layer->outputs));
    }
    if (table_.find(base + ".bias") == nullptr) {
      return fail("E0628",
                  fmt::format("has a norm without a bias, which may be a LayerNorm or an RMSNorm: "
                              "`{}`",
                              printable(name)),
                  "export the actor to ONNX");
    }
    auto gamma = floats_of(name, weight, problem_);
    if (!gamma) return false;
    auto beta = bias_of(base, layer->outputs, true);
    if (!beta) return false;
    parts_.used.insert(name);
    layer->norm = LayerNorm{std::move(*gamma), std::move(*beta)};
    return true;
  }

  const ActorParts& parts_;
  const TensorTable& table_;
  Network& network_;
  PolicyProblem& problem_;
  const ActorLayout& layout_;
  Activation activation_;
};

/// Many layers may be made of the same bytes.
bool check_size(const ActorParts& parts) {
  std::size_t parameters = 0;
  for (const Layer& layer : parts.network.layers) {
    parameters += layer.weights.size() + layer.bias.size();
    if (layer.recurrence() != nullptr) parameters += layer.recurrence()->hidden_weights.size();
  }
  return parameters <= static_cast<std::size_t>(kMaxParameters) ||
         parts.fail("E0619", fmt::format("has more than {} parameters", kMaxParameters),
                    "use a smaller network");
}

}  // namespace

bool add_modules(const ActorParts& parts, const ActorLayout& layout, Activation activation) {
  Layers layers(parts, layout, activation);
  return std::ranges::all_of(layout.modules, [&](const ActorModule& module) {
    return layers.add(module) && check_size(parts);
  });
}

}  // namespace eagerx::gen
