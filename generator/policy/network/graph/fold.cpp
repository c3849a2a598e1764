// Operators whose inputs are all constants: exporters leave `sqrt(variance + epsilon)` to the
// program that runs the file.
#include <algorithm>

#include "generator/policy/network/graph/operators.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;

/// Sizes that are calculated from a shape, as far as 30 bits hold them.
std::optional<NetValue> folded_integers(const NetCall& call, const NetFolding& folding) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 30U;
  const auto is_usual = [](std::int64_t x) { return x <= kLargest && x >= -kLargest; };
  return each_of_integers(call, 2, [&](const Integers& x) {
    return is_usual(x[0]) && is_usual(x[1]) ? folding.integers(x[0], x[1]) : std::nullopt;
  });
}

std::optional<std::vector<float>> numbers_of(const NetValue& value) {
  PolicyProblem ignored;
  if (value.kind != Kind::constant || value.constant.transposed) return std::nullopt;
  return read_floats(value.constant, ignored);
}

}  // namespace

std::optional<NetValue> each_of_integers(const NetCall& call, std::size_t inputs,
                                         const NetPick& pick) {
  std::vector<Integers> given;
  std::size_t count = 1;
  std::optional<Dims> shape = Dims{};
  for (std::size_t i = 0; i < inputs; ++i) {
    const auto values = integers_of(call.input(i));
    if (!values) return std::nullopt;
    given.push_back(*values);
    count = std::max(count, values->size());
    shape = broadcast(shape, call.input(i).shape);
  }
  const auto fits = [&](const Integers& one) { return one.size() == count || one.size() == 1; };
  if (!shape || element_count(*shape) != static_cast<std::int64_t>(count) || count > kMaxRank ||
      !ranges::all_of(given, fits)) {
    return std::nullopt;
  }
  Integers result;
  for (std::size_t i = 0; i < count; ++i) {
    Integers row;
    for (const Integers& one : given) row.push_back(one[one.size() == 1 ? 0 : i]);
    const auto value = pick(row);
    if (!value) return std::nullopt;
    result.push_back(*value);
  }
  return integers_value(std::move(result), *shape);
}

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
