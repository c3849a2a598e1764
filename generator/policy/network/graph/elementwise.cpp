// Operators with a constant for all numbers, or one for each: scaling, shifting, clipping; biases.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using Operation = Elementwise::Operation;

/// True if every value of the (small) constant is zero.
bool is_all_zero(const NetConstant& constant) {
  PolicyProblem ignored;
  const auto values = read_floats(constant, ignored);
  return values && std::all_of(values->begin(), values->end(), [](float v) { return v == 0.0F; });
}

NetValue with_constant(const NetCall& call, Operation operation) {
  const std::optional<Dims> shape = broadcast(call.input(0).shape, call.input(1).shape);
  const auto operands = operands_of(call);
  if (!operands) return call.misused("that is not of a layer and a constant", shape);
  const auto value = elementwise_step(call, operands->data, operation, operands->constant);
  return value ? *value
               : call.misused(fmt::format("on shapes {} and {}", show(*call.input(0).shape),
                                          show(*call.input(1).shape)),
                              shape);
}

/// A bias of the product before, or a constant that is added.
NetValue added(const NetCall& call) {
  const auto operands = operands_of(call);
  const std::optional<Dims> sum = broadcast(call.input(0).shape, call.input(1).shape);
  if (!operands) {
    if (auto value = combined(call, call.input(0), call.input(1), Combination::Operation::sum)) {
      return *value;
    }
  }
  if (!operands || !sum) return call.misused("that does not add a constant to a layer", sum);
  const NetValue& data = operands->data;
  const std::int64_t outputs = element_count(*data.shape).value_or(0);
  if (!call.spend(element_count(operands->constant.constant.dims).value_or(0))) {
    return call.too_much();
  }
  if (element_count(*sum) == outputs && is_all_zero(operands->constant.constant)) {
    NetValue same = data;
    same.shape = sum;
    return same;
  }
  const NetStep* step = call.step_of(data);
  if (step != nullptr && step->form<Dense>() != nullptr && !std::get<NetLayer>(step->what).bias &&
      fits_as_bias(operands->constant, *data.shape, outputs)) {
    auto biased = std::get<NetLayer>(step->what);
    biased.bias = operands->constant.constant;
    return call.data_after(std::int32_t{step->before}, std::move(biased), *sum);
  }
  return with_constant(call, Operation::add);
}

NetValue add(const NetCall& call) {
  if (!operands_of(call)) {
    if (auto value = same_order(call, true)) return *value;
  }
  return added(call);
}

NetValue subtract(const NetCall& call) {
  const auto operands = operands_of(call);
  if (!operands) {
    if (auto value = same_order(call, false)) return *value;
    if (auto value =
            combined(call, call.input(0), call.input(1), Combination::Operation::difference)) {
      return *value;
    }
  }
  if (!operands || operands->data_left) return with_constant(call, Operation::subtract);
  // c - x is (-1 x) + c, to the bit.
  const auto negative =
      elementwise_step(call, operands->data, Operation::multiply, made_constant(call, -1.0F));
  const auto value = negative && negative->kind == Kind::data
                         ? elementwise_step(call, *negative, Operation::add, operands->constant)
                         : std::nullopt;
  return value ? *value : call.misused("on shapes that do not fit");
}

NetValue divide(const NetCall& call) {
  const auto operands = operands_of(call);
  if (operands && !operands->data_left) return call.misused("of a constant by a layer");
  if (auto value = combined(call, call.input(0), call.input(1), Combination::Operation::quotient)) {
    return *value;
  }
  return with_constant(call, Operation::divide);
}

NetValue negate(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (x.kind != Kind::data) return call.misused("on a constant", x.shape);
  const auto value = elementwise_step(call, x, Operation::multiply, made_constant(call, -1.0F));
  return value ? *value : call.misused("on an unknown shape", x.shape);
}

/// x sigmoid(x), as torch exports SiLU; parts of formulas; a factor.
NetValue multiply(const NetCall& call) {
  const NetValue& a = call.input(0);
  const NetValue& b = call.input(1);
  if (a.kind != Kind::data || b.kind != Kind::data) return with_constant(call, Operation::multiply);
  const auto shape = broadcast(a.shape, b.shape);
  const bool each = shape && element_count(*shape) == element_count(*a.shape);  // no outer product
  for (const auto& [x, gate] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    const NetStep* step = call.step_of(*gate);
    const auto* work = step != nullptr && each ? std::get_if<NetActivation>(&step->what) : nullptr;
    if (work != nullptr && work->kind == Activation::sigmoid && step->before == x->step) {
      return call.data_after(x->step, NetActivation{Activation::silu}, *shape);
    }
  }
  if (auto value = combined(call, a, b, Combination::Operation::product)) return *value;
  return call.misused("on shapes that do not fit", shape);
}

