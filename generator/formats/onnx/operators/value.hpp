// What is known about a value of an ONNX graph without running it, and the operators over such
// values.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "generator/formats/onnx/onnx.pb.h"
#include "generator/formats/onnx/operators/tensor.hpp"
#include "generator/network/layer.hpp"
#include "generator/network/limits.hpp"

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
  std::optional<OnnxConstant> gamma;
  std::optional<OnnxConstant> beta;
  float epsilon = 1e-5F;
};

struct OnnxConvolution {
  Convolution form;
  OnnxConstant weights;  // [channels, channels read / groups, rows, columns]
  std::optional<OnnxConstant> bias;
};

/// Zeros around an image, for the pool or convolution behind it.
struct OnnxPad {
  std::uint32_t top = 0, left = 0, bottom = 0, right = 0;
};

/// Where a layer's state comes from: layer `slot` of input `name`.
struct OnnxStateSource {
  std::string_view name;
  std::int64_t slot = 0;
};

/// A GRU or LSTM with ONNX's gates: z, r, h and i, o, f, c.
struct OnnxRecurrence {
  bool is_lstm = false;
  OnnxConstant weights;                 // [1, gates * hidden, inputs]
  OnnxConstant hidden_weights;          // [1, gates * hidden, hidden]
  std::optional<OnnxConstant> bias;     // [1, 2 * gates * hidden]: of the input, of the state
  std::optional<OnnxStateSource> h, c;  // nothing: zeros at the start of an episode
};

/// x op c; `shape` is what c is broadcast to.
struct OnnxElementwise {
  Elementwise::Operation operation = Elementwise::Operation::add;
  OnnxConstant constant;
  Dims shape;
};

using OnnxWork =
    std::variant<OnnxDense, OnnxActivation, OnnxNorm, OnnxConvolution, Pooling, OnnxPad,
                 OnnxRecurrence, OnnxElementwise, Reorder, Combination, Function, Reduction>;

/// One thing that is done to the observation on its way. Branches share their start, and a
/// Combination takes several.
struct OnnxStep {
  std::int32_t before = -1;  // index of the step before, -1 for the observation itself
  OnnxWork what;
  std::string node;                  // printable name
  std::int64_t count = 0;            // values after it
  std::vector<std::int32_t> more{};  // Combination: the steps of its other values
};

/// Part of a state after an observation: h or c of the layer of `step`.
struct OnnxRemembered {
  std::int32_t step = -1;
  bool is_cell = false;
};

/// A value on the way of a formula that exporters write out: LayerNorm and gelu. All are of the
/// data x after step `of`.
struct OnnxPart {
  enum class Role : std::uint8_t {
    none,
    mean,            // mean(x)
    centred,         // x - mean(x)
    centred_square,  // (x - mean(x))²
    variance,        // its mean, plus epsilon
    deviation,       // the root of that
    erf,             // erf(x / sqrt(2)), or tanh(sqrt(2 / pi) (x + 0.044715 x³)) where `by_tanh`
    one_plus_erf,    //
    half_plus_erf,   // half of it
    twice_gelu,      // x (1 + erf)
    square,          // x²
    cube,            // x³
    cubic,           // 0.044715 x³
    gelu_sum,        // x + 0.044715 x³
    gelu_inner,      // sqrt(2 / pi) of it
    ordered,         // values in the order of x: softmax(x), x plus one number
    choice,          // the index of the largest x
  };
  Role role = Role::none;
  std::int32_t of = -1;
  bool by_tanh = false;
  float epsilon = 0.0F;
  std::int32_t exact = -1;  // ordered: the step that calculates it all the same, if there is one
};

