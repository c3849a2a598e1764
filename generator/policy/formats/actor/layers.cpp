// Modules of an actor as layers: Linear, LayerNorm, and what other files have.
#include <fmt/core.h>

#include <utility>

#include "generator/policy/formats/actor/parts.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

class Layers : ActorParts {
 public:
  Layers(const ActorParts& parts, const ActorLayout& layout, Activation activation)
      : ActorParts(parts), layout_(layout), activation_(activation) {}

  bool add(const ActorModule& module) {
    if (network.layers.size() >= kMaxLayers) {
      return fail("E0619", fmt::format("has more than {} layers", kMaxLayers));
    }
    if (module.recurrent) return add_recurrent(module);
    if (is_batch_norm(table, module.base)) {
      if (!add_batch_norm(*this, module.base)) return false;
      return activate(module);
    }
    const StoredTensor* weight = table.find(module.base + ".weight");
    if (weight == nullptr) return missing(module.base + ".weight");
    const bool added = weight->shape.size() == 1 ? add_norm(module.base, *weight)
                                                 : add_dense(module.base, *weight);
    if (!added) return false;
    if (module.is_limited && facts.limit > 0.0) {
      add_limits(network, static_cast<float>(facts.limit));
    }
    return activate(module);
  }

 private:
  bool add_recurrent(const ActorModule& module) {
    std::vector<std::string> names;
    auto layer = recurrent_layer(table, module.base, *module.recurrent, names, problem);
    if (!layer) return false;
    if (!network.layers.empty() && network.outputs() != layer->inputs) {
      return fail("E0618", fmt::format("gives {} values to its memory `{}`, which takes {}",
                                       network.outputs(), printable(module.base), layer->inputs));
    }
    used.insert(names.begin(), names.end());
    network.layers.push_back(std::move(*layer));
    return true;
  }

  bool activate(const ActorModule& module) {
    if (module.activation_after) {
      const Activation activation = module.activation.value_or(activation_);
      network.layers.back().activation = activation;
      network.layers.back().slope = default_slope(activation);
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
    const StoredTensor* bias = table.find(name);
    if (bias == nullptr) {
      if (!required) return std::vector<float>(static_cast<std::size_t>(count), 0.0F);
      return missing(name);
    }
    if (bias->shape != Dims{count}) {
      return fail("E0618", fmt::format("has tensor `{}` of shape {} for {} outputs",
                                       printable(name), show(bias->shape), count));
    }
    used.insert(name);
    return floats_of(name, *bias, problem);
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
    if (!network.layers.empty() && network.outputs() != inputs) {
      return fail("E0618", fmt::format("multiplies {} values by tensor `{}`, which takes {}",
                                       network.outputs(), printable(name), inputs));
    }
    auto weights = floats_of(name, weight, problem);
    if (!weights) return false;
    auto bias = bias_of(base, outputs, layout_.has_bias);
    if (!bias) return false;
    used.insert(name);
    network.layers.push_back(layer_of(Dense{}, static_cast<std::uint32_t>(inputs),
                                      static_cast<std::uint32_t>(outputs), std::move(*bias),
                                      std::move(*weights)));
    return true;
  }

  bool add_norm(const std::string& base, const StoredTensor& weight) {
    const std::string name = base + ".weight";
    Layer* layer = network.layers.empty() ? nullptr : &network.layers.back();
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
    if (table.find(base + ".bias") == nullptr) {
      return fail("E0628",
                  fmt::format("has a norm without a bias, which may be a LayerNorm or an RMSNorm: "
                              "`{}`",
                              printable(name)),
                  "export the actor to ONNX");
    }
    auto gamma = floats_of(name, weight, problem);
    if (!gamma) return false;
    auto beta = bias_of(base, layer->outputs, true);
    if (!beta) return false;
    used.insert(name);
    layer->norm = LayerNorm{std::move(*gamma), std::move(*beta)};
    return true;
  }

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
  return ranges::all_of(layout.modules, [&](const ActorModule& module) {
    return layers.add(module) && check_size(parts);
  });
}

}  // namespace eagerx::gen