/// One bound of a Clip, which may be infinite; nothing if there is none; `known` is false if it is
/// computed.
struct Bound {
  std::optional<float> value;
  bool known = true;
};

Bound bound_of(const NetCall& call, std::size_t i, std::string_view name) {
  if (call.attribute(name) != nullptr) return {call.real(name, 0.0F), true};
  const NetValue& input = call.input(i);
  if (input.kind == Kind::absent) return {};
  PolicyProblem ignored;
  if (input.kind != Kind::constant || element_count(input.constant.dims) != 1) return {{}, false};
  if (const auto infinite = infinity_of(input.constant)) return {infinite, true};
  const auto values = read_floats(input.constant, ignored);
  return values ? Bound{values->front(), true} : Bound{{}, false};
}

NetValue clip(const NetCall& call) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const NetValue& x = call.input(0);
  const Bound low = bound_of(call, 1, "min");
  const Bound high = bound_of(call, 2, "max");
  if (x.kind != Kind::data || !low.known || !high.known) {
    return call.misused("whose bounds are not constant", x.shape);
  }
  const bool no_high = !high.value || *high.value >= kLargest;
  const bool no_low = !low.value || *low.value <= -kLargest;
  if (no_high && !no_low && *low.value == 0.0F) {
    return call.data_after(x.step, NetActivation{Activation::relu}, *x.shape);
  }
  NetValue value = x;
  for (const auto& [skip, operation, bound] :
       {std::tuple{no_low, Operation::at_least, low.value},
        std::tuple{no_high, Operation::at_most, high.value}}) {
    if (skip || value.kind != Kind::data) continue;
    const auto clipped = elementwise_step(call, value, operation, made_constant(call, *bound));
    if (!clipped) return call.misused("of an unknown shape", x.shape);
    value = *clipped;
  }
  return value;
}

template <Operation What>
NetValue limit(const NetCall& call) {
  if (call.input_count() == 1) return call.input(0);
  if (call.input_count() != 2) return call.misused("of several values", call.input(0).shape);
  const NetValue& a = call.input(0);
  const NetValue& b = call.input(1);
  if (a.kind == Kind::data && b.kind == Kind::data) {
    const auto value = What == Operation::at_least ? larger_of(call, a, b) : smaller_of(call, a, b);
    if (value) return *value;
  }
  return with_constant(call, What);
}

/// Of two inputs.
NetValue sum(const NetCall& call) {
  if (call.input_count() == 1) return call.input(0);
  if (call.input_count() != 2) return call.misused("of several values", call.input(0).shape);
  return added(call);
}

/// gamma elu(x).
NetValue selu(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (x.kind != Kind::data) return call.misused("on a constant", x.shape);
  const NetActivation elu{Activation::elu, call.real("alpha", 1.67326319F)};
  const NetValue curve = call.data_after(x.step, elu, *x.shape);
  const auto value = elementwise_step(call, curve, Operation::multiply,
                                      made_constant(call, call.real("gamma", 1.05070102F)));
  return value ? *value : call.misused("on an unknown shape", x.shape);
}

NetValue formula_only(const NetCall& call) {
  return call.misused("that is not a part of a LayerNorm or a gelu", call.input(0).shape);
}

/// (x - mean) * (scale / sqrt(variance + epsilon)) + offset, of a trained layer.
NetValue batch_normalization(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (x.kind != Kind::data || call.integer("training_mode", 0) != 0 || x.shape->size() < 2) {
    return call.misused("that is not of a layer", x.shape);
  }
  if (!call.spend(8 * (*x.shape)[1])) return call.too_much();
  std::array<std::vector<float>, 4> parts;  // scale, offset, mean, variance
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PolicyProblem problem;
    const NetValue& part = call.input(i + 1);
    if (part.kind != Kind::constant) return call.misused("without constant statistics", x.shape);
    if (part.constant.dims != Dims{(*x.shape)[1]}) {
      return call.misused("with statistics of another size", x.shape);
    }
    auto values = read_floats(part.constant, problem);
    if (!values) return call.other(problem, x.shape);
    parts[i] = std::move(*values);
  }
  const auto epsilon = static_cast<double>(call.real("epsilon", 1e-5F));
  std::vector<float> factors;
  for (std::size_t i = 0; i < parts[0].size(); ++i) {
    const double factor =
        static_cast<double>(parts[0][i]) / std::sqrt(static_cast<double>(parts[3][i]) + epsilon);
    factors.push_back(static_cast<float>(factor));
  }
  NetValue value = x;
  const std::array<std::pair<Operation, const std::vector<float>*>, 3> steps = {
      std::pair{Operation::subtract, &parts[2]}, std::pair{Operation::multiply, &factors},
      std::pair{Operation::add, &parts[1]}};
  for (const auto& [operation, numbers] : steps) {
    if (value.kind != Kind::data) return value;
    Dims shape(x.shape->size() - 1, 1);
    shape[0] = (*x.shape)[1];
    const auto next =
        elementwise_step(call, value, operation, made_constant(call, *numbers, shape));
    if (!next) return call.misused("of an unknown shape", x.shape);
    value = *next;
  }
  return value;
}

}  // namespace

