// The table of operators, a row each, and their shared code.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "generator/policy/network/graph/call.hpp"
#include "generator/policy/network/graph/time.hpp"

namespace eagerx::gen {

/// The result for constants.
struct NetFolding {
  float (*reals)(float a, float b) = nullptr;  // in float32, as a runtime of the file calculates it
  std::optional<std::int64_t> (*integers)(std::int64_t a, std::int64_t b) = nullptr;
  bool takes_one = false;  // and leaves b alone
};

/// The parts of LayerNorm and gelu where exporters write them out.
enum class NetFormula : std::uint8_t {
  sum,
  difference,
  product,
  quotient,
  power,
  root,
  erf,
  tanh,
  mean,
};

/// The properties of an operator.
struct NetTraits {
  NetFolding folding{};
  std::optional<NetFormula> formula{};  // of which it may be a part
  /// The result has the shape that the inputs broadcast to. The action may not come through a
  /// refused operator, but its shape may: SAC exports `Expand(mean, Shape(mean + std * noise))`.
  bool keeps_shape = false;
  bool has_weights = false;  // that it multiplies with
  bool has_memory = false;
  /// Result `i` (from 1), if `first` is result 0; nullptr: there is no other.
  NetValue (*later)(const NetCall&, const NetValue& first, int i) = nullptr;
};

/// All there is to say of one operator, under ONNX's name. It cannot be without a rule of time.
struct NetOperator {
  using Run = NetValue (*)(const NetCall&);

  NetOperator(std::string_view called, Run runs, NetTimeRule times, NetTraits has = {})
      : name(called), run(runs), time(times), traits(has) {}

  std::string_view name;
  Run run;           // its shape, and its step; nullptr: it is refused, but what follows is known
  NetTimeRule time;  // nullptr: it may look at anything
  NetTraits traits;
};

/// Operators that compute (layers.cpp), that only move or shape (shapes.cpp), that pick
/// and reorder (order.cpp, gather.cpp), of branches (branches.cpp), with constants
/// (elementwise.cpp), over images (images.cpp), with a memory (recurrent.cpp), that choose
/// (choice.cpp), that compare (conditions.cpp), of whole numbers with a scale (quantized.cpp).
std::vector<NetOperator> layer_operators();
std::vector<NetOperator> shape_operators();
std::vector<NetOperator> order_operators();
std::vector<NetOperator> gather_operators();
std::vector<NetOperator> branch_operators();
std::vector<NetOperator> elementwise_operators();
std::vector<NetOperator> image_operators();
std::vector<NetOperator> recurrent_operators();
std::vector<NetOperator> choice_operators();
std::vector<NetOperator> condition_operators();
std::vector<NetOperator> quantized_operators();

/// The result of an operator all of whose inputs are constants, if it can be calculated.
std::optional<NetValue> folded(const NetCall& call, const NetFolding& folding);

/// Whether the call reduces the last axis of its input, and no other.
bool is_over_last_axis(const NetCall& call);

/// The result for a number of each input; nothing if unknown.
using NetPick = std::function<std::optional<std::int64_t>(const Integers& given)>;
/// The first `inputs` inputs, which are lists of integers, number by number, with NumPy's
/// broadcasting; nothing if they are something else, or do not fit.
std::optional<NetValue> each_of_integers(const NetCall& call, std::size_t inputs,
                                         const NetPick& pick);

/// The small integers that a value represents, if it does.
std::optional<Integers> integers_of(const NetValue& value);

/// A computed shape, or a part of one: a scalar has no axis, a list one.
NetValue integers_value(Integers integers, Dims shape);
NetValue integers_value(Integers integers);

/// The same values in the same order under another shape.
NetValue reshaped(const NetCall& call, const NetValue& x, const std::optional<Dims>& shape);

/// NumPy's broadcasting; nothing where the shapes do not fit.
std::optional<Dims> broadcast(const std::optional<Dims>& a, const std::optional<Dims>& b);

/// True if `bias` adds one value, or `outputs` in order, to a result of shape `result`.
bool fits_as_bias(const NetValue& bias, const Dims& result, std::int64_t outputs);

/// The constant as one number, if it is a single finite one.
std::optional<float> scalar_of(const NetValue& value);

/// The data and the constant of an operator of two inputs; nothing if it has others.
struct NetOperands {
  const NetValue& data;
  const NetValue& constant;
  bool data_left;
};
std::optional<NetOperands> operands_of(const NetCall& call);

/// x op c as one more step; nothing if c cannot be broadcast to x.
std::optional<NetValue> elementwise_step(const NetCall& call, const NetValue& data,
                                         Elementwise::Operation operation,
                                         const NetValue& constant);
/// The larger or the smaller one of two values of the observation's, number by number; nothing as
/// with `combined`.
std::optional<NetValue> larger_of(const NetCall& call, const NetValue& a, const NetValue& b);
std::optional<NetValue> smaller_of(const NetCall& call, const NetValue& a, const NetValue& b);
/// 1 where x is not zero, else 0.
std::optional<NetValue> condition_of(const NetCall& call, const NetValue& x);
/// Two values of the observation's, number by number; nothing unless one of them has the shape of
/// the result, and the other as many numbers or one.
std::optional<NetValue> combined(const NetCall& call, const NetValue& a, const NetValue& b,
                                 Combination::Operation operation);
/// Part of a formula as a separate value, if it is simple: the formula ended early.
std::optional<NetValue> materialized(const NetCall& call, const NetValue& value);
/// A value known only by its order, calculated: where more than a choice depends on it.
std::optional<NetValue> exact_of(const NetValue& value);

/// A reduction whose value is not known, but its shape is.
NetValue shape_of_reduction(const NetCall& call);

/// Several choices side by side: MultiDiscrete.
NetValue joined_choices(const NetCall& call);
/// A tensor of the file.
NetValue constant_value(const NetTensor& tensor);
/// Constants that are not in the file.
NetValue made_constant(const NetCall& call, const std::vector<float>& numbers, const Dims& shape);
NetValue made_constant(const NetCall& call, float number);
/// The result of a formula's next operator, if the inputs are a part of one.
std::optional<NetValue> part_of_formula(const NetCall& call, NetFormula next);
/// x plus or minus one number that is no constant: E0613 if the action depends on more than the
/// order of the result.
std::optional<NetValue> same_order(const NetCall& call, bool adds);
/// Values of shape `from` repeated as NumPy does for `to`; they fit.
std::vector<float> broadcast_to(const std::vector<float>& values, const Dims& from, const Dims& to);
/// Data in another order: number `from[i]` becomes number i.
NetValue reordered(const NetCall& call, const NetValue& data, Reorder order, Dims shape);
/// `count` of the values along an axis, from `first` on, each `step`-th.
NetValue picked(const NetCall& call, const NetValue& x, std::size_t axis, std::int64_t first,
                std::int64_t count, std::int64_t step, bool keeps_axis);

}  // namespace eagerx::gen
