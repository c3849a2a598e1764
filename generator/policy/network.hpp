// A trained policy as plain data: what a weight file holds once it was read and checked.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

enum class Activation : std::uint8_t { identity, relu, tanh };

/// y = activation(W x + b).
struct DenseLayer {
  std::uint32_t inputs = 0;
  std::uint32_t outputs = 0;
  std::vector<float> weights;  // [outputs][inputs], row-major
  std::vector<float> bias;     // [outputs]
  Activation activation = Activation::identity;
};

/// A multi-layer perceptron: n_obs values in, n_act values out.
struct Network {
  std::string file;                // as the user wrote it
  std::string format;              // for people: "ONNX opset 17, exported by pytorch 1.13"
  std::vector<DenseLayer> layers;  // at least one; sizes fit together
  std::vector<std::string>
      ignored;  // parts of the file that do not lead to the action, for the report

  [[nodiscard]] std::uint32_t inputs() const { return layers.front().inputs; }
  [[nodiscard]] std::uint32_t outputs() const { return layers.back().outputs; }
};

/// Reads a policy; `mention` is where the graph names the file. Reads ONNX files of
/// Stable-Baselines3 MLP actors (Gemm, MatMul+Add, Relu, Tanh, Identity, Flatten, Cast …). The
/// action is the first output.
std::optional<Network> read_policy(const std::string& path, const std::string& name, Span mention,
                                   Diagnostics& diagnostics);

}  // namespace eagerx::gen