/// A value of the graph.
struct OnnxValue {
  enum class Kind : std::uint8_t {
    absent,    // an optional input that is not given
    constant,  // a tensor of the file
    integers,  // a shape that was computed
    data,      // the observation after `step`, in row-major order
    state,     // layers `slot` to `slot + slots` of the state that input `state` is
    other,     // anything else: `problem` says why the action must not depend on it
  };
  Kind kind = Kind::absent;
  std::optional<Dims> shape;  // where known
  std::uint32_t time = 0;     // bit i: axis i may be the steps of a sequence
  OnnxConstant constant;
  std::vector<std::int64_t> integers;
  std::int32_t step = -1;
  OnnxStateSource state;
  std::int64_t slots = 0;
  std::vector<OnnxRemembered> remembered;  // layer by layer, if this is a new state
  OnnxPart part;
  bool is_zero = false;       // other: all zeros
  bool is_condition = false;  // data: each number is 1 or 0
  PolicyProblem problem;
};

/// What an operator sees.
class OnnxCall {
 public:
  struct State {  // shared by all calls of a graph
    std::int64_t opset = 0;
    std::int64_t observed = 0;  // values of the observation
    bool is_sequence = false;   // the observation has time as an axis of any length
    bool follows_time = false;  // and no state is an input: the sequence starts an episode
    std::int64_t budget = std::int64_t{64} << 20U;  // values that may still be looked at
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
  /// Whether input `i` is given, but is no list of integers that are known: what it leaves open
  /// must not become what the operator does without it.
  [[nodiscard]] bool is_unreadable(std::size_t i) const;

  /// "operator `Gemm` (node `/mu/Gemm`)".
  [[nodiscard]] std::string who() const;
  /// A value that the action must not depend on. If an input already is one, its problem comes
  /// first.
  [[nodiscard]] OnnxValue other(PolicyProblem problem, std::optional<Dims> shape = {}) const;
  /// E0613: the operator is known, but not used like this.
  [[nodiscard]] OnnxValue misused(const std::string& how, std::optional<Dims> shape = {}) const;
  /// Whether `values` more values may be looked at or moved: a file may name the same large tensor
  /// a million times.
  [[nodiscard]] bool spend(std::int64_t values) const {
    state_.budget -= values;
    return state_.budget >= 0;
  }
  /// E0619: not.
  [[nodiscard]] OnnxValue too_much() const;
  /// The observation after one more step.
  [[nodiscard]] OnnxValue data_after(std::int32_t before, OnnxWork what, Dims shape) const;
  /// What comes of several values of the observation's, in order.
  [[nodiscard]] OnnxValue data_of(const std::vector<OnnxValue>& values,
                                  Combination::Operation operation, Dims shape) const;

