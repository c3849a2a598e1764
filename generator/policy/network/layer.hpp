// One layer of a network: its operation and its weights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace eagerx::gen {

/// As eagerx::Activation. `gelu` is the one with erf, torch's default.
enum class Activation : std::uint8_t {
  identity,
  relu,
  tanh,
  elu,
  leaky_relu,
  silu,
  gelu,
  gelu_tanh,
  softplus,
  sigmoid,
};
const char* to_string(Activation activation);
/// The activation called `name` in a description ("relu", "leaky_relu") or in torch ("LeakyReLU").
std::optional<Activation> activation_of(std::string_view name);
/// As descriptions have them.
std::vector<std::string> activation_names();
/// torch's default slope of elu and leaky relu below zero; 0 for the others.
float default_slope(Activation activation);

/// y = gamma (x - mean(x)) / sqrt(var(x) + epsilon) + beta, over all outputs of a layer.
struct LayerNorm {
  std::vector<float> gamma;  // [outputs]
  std::vector<float> beta;   // [outputs]
  float epsilon = 1e-5F;
};

/// A kernel that is moved over [channels][height][width]; one dimension is a height of 1. As
/// eagerx::Kernel.
struct KernelShape {
  std::uint32_t channels = 1, height = 1, width = 1;
  std::uint32_t rows = 1, columns = 1;
  std::uint32_t stride_down = 1, stride_right = 1;
  std::uint32_t pad_top = 0, pad_left = 0;
  std::uint32_t dilation_down = 1, dilation_right = 1;
  std::uint32_t out_height = 1, out_width = 1;
  [[nodiscard]] std::uint32_t places() const { return out_height * out_width; }
  bool operator==(const KernelShape&) const = default;
};

/// The kind of a layer.
struct Dense {};  // W x + b
/// weights [outputs' channels][channels / groups][rows][columns], bias one a channel.
struct Convolution {
  KernelShape kernel;
  std::uint32_t groups = 1;
  std::uint32_t channels = 1;  // of the result
  bool operator==(const Convolution&) const = default;
};
/// No weights.
struct Pooling {
  enum class Kind : std::uint8_t { max, average, average_with_padding };
  KernelShape kernel;
  Kind kind = Kind::max;
  bool operator==(const Pooling&) const = default;
};
/// weights [gates * outputs][inputs], bias [gates * outputs]; gates in torch's order: GRU reset,
/// update, candidate; LSTM input, forget, candidate, output.
struct Recurrence {
  bool is_lstm = false;
  std::vector<float> hidden_weights;          // [gates * outputs][outputs]
  std::vector<float> hidden_bias;             // [gates * outputs]
  std::vector<std::int8_t> hidden_rounded{};  // instead of hidden_weights; empty: float32
  std::vector<float> hidden_scales{};         // [gates * outputs]
  [[nodiscard]] std::uint32_t gates() const { return is_lstm ? 4 : 3; }
};
/// x op c with one constant, or one for each number: `bias`. No other weights.
struct Elementwise {
  enum class Operation : std::uint8_t { add, subtract, multiply, divide, at_least, at_most, none };
  Operation operation = Operation::none;
  bool operator==(const Elementwise&) const = default;
};
const char* to_string(Elementwise::Operation operation);
/// Number `from[i]` of the input becomes number i.
struct Reorder {
  std::vector<std::uint32_t> from;  // [outputs]
  bool operator==(const Reorder&) const = default;
};

/// Several values become one: side by side, or number by number from the first to the last, where a
/// value of one number goes with each number of the others. `select` has three: where the first is
/// not zero the second, else the third.
struct Combination {
  enum class Operation : std::uint8_t { join, sum, difference, product, quotient, select };
  Operation operation = Operation::join;
  std::vector<std::uint32_t> sizes;  // of the values, in order
  bool operator==(const Combination&) const = default;
};
const char* to_string(Combination::Operation operation);
/// f(x), number by number. No weights. `above_zero`: 1 where x > 0, else 0.
struct Function {
  enum class Kind : std::uint8_t {
    sin,
    cos,
    exp,
    abs,
    sqrt,
    above_zero,
    round_to_even,
    floor,
    ceil,
  };
  Kind kind = Kind::sin;
  bool operator==(const Function&) const = default;
};
const char* to_string(Function::Kind kind);
/// Each row of `length` numbers becomes one; `norm` is the root of the sum of the squares.
struct Reduction {
  enum class Kind : std::uint8_t { sum, mean, norm };
  Kind kind = Kind::sum;
  std::uint32_t length = 1;
  bool operator==(const Reduction&) const = default;
};
const char* to_string(Reduction::Kind kind);

/// The newest `length` values of the input, oldest first. It remembers all but the last; they are
/// zeros when an episode starts.
struct History {
  std::uint32_t length = 1;
  bool operator==(const History&) const = default;
};

using LayerForm = std::variant<Dense, Convolution, Pooling, Recurrence, Elementwise, Reorder,
                               Combination, Function, Reduction, History>;

/// y = activation(norm(W x + b)), or the operation of `form` instead of W x + b.
struct Layer {
  std::uint32_t inputs = 0;
  std::uint32_t outputs = 0;
  std::vector<float> weights;  // dense: [outputs][inputs], row-major
  std::vector<float> bias;     // dense: [outputs]
  Activation activation = Activation::identity;
  float slope = 0.0F;  // elu: its alpha; leaky relu: its negative slope
  std::optional<LayerNorm> norm{};
  LayerForm form{};
  std::vector<std::int8_t> rounded{};  // as weights, instead of them; empty: float32
  std::vector<float> scales{};         // as bias: a weight is rounded times this
  /// Its inputs: -1 the observation, i the result of layer i. Empty: the result of the layer
  /// before it, as in a chain.
  std::vector<std::int32_t> takes{};

  [[nodiscard]] bool is_dense() const { return std::holds_alternative<Dense>(form); }
  [[nodiscard]] const Recurrence* recurrence() const { return std::get_if<Recurrence>(&form); }
  /// Whether it knows more of its input than how many numbers there are.
  [[nodiscard]] bool depends_on_shape() const {
    return std::holds_alternative<Convolution>(form) || std::holds_alternative<Pooling>(form) ||
           std::holds_alternative<Reorder>(form) || std::holds_alternative<History>(form);
  }
  /// Numbers that it remembers from one observation to the next.
  [[nodiscard]] std::uint32_t remembers() const {
    if (std::holds_alternative<History>(form)) return outputs - inputs;
    return recurrence() == nullptr ? 0 : outputs * (recurrence()->is_lstm ? 2 : 1);
  }
};

/// `bias`: also the constants of an Elementwise.
Layer layer_of(LayerForm form, std::uint32_t inputs, std::uint32_t outputs,
               std::vector<float> bias = {}, std::vector<float> weights = {});

}  // namespace eagerx::gen
