// Operators whose inputs are all constants: exporters leave `sqrt(variance + epsilon)` to whoever
// runs the file.
#include <algorithm>

#include "generator/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

/// Sizes that are calculated from a shape.
std::optional<NetValue> folded_integers(const NetCall& call, const NetFolding& folding) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 30U;
  const auto is_usual = [](std::int64_t x) { return x <= kLargest && x >= -kLargest; };
  const auto a = integers_of(call.input(0));
  const auto b = integers_of(call.input(1));
  if (!a || !b || a->empty() || b->empty() || a->size() > kMaxRank || b->size() > kMaxRank) {
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
    const std::int64_t x = (*a)[a->size() == 1 ? 0 : i];
    const std::int64_t y = (*b)[b->size() == 1 ? 0 : i];
    const auto value = is_usual(x) && is_usual(y) ? folding.integers(x, y) : std::nullopt;
    if (!value) return std::nullopt;
    result.push_back(*value);
  }
  return integers_value(std::move(result), *shape);
}

std::optional<std::vector<float>> numbers_of(const NetValue& value) {
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

std::optional<NetValue> folded(const NetCall& call, const NetFolding& folding) {
  const NetValue& a = call.input(0);
  const NetValue& b = call.input(1);
  const bool unary = call.input_count() == 1;
  if (folding.integers != nullptr) {
    if (auto value = folded_integers(call, folding)) return value;
  }
  if (folding.reals == nullptr || call.input_count() > 2 || a.kind != Kind::constant ||
      folding.takes_one != unary || (!unary && b.kind != Kind::constant)) {
    return std::nullopt;
  }
  const auto shape = unary ? a.shape : broadcast(a.shape, b.shape);
  const std::int64_t count = shape ? element_count(*shape).value_or(kMaxElements) : kMaxElements;
  if (count > kMaxValues) return std::nullopt;
  // A result without numbers may be of many: [1000000, 1] and [1, 0].
  const auto read = [](const NetValue& value) {
    return value.kind == Kind::constant ? element_count(value.constant.dims).value_or(0) : 0;
  };
  if (!call.spend(8 * count + read(a) + read(b))) return call.too_much();
  auto left = numbers_of(a);
  auto right = unary ? std::optional(std::vector<float>{0.0F}) : numbers_of(b);
  if (!left || !right || left->empty() || right->empty()) return std::nullopt;
  *left = broadcast_to(*left, a.constant.dims, *shape);
  *right = broadcast_to(*right, unary ? Dims{} : b.constant.dims, *shape);
  for (std::size_t i = 0; i < left->size(); ++i) {
    (*left)[i] = folding.reals((*left)[i], (*right)[i]);
  }
  return made_constant(call, *left, *shape);
}

}  // namespace eagerx::gen
