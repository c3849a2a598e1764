#include "generator/policy/network/network.hpp"

#include <array>
#include <cctype>

namespace eagerx::gen {

Layer layer_of(LayerForm form, std::uint32_t inputs, std::uint32_t outputs, std::vector<float> bias,
               std::vector<float> weights) {
  Layer layer;
  layer.inputs = inputs;
  layer.outputs = outputs;
  layer.form = std::move(form);
  layer.bias = std::move(bias);
  layer.weights = std::move(weights);
  return layer;
}
namespace {

constexpr std::array kActivationNames = {"identity", "relu", "tanh",      "elu",      "leaky_relu",
                                         "silu",     "gelu", "gelu_tanh", "softplus", "sigmoid"};

std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

}  // namespace

const char* to_string(Activation activation) {
  return kActivationNames.at(static_cast<std::size_t>(activation));
}

std::optional<Activation> activation_of(std::string_view name) {
  // "<class 'torch.nn.modules.activation.LeakyReLU'>"
  const std::string wanted = letters_of(name.substr(name.rfind('.') + 1));
  for (std::size_t i = 0; i < kActivationNames.size(); ++i) {
    if (letters_of(kActivationNames.at(i)) == wanted) return static_cast<Activation>(i);
  }
  if (wanted == "swish") return Activation::silu;
  if (wanted == "linear" || wanted == "none") return Activation::identity;
  return std::nullopt;
}

std::vector<std::string> activation_names() {
  return {kActivationNames.begin(), kActivationNames.end()};
}

float default_slope(Activation activation) {
  if (activation == Activation::elu) return 1.0F;
  return activation == Activation::leaky_relu ? 0.01F : 0.0F;
}

const char* to_string(Elementwise::Operation operation) {
  constexpr std::array kNames = {"add",      "subtract", "multiply", "divide",
                                 "at_least", "at_most",  "apply"};
  return kNames.at(static_cast<std::size_t>(operation));
}

const char* to_string(Combination::Operation operation) {
  constexpr std::array kNames = {"join", "sum", "difference", "product", "quotient", "select"};
  return kNames.at(static_cast<std::size_t>(operation));
}

const char* to_string(Function::Kind kind) {
  constexpr std::array kNames = {"sin",        "cos",           "exp",   "abs", "sqrt",
                                 "above_zero", "round_to_even", "floor", "ceil"};
  return kNames.at(static_cast<std::size_t>(kind));
}

const char* to_string(Reduction::Kind kind) {
  constexpr std::array kNames = {"sum", "mean", "norm"};
  return kNames.at(static_cast<std::size_t>(kind));
}

const char* to_string(ActionKind kind) {
  switch (kind) {
    case ActionKind::squashed:
      return "squashed";
    case ActionKind::argmax:
      return "argmax";
    case ActionKind::binary:
      return "binary";
    case ActionKind::raw:
      break;
  }
  return "raw";
}

}  // namespace eagerx::gen
