// Operators whose inputs are all constants: exporters leave `sqrt(variance + epsilon)` to whoever
// runs the file.
#include <algorithm>
#include <cmath>
#include <string_view>

#include "generator/formats/onnx/operators/value.hpp"

namespace eagerx::gen {
namespace {

using Kind = OnnxValue::Kind;

/// a op b in float32, as a runtime of the file calculates it; nothing for other operators.
std::optional<float> calculated(std::string_view name, float a, float b) {
  if (name == "Add") return a + b;
  if (name == "Sub") return a - b;
  if (name == "Mul") return a * b;
  if (name == "Div") return a / b;
  if (name == "Max") return std::max(a, b);
  if (name == "Min") return std::min(a, b);
  if (name == "Neg") return -a;
  if (name == "Sqrt") return std::sqrt(a);
  if (name == "Reciprocal") return 1.0F / a;
  return std::nullopt;
}

bool takes_one(std::string_view name) {
  return name == "Neg" || name == "Sqrt" || name == "Reciprocal";
}

/// The same of integers: sizes that are calculated from a shape.
std::optional<std::int64_t> calculated(std::string_view name, std::int64_t a, std::int64_t b) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 30U;
  if (a > kLargest || a < -kLargest || b > kLargest || b < -kLargest) return std::nullopt;
  if (name == "Add") return a + b;
  if (name == "Sub") return a - b;
  if (name == "Mul") return a * b;
  if (name == "Div" && b != 0) return a / b;
  return std::nullopt;
}

std::optional<OnnxValue> folded_integers(const OnnxCall& call) {
  const auto a = integers_of(call.input(0));
  const auto b = integers_of(call.input(1));
  if (!a || !b || a->empty() || b->empty() || a->size() > kMaxOnnxRank ||
      b->size() > kMaxOnnxRank) {
    return std::nullopt;
  }
  const std::size_t count = std::max(a->size(), b->size());
  if ((a->size() != 1 && a->size() != count) || (b->size() != 1 && b->size() != count)) {
    return std::nullopt;
  }
  const auto shape = broadcast(call.input(0).shape, call.input(1).shape);
  if (!shape || element_count(*shape) != static_cast<std::int64_t>(count)) return std::nullopt;
  std::vector<std::int64_t> result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = calculated(call.node().op_type(), (*a)[a->size() == 1 ? 0 : i],
                                  (*b)[b->size() == 1 ? 0 : i]);
    if (!value) return std::nullopt;
    result.push_back(*value);
  }
  return integers_value(std::move(result), *shape);
}

std::optional<std::vector<float>> numbers_of(const OnnxValue& value) {
  PolicyProblem ignored;
  if (value.kind != Kind::constant || value.constant.transposed) return std::nullopt;
  return read_floats(value.constant, ignored);
}

}  // namespace

std::vector<float> broadcast_to(const std::vector<float>& values, const Dims& from,
                                const Dims& to) {
  std::vector<float> result;
  const auto count = static_cast<std::size_t>(element_count(to).value_or(0));
  result.reserve(count);
  const std::size_t offset = to.size() - from.size();
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    std::size_t at = 0;
    std::size_t stride = 1;
    for (std::size_t axis = to.size(); axis-- > offset;) {
      const auto size = static_cast<std::size_t>(to[axis]);
      const auto own = static_cast<std::size_t>(from[axis - offset]);
      at += own == 1 ? 0 : (rest % size) * stride;
      stride *= own;
      rest /= size;
    }
    result.push_back(values[at]);
  }
  return result;
}

std::optional<OnnxValue> folded(const OnnxCall& call) {
  const std::string& name = call.node().op_type();
  const OnnxValue& a = call.input(0);
  const OnnxValue& b = call.input(1);
  const bool unary = call.input_count() == 1;
  if (auto value = folded_integers(call)) return value;
  if (call.input_count() > 2 || a.kind != Kind::constant || !calculated(name, 1.0F, 1.0F) ||
      takes_one(name) != unary || (!unary && b.kind != Kind::constant)) {
    return std::nullopt;
  }
  const auto shape = unary ? a.shape : broadcast(a.shape, b.shape);
  const std::int64_t count = shape ? element_count(*shape).value_or(kMaxElements) : kMaxElements;
  if (count > kMaxValues) return std::nullopt;
  // A result without numbers may be of many: [1000000, 1] and [1, 0].
  const auto read = [](const OnnxValue& value) {
    return value.kind == Kind::constant ? element_count(value.constant.dims).value_or(0) : 0;
  };
  if (!call.spend(8 * count + read(a) + read(b))) return call.too_much();
  auto left = numbers_of(a);
  auto right = unary ? std::optional(std::vector<float>{0.0F}) : numbers_of(b);
  if (!left || !right || left->empty() || right->empty()) return std::nullopt;
  *left = broadcast_to(*left, a.constant.dims, *shape);
  *right = broadcast_to(*right, unary ? Dims{} : b.constant.dims, *shape);
  for (std::size_t i = 0; i < left->size(); ++i) {
    (*left)[i] = *calculated(name, (*left)[i], (*right)[i]);
  }
  return made_constant(call, *left, *shape);
}

}  // namespace eagerx::gen
