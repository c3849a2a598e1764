// What is known about a value of an ONNX graph without running it, and the operators over such
// values.
#pragma once

#include <onnx/onnx_pb.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/policy/network.hpp"
#include "generator/policy/onnx_tensor.hpp"

namespace eagerx::gen {

/// y = scale (W x) + bias_scale bias.
struct OnnxDense {
  OnnxConstant weights;  // dims [outputs, inputs]
  std::optional<OnnxConstant> bias;
  float scale = 1.0F;
  float bias_scale = 1.0F;
};

struct OnnxActivation {
  Activation kind = Activation::identity;
  float slope = 0.0F;
};

/// Normalises all values.
struct OnnxNorm {
  OnnxConstant gamma;
  std::optional<OnnxConstant> beta;
  float epsilon = 1e-5F;
};

using OnnxWork = std::variant<OnnxDense, OnnxActivation, OnnxNorm>;

/// One thing that is done to the observation on its way. Steps form a tree: branches share their
/// start.
struct OnnxStep {
  std::int32_t before = -1;  // index of the step before, -1 for the observation itself
  OnnxWork what;
  std::string node;  // printable name
};

/// A value of the graph.
struct OnnxValue {
  enum class Kind : std::uint8_t {
    absent,    // an optional input that is not given
    constant,  // a tensor of the file
    integers,  // a shape that was computed
    data,      // the observation after `step`, in row-major order
    other,     // anything else: `problem` says why the action must not depend on it
  };
  Kind kind = Kind::absent;
  std::optional<Dims> shape;  // where known
  OnnxConstant constant;
  std::vector<std::int64_t> integers;
  std::int32_t step = -1;
  PolicyProblem problem;
};

/// What an operator sees.
class OnnxCall {
 public:
  struct State {  // shared by all calls of a graph
    std::int64_t opset = 0;
    std::vector<OnnxStep> steps;
    std::deque<onnx::TensorProto> made;  // tensors written as plain attributes
  };

  OnnxCall(const onnx::NodeProto& node, std::vector<const OnnxValue*> inputs, State& state)
      : node_(node), inputs_(std::move(inputs)), state_(state) {}

  [[nodiscard]] const onnx::NodeProto& node() const { return node_; }
  [[nodiscard]] State& state() const { return state_; }
  [[nodiscard]] std::int64_t opset() const { return state_.opset; }
  [[nodiscard]] std::size_t input_count() const { return inputs_.size(); }
  /// Input `i`; an absent value past the end.
  [[nodiscard]] const OnnxValue& input(std::size_t i) const;
  /// Attribute `name`, or nullptr.
  [[nodiscard]] const onnx::AttributeProto* attribute(std::string_view name) const;
  [[nodiscard]] std::int64_t integer(std::string_view name, std::int64_t otherwise) const;
  [[nodiscard]] float real(std::string_view name, float otherwise) const;
  /// Integers of input `i` or, where there is no such input, of attribute `name`.
  [[nodiscard]] std::optional<std::vector<std::int64_t>> integers(std::size_t i,
                                                                  std::string_view name) const;

  /// "operator `Gemm` (node `/mu/Gemm`)".
  [[nodiscard]] std::string who() const;
  /// A value that the action must not depend on. If an input already is one, its problem comes
  /// first.
  [[nodiscard]] OnnxValue other(PolicyProblem problem, std::optional<Dims> shape = {}) const;
  /// E0613: the operator is known, but not used like this.
  [[nodiscard]] OnnxValue misused(const std::string& how, std::optional<Dims> shape = {}) const;
  /// The observation after one more step.
  [[nodiscard]] OnnxValue data_after(std::int32_t before, OnnxWork what, Dims shape) const;

 private:
  const onnx::NodeProto& node_;
  std::vector<const OnnxValue*> inputs_;
  State& state_;
};

/// The small integers a value stands for, if it does.
std::optional<std::vector<std::int64_t>> integers_of(const OnnxValue& value);

/// NumPy's broadcasting; nothing where the shapes do not fit.
std::optional<Dims> broadcast(const std::optional<Dims>& a, const std::optional<Dims>& b);

/// The first output of the node. Never fails: what cannot be represented is of kind `other`.
OnnxValue evaluate(const OnnxCall& call);

using OnnxOperator = OnnxValue (*)(const OnnxCall&);
struct OnnxOperatorEntry {
  std::string_view name;
  OnnxOperator run;
};
/// Operators that compute (onnx_layers.cpp) and operators that only move or shape
/// (onnx_shapes.cpp).
std::vector<OnnxOperatorEntry> layer_operators();
std::vector<OnnxOperatorEntry> shape_operators();

}  // namespace eagerx::gen
