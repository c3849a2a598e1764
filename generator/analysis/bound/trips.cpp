#include "generator/analysis/bound/trips.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace eagerx::gen::bound {
namespace {

constexpr std::int64_t kMostNumber = INT32_MAX;

/// A number without a sign that grows is below a limit for this many turns, wherever it starts.
std::optional<std::uint64_t> below_limit(const Progress& left, const Progress& right,
                                         const State& state) {
  const Value limit = state.resolve(right.start);
  constexpr std::int64_t kLargestStep = 1 << 16;
  if (limit.base != 0 || limit.low < 0 || right.step != Value::of(0)) return std::nullopt;
  if (left.step.low <= 0 || left.step.high > kLargestStep) return std::nullopt;
  return static_cast<std::uint64_t>(limit.high / left.step.low) + 1;
}

/// left - right of a test at turn t is start + step * t.
struct Difference {
  Value start, step;
  Progress left, right;
};

std::optional<Difference> difference(const Test& test, const ProgressOf& progress_of,
                                     const State& state) {
  auto left = progress_of(test.comparison.left), right = progress_of(test.comparison.right);
  if (!left || !right) return std::nullopt;
  if (!state.relate(left->start, right->start)) return std::nullopt;
  const auto start = sum(left->start, right->start, -1), step = sum(left->step, right->step, -1);
  if (!start || !step || start->base != 0 || step->base != 0) return std::nullopt;
  return Difference{*start, *step, *left, *right};
}

std::uint64_t rounded_up(std::int64_t a, std::int64_t b) {
  return static_cast<std::uint64_t>((a + b - 1) / b);
}

/// Until the difference is 0, which it must meet.
std::optional<std::uint64_t> until_zero(const Difference& d) {
  if (!d.step.is_exact() || d.step.low == 0) return std::nullopt;
  const bool up = d.step.low > 0;
  const std::int64_t step = up ? d.step.low : -d.step.low;
  const std::int64_t far = up ? -d.start.low : d.start.high;
  const std::int64_t near = up ? -d.start.high : d.start.low;
  if (near < 0) return std::nullopt;
  const bool meets = step == 1 || (far == near && far % step == 0);
  return meets ? std::optional(static_cast<std::uint64_t>(far / step)) : std::nullopt;
}

/// While left < right, or <=, where left grows towards right.
std::optional<std::uint64_t> while_below(const Difference& d, bool or_equal, bool is_unsigned) {
  if (d.step.low <= 0) return std::nullopt;
  const bool numbers = d.left.start.base == 0;
  if (numbers && d.right.start.high + d.step.high > kMostNumber) return std::nullopt;
  if (numbers && is_unsigned && (d.left.start.low < 0 || d.right.start.low < 0))
    return std::nullopt;
  if (numbers && d.right.step != Value::of(0) && is_unsigned) return std::nullopt;
  const std::int64_t way = -d.start.low;
  if (way < 0 || (way == 0 && !or_equal)) return 0;
  return or_equal ? static_cast<std::uint64_t>(way / d.step.low) + 1 : rounded_up(way, d.step.low);
}

/// While left > right, or >=, where left falls towards right.
std::optional<std::uint64_t> while_above(const Difference& d, bool or_equal, bool is_unsigned) {
  if (d.step.high >= 0) return std::nullopt;
  const bool numbers = d.left.start.base == 0;
  // Unsigned, it must not fall past 0.
  const std::int64_t room = or_equal ? -d.step.low : -d.step.low - 1;
  if (is_unsigned && (!numbers || d.left.start.low < 0 || d.right.start.low < room ||
                      d.right.step != Value::of(0)))
    return std::nullopt;
  if (numbers && d.right.start.low + d.step.low < -kMostNumber) return std::nullopt;
  const std::int64_t way = d.start.high;
  if (way < 0 || (way == 0 && !or_equal)) return 0;
  return or_equal ? static_cast<std::uint64_t>(way / -d.step.high) + 1
                  : rounded_up(way, -d.step.high);
}

std::optional<std::uint64_t> stays(const Difference& d, Condition condition, bool zero_only) {
  using enum Condition;
  if (condition == ne) return until_zero(d);
  if (condition == eq) {
    if (d.step.low > 0 || d.step.high < 0) return 1;
    return std::nullopt;
  }
  const bool small = d.start.low > -(kMostNumber / 2) && d.start.high < kMostNumber / 2;
  if (condition == mi && small) return while_below(d, false, false);
  if (condition == pl && small) return while_above(d, true, false);
  if (zero_only) return std::nullopt;
  if (condition == lt) return while_below(d, false, false);
  if (condition == le) return while_below(d, true, false);
  if (condition == gt) return while_above(d, false, false);
  if (condition == ge) return while_above(d, true, false);
  if (condition == cc) return while_below(d, false, true);
  if (condition == ls) return while_below(d, true, true);
  if (condition == hi) return while_above(d, false, true);
  if (condition == cs) return while_above(d, true, true);
  return std::nullopt;
}

/// Turns until two numbers are equal that wrap as those of the machine do: the least t for which
/// start + step * t is a multiple of 2^32. Only few turns are a bound of use.
std::optional<std::uint64_t> until_equal(std::uint32_t start, std::uint32_t step) {
  constexpr std::uint32_t kMostTurns = 1U << 16U;
  constexpr int kBits = 32;
  if (step == 0) return std::nullopt;
  const int even = std::countr_zero(step);
  if (std::countr_zero(start) < even) return std::nullopt;
  const std::uint32_t odd = step >> even;
  std::uint32_t inverse = odd;  // by Newton's method, which doubles the number of right bits
  for (int right = 3; right < kBits; right *= 2) inverse *= 2 - odd * inverse;
  const std::uint32_t turns = (0 - (start >> even)) * inverse << even >> even;
  return turns <= kMostTurns ? std::optional<std::uint64_t>(turns) : std::nullopt;
}

std::optional<std::uint64_t> until_equal(const Test& test, const ProgressOf& progress_of,
                                         const State& state) {
  auto left = progress_of(test.comparison.left), right = progress_of(test.comparison.right);
  if (!left || !right || !state.relate(left->start, right->start)) return std::nullopt;
  for (const Value& value : {left->start, right->start, left->step, right->step}) {
    if (!value.is_exact()) return std::nullopt;
  }
  if (left->step.base != right->step.base) return std::nullopt;
  return until_equal(static_cast<std::uint32_t>(left->start.low - right->start.low),
                     static_cast<std::uint32_t>(left->step.low - right->step.low));
}

}  // namespace

std::optional<Turns> turns_of(const Test& test, const ProgressOf& progress_of, const State& state) {
  const auto d = difference(test, progress_of, state);
  if (test.stays_while == Condition::ne && (!d || !until_zero(*d))) {
    const auto count = until_equal(test, progress_of, state);
    return count ? std::optional(Turns{*count + 1, false}) : std::nullopt;
  }
  if (!d) {
    const bool is_unsigned = test.stays_while == Condition::cc || test.stays_while == Condition::ls;
    const auto left = progress_of(test.comparison.left), right = progress_of(test.comparison.right);
    if (!is_unsigned || test.comparison.zero_only || !left || !right) return std::nullopt;
    const auto most = below_limit(*left, *right, state);
    return most ? std::optional(Turns{*most + 1, false}) : std::nullopt;
  }
  const auto count = stays(*d, test.stays_while, test.comparison.zero_only);
  if (!count) return std::nullopt;
  return Turns{*count + 1, d->start.is_exact() && d->step.is_exact()};
}

}  // namespace eagerx::gen::bound