std::optional<NetOperands> operands_of(const NetCall& call) {
  const NetValue& a = call.input(0);
  const NetValue& b = call.input(1);
  if (a.kind == Kind::data && b.kind == Kind::constant) return NetOperands{a, b, true};
  if (a.kind == Kind::constant && b.kind == Kind::data) return NetOperands{b, a, false};
  return std::nullopt;
}

NetValue made_constant(const NetCall& call, const std::vector<float>& numbers, const Dims& shape) {
  return constant_value(made_tensor(call.state().made, call.node().output, numbers, shape));
}

NetValue made_constant(const NetCall& call, float number) {
  return made_constant(call, std::vector<float>{number}, {});
}

std::optional<NetValue> elementwise_step(const NetCall& call, const NetValue& data,
                                         Operation operation, const NetValue& constant) {
  if (data.kind != Kind::data || !data.shape || constant.kind != Kind::constant ||
      constant.constant.transposed) {
    return std::nullopt;
  }
  const std::optional<Dims> shape = broadcast(data.shape, constant.shape);
  if (!shape || element_count(*shape) != element_count(*data.shape)) return std::nullopt;
  return call.data_after(
      data.step, NetLayer{Elementwise{operation}, {}, constant.constant, 1.0F, 1.0F, *shape},
      *shape);
}

std::vector<NetOperator> elementwise_operators() {
  using std::int64_t;
  using Whole = std::optional<int64_t>;
  const NetFolding sums = {[](float a, float b) { return a + b; },
                           [](int64_t a, int64_t b) -> Whole { return a + b; }};
  const NetFolding differences = {[](float a, float b) { return a - b; },
                                  [](int64_t a, int64_t b) -> Whole { return a - b; }};
  const NetFolding products = {[](float a, float b) { return a * b; },
                               [](int64_t a, int64_t b) -> Whole { return a * b; }};
  const NetFolding quotients = {
      [](float a, float b) { return a / b; },
      [](int64_t a, int64_t b) -> Whole { return b != 0 ? Whole(a / b) : std::nullopt; }};
  const NetFolding largest = {[](float a, float b) { return std::max(a, b); }};
  const NetFolding smallest = {[](float a, float b) { return std::min(a, b); }};
  const NetFolding opposite = {[](float a, float) { return -a; }, nullptr, true};
  const NetFolding inverse = {[](float a, float) { return 1.0F / a; }, nullptr, true};
  return {
      {"Add", add, time_of_each, {.folding = sums, .formula = NetFormula::sum}},
      {"Sub",
       subtract,
       time_of_each,
       {.folding = differences, .formula = NetFormula::difference, .keeps_shape = true}},
      {"Mul",
       multiply,
       time_of_each,
       {.folding = products, .formula = NetFormula::product, .keeps_shape = true}},
      {"Div",
       divide,
       time_of_each,
       {.folding = quotients, .formula = NetFormula::quotient, .keeps_shape = true}},
      {"Neg", negate, time_of_each, {.folding = opposite, .keeps_shape = true}},
      {"Reciprocal", nullptr, nullptr, {.folding = inverse}},
      {"Clip", clip, time_of_each},
      {"Max", limit<Operation::at_least>, time_of_each, {.folding = largest, .keeps_shape = true}},
      {"Min", limit<Operation::at_most>, time_of_each, {.folding = smallest, .keeps_shape = true}},
      {"Sum", sum, time_of_each, {.keeps_shape = true}},
      {"Selu", selu, time_of_each, {.keeps_shape = true}},
      {"Erf", formula_only, time_of_each, {.formula = NetFormula::erf, .keeps_shape = true}},
      {"BatchNormalization", batch_normalization, time_but_channels}};
}

}  // namespace eagerx::gen
