// Branches that come together, and functions and sums of numbers.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "generator/formats/onnx/operators/value.hpp"

namespace eagerx::gen {
namespace {

using Kind = OnnxValue::Kind;
using Role = OnnxPart::Role;

OnnxValue function(const OnnxCall& call, Function::Kind kind) {
  const OnnxValue& x = call.input(0);
  if (x.kind != Kind::data) return call.misused("on a constant", x.shape);
  return call.data_after(x.step, Function{kind}, *x.shape);
}
OnnxValue sine(const OnnxCall& call) {
  return function(call, Function::Kind::sin);
}
OnnxValue cosine(const OnnxCall& call) {
  return function(call, Function::Kind::cos);
}
OnnxValue exponential(const OnnxCall& call) {
  return function(call, Function::Kind::exp);
}
OnnxValue absolute(const OnnxCall& call) {
  return function(call, Function::Kind::abs);
}
OnnxValue root(const OnnxCall& call) {
  if (const auto part = part_of_formula(call)) return *part;
  return function(call, Function::Kind::sqrt);
}

/// Over the last axis.
OnnxValue norm(const OnnxCall& call) {
  const OnnxValue& x = call.input(0);
  const auto axes = call.integers(1, "axes");
  const auto rank = static_cast<std::int64_t>(x.shape ? x.shape->size() : 0);
  const bool last =
      axes && axes->size() == 1 && rank > 0 && (axes->front() == -1 || axes->front() == rank - 1);
  if (x.kind != Kind::data || !last) return call.misused("that is not over the last axis");
  Dims shape = *x.shape;
  shape.back() = 1;
  if (call.integer("keepdims", 1) == 0) shape.pop_back();
  const Reduction work{Reduction::Kind::norm, static_cast<std::uint32_t>(x.shape->back())};
  return call.data_after(x.step, work, std::move(shape));
}

}  // namespace

std::optional<OnnxValue> combined(const OnnxCall& call, const OnnxValue& a, const OnnxValue& b,
                                  Combination::Operation operation) {
  if (a.kind != Kind::data || b.kind != Kind::data) return std::nullopt;
  const std::optional<Dims> shape = broadcast(a.shape, b.shape);
  if (!shape) return std::nullopt;
  const auto count = element_count(*shape);
  for (const OnnxValue* value : {&a, &b}) {
    const auto own = element_count(*value->shape);
    if (own != count && own != 1) return std::nullopt;  // an outer product, or rows
  }
  return call.data_of({a, b}, operation, *shape);
}

std::optional<OnnxValue> materialized(const OnnxCall& call, const OnnxValue& value) {
  if (auto exact = exact_of(value)) return exact;
  const OnnxPart& part = value.part;
  const bool simple =
      part.role == Role::mean || part.role == Role::square || part.role == Role::centred;
  if (value.kind != Kind::other || !simple || !value.shape) return std::nullopt;
  const std::int64_t count = part.of < 0
                                 ? call.state().observed
                                 : call.state().steps[static_cast<std::size_t>(part.of)].count;
  OnnxValue x;
  x.kind = Kind::data;
  x.step = part.of;
  x.shape = part.role == Role::mean ? Dims{count} : *value.shape;
  OnnxValue result;
  if (part.role == Role::square) {
    result = call.data_of({x, x}, Combination::Operation::product, *value.shape);
  } else {
    const Reduction work{Reduction::Kind::mean, static_cast<std::uint32_t>(count)};
    result = call.data_after(part.of, work, part.role == Role::mean ? *value.shape : Dims{1});
    if (part.role == Role::centred && result.kind == Kind::data) {
      result = call.data_of({x, result}, Combination::Operation::difference, *value.shape);
    }
  }
  if (result.kind != Kind::data) return std::nullopt;
  result.time = value.time;
  return result;
}

std::vector<OnnxOperatorEntry> branch_operators() {
  return {{"Sin", sine},     {"Cos", cosine}, {"Exp", exponential},
          {"Abs", absolute}, {"Sqrt", root},  {"ReduceL2", norm}};
}

}  // namespace eagerx::gen
