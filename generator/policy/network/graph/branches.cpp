// Operators that join branches, and functions and sums of numbers.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <eagerx/math/rounding.hpp>
#include <utility>

#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using Role = NetPart::Role;

template <Function::Kind What>
NetValue function(const NetCall& call) {
  const NetValue& x = call.input(0);
  if (x.kind != Kind::data) return call.misused("on a constant", x.shape);
  return call.layer_after(x.step, Function{What}, *x.shape);
}

/// Of `x` over the last axis of the call's input.
NetValue reduced(const NetCall& call, const NetValue& x, Reduction::Kind kind) {
  Dims shape = *x.shape;
  shape.back() = 1;
  if (call.integer("keepdims", 1) == 0) shape.pop_back();
  const Reduction work{kind, static_cast<std::uint32_t>(x.shape->back())};
  return call.layer_after(x.step, work, std::move(shape));
}

bool is_reducible(const NetCall& call) {
  return call.input(0).kind == Kind::data && is_over_last_axis(call);
}
NetValue norm(const NetCall& call) {
  if (!is_reducible(call)) return call.misused("that is not over the last axis");
  return reduced(call, call.input(0), Reduction::Kind::norm);
}
/// Not over the last axis its value is refused, but its shape is known.
NetValue sum_over_axis(const NetCall& call) {
  if (!is_reducible(call)) return shape_of_reduction(call);
  return reduced(call, call.input(0), Reduction::Kind::sum);
}
NetValue sum_of_magnitudes(const NetCall& call) {
  if (!is_reducible(call)) return call.misused("that is not over the last axis");
  const NetValue& x = call.input(0);
  const NetValue each = call.layer_after(x.step, Function{Function::Kind::abs}, *x.shape);
  return each.kind == Kind::data ? reduced(call, each, Reduction::Kind::sum) : each;
}
NetValue sum_of_squares(const NetCall& call) {
  if (!is_reducible(call)) return call.misused("that is not over the last axis");
  const NetValue& x = call.input(0);
  const NetValue each = call.data_of({x, x}, Combination::Operation::product, *x.shape);
  return each.kind == Kind::data ? reduced(call, each, Reduction::Kind::sum) : each;
}

/// A whole exponent as a product, 0.5 as a root. Squares and cubes are parts of a formula first.
NetValue power(const NetCall& call) {
  const NetValue& x = call.input(0);
  const auto exponent = scalar_of(call.input(1));
  if (x.kind != Kind::data || !exponent)
    return call.misused("without a constant exponent", x.shape);
  if (*exponent == 0.5F) return call.layer_after(x.step, Function{Function::Kind::sqrt}, *x.shape);
  if (*exponent == 1.0F) return x;
  constexpr float kMost = 8.0F;
  if (*exponent != std::floor(*exponent) || *exponent < 2.0F || *exponent > kMost) {
    return call.misused("with an exponent other than 0.5, or 1 to 8", x.shape);
  }
  NetValue result = x;
  for (float done = 1.0F; done < *exponent && result.kind == Kind::data; done += 1.0F) {
    result = call.data_of({result, x}, Combination::Operation::product, *x.shape);
  }
  return result;
}

}  // namespace

std::optional<NetValue> combined(const NetCall& call, const NetValue& a, const NetValue& b,
                                 Combination::Operation operation) {
  if (a.kind != Kind::data || b.kind != Kind::data) return std::nullopt;
  const std::optional<Dims> shape = broadcast(a.shape, b.shape);
  if (!shape) return std::nullopt;
  const auto count = element_count(*shape);
  for (const NetValue* value : {&a, &b}) {
    const auto own = element_count(*value->shape);
    if (own != count && own != 1) return std::nullopt;  // an outer product, or rows
  }
  return call.data_of({a, b}, operation, *shape);
}

std::optional<NetValue> materialized(const NetCall& call, const NetValue& value) {
  if (auto exact = exact_of(value)) return exact;
  const NetPart& part = value.part;
  const bool simple = part.role == Role::mean || part.role == Role::square ||
                      part.role == Role::cube || part.role == Role::centred;
  if (value.kind != Kind::other || !simple || !value.shape) return std::nullopt;
  const std::int64_t count = call.count_after(part.of);
  const NetValue x = data_value(part.of, part.role == Role::mean ? Dims{count} : *value.shape);
  NetValue result;
  if (part.role == Role::square || part.role == Role::cube) {
    result = call.data_of({x, x}, Combination::Operation::product, *value.shape);
    if (part.role == Role::cube && result.kind == Kind::data)
      result = call.data_of({result, x}, Combination::Operation::product, *value.shape);
  } else {
    const Reduction work{Reduction::Kind::mean, static_cast<std::uint32_t>(count)};
    result = call.layer_after(part.of, work, part.role == Role::mean ? *value.shape : Dims{1});
    if (part.role == Role::centred && result.kind == Kind::data) {
      result = call.data_of({x, result}, Combination::Operation::difference, *value.shape);
    }
  }
  if (result.kind != Kind::data) return std::nullopt;
  result.time = value.time;
  return result;
}

std::vector<NetOperator> branch_operators() {
  using F = Function::Kind;
  const NetFolding roots = {[](float a, float) { return std::sqrt(a); }, nullptr, true};
  const NetFolding upwards = {[](float a, float) { return std::ceil(a); }, nullptr, true};
  const NetFolding downwards = {[](float a, float) { return std::floor(a); }, nullptr, true};
  const NetFolding nearest = {[](float a, float) { return round_to_even(a); }, nullptr, true};
  return {{"Sin", function<F::sin>, time_of_each, {.keeps_shape = true}},
          {"Cos", function<F::cos>, time_of_each, {.keeps_shape = true}},
          {"Exp", function<F::exp>, time_of_each, {.keeps_shape = true}},
          {"Abs", function<F::abs>, time_of_each, {.keeps_shape = true}},
          {"Sqrt",
           function<F::sqrt>,
           time_of_each,
           {.folding = roots, .formula = NetFormula::root, .keeps_shape = true}},
          {"ReduceL1", sum_of_magnitudes, time_of_reduce},
          {"ReduceL2", norm, time_of_reduce},
          {"ReduceSum", sum_over_axis, time_of_reduce},
          {"ReduceSumSquare", sum_of_squares, time_of_reduce},
          {"Ceil", function<F::ceil>, time_of_each, {.folding = upwards, .keeps_shape = true}},
          {"Floor", function<F::floor>, time_of_each, {.folding = downwards, .keeps_shape = true}},
          {"Round",
           function<F::round_to_even>,
           time_of_each,
           {.folding = nearest, .keeps_shape = true}},
          {"Pow", power, time_of_each, {.formula = NetFormula::power, .keeps_shape = true}},
          // Refused, but random parts of an action are made of them.
          {"HardSigmoid", nullptr, nullptr, {.keeps_shape = true}},
          {"Log", nullptr, nullptr, {.keeps_shape = true}},
          {"Mod", nullptr, nullptr, {.keeps_shape = true}},
          {"RandomNormalLike", nullptr, nullptr, {.keeps_shape = true}},
          {"Softsign", nullptr, nullptr, {.keeps_shape = true}}};
}

}  // namespace eagerx::gen