 private:
  const onnx::NodeProto& node_;
  std::vector<const OnnxValue*> inputs_;
  State& state_;
};

/// The small integers a value stands for, if it does.
std::optional<std::vector<std::int64_t>> integers_of(const OnnxValue& value);

/// A computed shape, or a part of one: a scalar has no axis, a list one.
OnnxValue integers_value(std::vector<std::int64_t> integers, Dims shape);
OnnxValue integers_value(std::vector<std::int64_t> integers);

/// The same values in the same order under another shape.
OnnxValue reshaped(const OnnxCall& call, const OnnxValue& x, const std::optional<Dims>& shape);

/// NumPy's broadcasting; nothing where the shapes do not fit.
std::optional<Dims> broadcast(const std::optional<Dims>& a, const std::optional<Dims>& b);

/// True if `bias` adds one value, or `outputs` in order, to a result of shape `result`.
bool fits_as_bias(const OnnxValue& bias, const Dims& result, std::int64_t outputs);

/// The constant as one number, if it is a single finite one.
std::optional<float> scalar_of(const OnnxValue& value);

/// x op c as one more step; nothing if c cannot be broadcast to x.
std::optional<OnnxValue> elementwise_step(const OnnxCall& call, const OnnxValue& data,
                                          Elementwise::Operation operation,
                                          const OnnxValue& constant);
/// The larger or the smaller one of two values of the observation's, number by number; nothing as
/// with `combined`.
std::optional<OnnxValue> larger_of(const OnnxCall& call, const OnnxValue& a, const OnnxValue& b);
std::optional<OnnxValue> smaller_of(const OnnxCall& call, const OnnxValue& a, const OnnxValue& b);
/// 1 where x is not zero, else 0.
std::optional<OnnxValue> condition_of(const OnnxCall& call, const OnnxValue& x);
/// Two values of the observation's, number by number; nothing unless one of them has the shape of
/// the result, and the other as many numbers or one.
std::optional<OnnxValue> combined(const OnnxCall& call, const OnnxValue& a, const OnnxValue& b,
                                  Combination::Operation operation);
/// The part of a formula as a value of its own, if it is a simple one: the formula did not go on.
std::optional<OnnxValue> materialized(const OnnxCall& call, const OnnxValue& value);
/// What is only known by its order, calculated: where more than a choice depends on it.
std::optional<OnnxValue> exact_of(const OnnxValue& value);
/// Constants that are not in the file.
OnnxValue made_constant(const OnnxCall& call, const std::vector<float>& numbers, const Dims& shape);
OnnxValue made_constant(const OnnxCall& call, float number);
/// The result of a formula's next operator, if the inputs are a part of one.
std::optional<OnnxValue> part_of_formula(const OnnxCall& call);
/// x plus or minus one number that is no constant: E0613 if the action depends on more than the
/// order of the result.
std::optional<OnnxValue> same_order(const OnnxCall& call);
/// The result of an operator all of whose inputs are constants, if it can be calculated.
std::optional<OnnxValue> folded(const OnnxCall& call);
/// Values of shape `from` repeated as NumPy does for `to`; they fit.
std::vector<float> broadcast_to(const std::vector<float>& values, const Dims& from, const Dims& to);
/// Data in another order: number `from[i]` becomes number i.
OnnxValue reordered(const OnnxCall& call, const OnnxValue& data, Reorder order, Dims shape);
/// `count` of the values along an axis, from `first` on, each `step`-th.
OnnxValue picked(const OnnxCall& call, const OnnxValue& x, std::size_t axis, std::int64_t first,
                 std::int64_t count, std::int64_t step, bool keeps_axis);
/// Output `i` of a Split.
OnnxValue split_part(const OnnxCall& call, int i);
/// Output `i` (from 1) of a node whose first one is `first`.
OnnxValue later_output(const OnnxCall& call, const OnnxValue& first, int i);

/// `value`, a result of the call, with its axis of time; E0613 where steps of a sequence would be
/// mixed, picked or lost.
OnnxValue along_time(const OnnxCall& call, OnnxValue value);

/// The first output of the node. Never fails: what cannot be represented is of kind `other`.
OnnxValue evaluate(const OnnxCall& call);

using OnnxOperator = OnnxValue (*)(const OnnxCall&);
struct OnnxOperatorEntry {
  std::string_view name;
  OnnxOperator run;
};
/// Operators that compute (layers.cpp), that only move or shape (shapes.cpp), that pick
/// and reorder (order.cpp, gather.cpp), of branches (branches.cpp), with constants
/// (elementwise.cpp), over images (convolution.cpp), with a memory (recurrent.cpp), that choose
/// (choice.cpp), that compare (conditions.cpp).
std::vector<OnnxOperatorEntry> layer_operators();
std::vector<OnnxOperatorEntry> shape_operators();
std::vector<OnnxOperatorEntry> order_operators();
std::vector<OnnxOperatorEntry> gather_operators();
std::vector<OnnxOperatorEntry> branch_operators();
std::vector<OnnxOperatorEntry> elementwise_operators();
std::vector<OnnxOperatorEntry> image_operators();
std::vector<OnnxOperatorEntry> recurrent_operators();
std::vector<OnnxOperatorEntry> choice_operators();
std::vector<OnnxOperatorEntry> condition_operators();

}  // namespace eagerx::gen
