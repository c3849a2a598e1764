// A trained policy as plain data: what a weight file holds once it was read and checked.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The largest network that is read: as many parameters as the largest file can hold.
inline constexpr std::size_t kMaxLayers = 256;
inline constexpr std::int64_t kMaxParameters = std::int64_t{16} << 20U;

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
/// torch's default for what elu and leaky relu do below zero; 0 for the others.
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
};

/// What a layer is.
struct Dense {};  // W x + b
/// weights [outputs' channels][channels / groups][rows][columns], bias one a channel.
struct Convolution {
  KernelShape kernel;
  std::uint32_t groups = 1;
  std::uint32_t channels = 1;  // of the result
};
/// No weights.
struct Pooling {
  enum class Kind : std::uint8_t { max, average, average_with_padding };
  KernelShape kernel;
  Kind kind = Kind::max;
};
/// weights [gates * outputs][inputs], bias [gates * outputs]; gates in torch's order: GRU reset,
/// update, candidate; LSTM input, forget, candidate, output. The state is what it remembers.
struct Recurrence {
  bool is_lstm = false;
  std::vector<float> hidden_weights;          // [gates * outputs][outputs]
  std::vector<float> hidden_bias;             // [gates * outputs]
  std::vector<std::int8_t> hidden_rounded{};  // in place of hidden_weights; empty: float32
  std::vector<float> hidden_scales{};         // [gates * outputs]
  [[nodiscard]] std::uint32_t gates() const { return is_lstm ? 4 : 3; }
};
/// x op c with one constant, or one for each number: `bias`. No other weights.
struct Elementwise {
  enum class Operation : std::uint8_t { add, subtract, multiply, divide, at_least, at_most, none };
  Operation operation = Operation::none;
};
const char* to_string(Elementwise::Operation operation);
/// Number `from[i]` of the input becomes number i.
struct Reorder {
  std::vector<std::uint32_t> from;  // [outputs]
};

/// y = activation(norm(W x + b)), or what `form` says in place of W x + b.
struct Layer {
  std::uint32_t inputs = 0;
  std::uint32_t outputs = 0;
  std::vector<float> weights;  // dense: [outputs][inputs], row-major
  std::vector<float> bias;     // dense: [outputs]
  Activation activation = Activation::identity;
  float slope = 0.0F;  // elu: its alpha; leaky relu: its negative slope
  std::optional<LayerNorm> norm{};
  std::variant<Dense, Convolution, Pooling, Recurrence, Elementwise, Reorder> form{};
  std::vector<std::int8_t> rounded{};  // as weights, in place of them; empty: float32
  std::vector<float> scales{};         // as bias: a weight is rounded times this

  [[nodiscard]] bool is_dense() const { return std::holds_alternative<Dense>(form); }
  [[nodiscard]] const Recurrence* recurrence() const { return std::get_if<Recurrence>(&form); }
  /// Whether it knows more of its input than how many numbers there are.
  [[nodiscard]] bool depends_on_shape() const {
    return std::holds_alternative<Convolution>(form) || std::holds_alternative<Pooling>(form) ||
           std::holds_alternative<Reorder>(form);
  }
  /// Numbers that it remembers from one observation to the next.
  [[nodiscard]] std::uint32_t remembers() const {
    return recurrence() == nullptr ? 0 : outputs * (recurrence()->is_lstm ? 2 : 1);
  }
};

/// A part of an observation.
struct NamedPart {
  std::string name;
  std::uint64_t size = 1;
};

/// clip((x - mean) / sqrt(variance + epsilon), -clip, clip) in float64: VecNormalize.
struct Normalization {
  std::vector<double> mean;      // [inputs]
  std::vector<double> variance;  // [inputs]
  double clip = 10.0;
  double epsilon = 1e-8;
  std::string source;              // file, as the user wrote it
  std::vector<NamedPart> parts{};  // of a Dict, in order; else empty
};

/// How the network's outputs become an action.
enum class ActionKind : std::uint8_t {
  raw,       // clipped to the bounds: PPO, A2C
  squashed,  // from -1…1 to the bounds: SAC, TD3
  argmax,    // the index of the largest one: DQN, discrete PPO
};
const char* to_string(ActionKind kind);

/// What the file says of the world that it was trained in; empty where it says nothing.
struct PolicyContract {
  std::string algorithm;                                  // "SAC"
  std::vector<NamedPart> observations;                    // in the order of the inputs
  std::vector<double> action_low, action_high;            // one for each output, or for all
  std::vector<double> observation_low, observation_high;  // one for each input, or empty
  std::optional<std::int64_t> first_choice;               // argmax: the action of output 0
  std::optional<double> rate_hz;                          // steps a second in training
};

/// How a program calculates a policy: with the same bits on every machine, or as fast as this one
/// can.
enum class Profile : std::uint8_t { exact, fast };

/// Layers in a row: n_obs values in, n_act values out.
struct Network {
  std::string file;           // as the user wrote it
  std::string format;         // for people: "ONNX opset 17, exported by pytorch 1.13"
  std::vector<Layer> layers;  // at least one; sizes fit together
  std::vector<std::string>
      ignored;  // parts of the file that do not lead to the action, for the report
  std::vector<std::string> assumed{};  // what the file does not say, for people
  std::optional<ActionKind> action{};  // if the file says it
  std::optional<Normalization> normalization{};
  Profile profile = Profile::exact;
  PolicyContract contract{};
  std::vector<std::vector<float>>
      self_test{};  // observations whose answers every program checks on its machine

  std::vector<std::uint32_t> input_shape{};  // of the observation where it matters: channels first

  /// Whether the answer depends on the observations before, since the start of the episode.
  [[nodiscard]] bool has_memory() const {
    return std::any_of(layers.begin(), layers.end(),
                       [](const Layer& layer) { return layer.remembers() > 0; });
  }
  [[nodiscard]] std::uint32_t inputs() const { return layers.front().inputs; }
  [[nodiscard]] std::uint32_t outputs() const { return layers.back().outputs; }
  /// What the file says; else squashed if the last layer is a tanh.
  [[nodiscard]] ActionKind action_kind() const {
    const bool tanh = layers.back().activation == Activation::tanh;
    return action.value_or(tanh ? ActionKind::squashed : ActionKind::raw);
  }
};

/// What the graph (or the command line) says of a policy besides its file.
struct PolicyRequest {
  std::string path, name;                      // where it is, and as the user wrote it
  Span span;                                   // where the graph names it
  std::string normalize_path, normalize_name;  // statistics; empty: those in the file, if any
  Span normalize_span;
  std::optional<Activation> activation;  // of hidden layers, for files that do not say it
  Span activation_span;
};

/// Reads a policy: ONNX, safetensors, npz, Stable-Baselines3 zip, torch.save; and its statistics:
/// VecNormalize.save, npz, JSON. Exactly one error (E06xx) if there is none.
std::optional<Network> read_policy(const PolicyRequest& request, Diagnostics& diagnostics);

/// The same with nothing but a file; `mention` is where the graph names it.
std::optional<Network> read_policy(const std::string& path, const std::string& name, Span mention,
                                   Diagnostics& diagnostics);

}  // namespace eagerx::gen
