#include "generator/analysis/bound/value.hpp"

#include <algorithm>

namespace eagerx::gen::bound {
namespace {

constexpr std::int64_t kLeastUnsigned = 0;

constexpr unsigned kMostBits = 31;

/// Whether left - right is negative, zero, positive: what of it is possible.
struct Signs {
  bool negative = true, zero = true, positive = true;
};

Signs signs_of(const Comparison& comparison) {
  Value a = comparison.left, b = comparison.right;
  if (a.base != b.base) {
    a = resolved(a);
    b = resolved(b);
  }
  if (a.base != b.base) return {};
  const std::int64_t low = a.low - b.high, high = a.high - b.low;
  return {low < 0, low <= 0 && high >= 0, high > 0};
}

/// Unsigned order is that of the signed numbers where neither is negative.
bool is_unsigned_order(const Comparison& comparison) {
  return resolved(comparison.left).low >= kLeastUnsigned &&
         resolved(comparison.right).low >= kLeastUnsigned;
}

std::optional<bool> one_of(bool may_hold, bool may_fail) {
  if (may_hold && may_fail) return std::nullopt;
  return may_hold;
}

}  // namespace

const Value* State::find(const Location& location) const {
  if (!location.on_stack) return &registers[static_cast<std::size_t>(location.at)];
  const auto found = stack.find(location.at);
  return found == stack.end() ? nullptr : &found->second;
}

std::vector<Location> State::locations() const {
  std::vector<Location> all;
  all.reserve(kRegisters + stack.size());
  for (std::size_t r = 0; r < kRegisters; ++r) all.push_back({false, static_cast<std::int64_t>(r)});
  for (const auto& [offset, value] : stack) all.push_back({true, offset});
  return all;
}

void State::set(const Location& location, const Value& value) {
  if (location.on_stack)
    stack[location.at] = value;
  else
    registers[static_cast<std::size_t>(location.at)] = value;
}

std::optional<Value> sum(const Value& a, const Value& b, int sign) {
  const std::int64_t low = a.low + (sign > 0 ? b.low : -b.high);
  const std::int64_t high = a.high + (sign > 0 ? b.high : -b.low);
  constexpr std::int64_t kMost = INT32_MAX;
  if (low < -kMost || high > kMost) return std::nullopt;
  if (b.base == 0) return Value{a.base, low, high};
  if (sign > 0 && a.base == 0) return Value{b.base, low, high};
  if (sign < 0 && a.base == b.base) return Value{0, low, high};
  return std::nullopt;
}

Base base_of_bits(Address at, const Location& location, unsigned bits) {
  return base_of(Origin::made, at, location) | (std::uint64_t{bits & kMostBits} << kBits);
}

Origin origin_of(Base base) {
  constexpr std::uint64_t kOrigins = 7;
  return static_cast<Origin>(base >> kOrigin & kOrigins);
}

std::optional<Address> place_of(Base base) {
  if (base >> kIsPlace == 0 || origin_of(base) == Origin::sum) return std::nullopt;
  return static_cast<Address>(base >> kAddress) << 1U;
}

bool is_wide(const Value& value) {
  if (value.is_exact() || value.base >> kIsPlace == 0) return false;
  return origin_of(value.base) != Origin::header;
}

std::optional<Base> Sums::of(Base a, Base b) {
  Parts all{};
  auto end = all.begin();
  for (const Base& one : {a, b}) {
    const std::span<const Base> of_sum = parts(one);
    const std::span<const Base> numbers = of_sum.empty() ? std::span(&one, 1) : of_sum;
    if (all.end() - end < std::ssize(numbers)) return std::nullopt;
    end = std::ranges::copy(numbers, end).out;
  }
  std::sort(all.begin(), end);
  const Base next = (std::uint64_t{1} << kIsPlace) |
                    (static_cast<std::uint64_t>(Origin::sum) << kOrigin) | sums_.size();
  const auto [found, is_new] = known_.emplace(all, next);
  if (is_new) sums_.push_back(found->first);
  return found->second;
}

std::span<const Base> Sums::parts(Base base) const {
  if (base >> kIsPlace == 0 || origin_of(base) != Origin::sum) return {};
  constexpr std::uint64_t kIndex = 0xffffffff;
  const Parts& all = sums_[base & kIndex];
  return {all.begin(), std::ranges::find(all, Base{0})};
}

Value resolved(const Value& value) {
  const auto bits = static_cast<unsigned>(value.base >> kBits) & kMostBits;
  if (value.base >> kIsPlace == 0 || bits == 0 || origin_of(value.base) == Origin::sum)
    return value;
  return {0, value.low, value.high + (std::int64_t{1} << bits) - 1};
}

namespace {

/// One step further: what the base of a value is between.
Value resolved_once(const Limits& limits, const Value& value) {
  const auto found = limits.find(value.base);
  if (found == limits.end()) return resolved(value);
  const Value& limit = found->second;
  return {limit.base, value.low + limit.low, value.high + limit.high};
}

constexpr std::size_t kMostSteps = 8;

}  // namespace

Value State::resolve(const Value& value) const {
  Value result = value;
  for (std::size_t i = 0; i < kMostSteps && result.base != 0; ++i) {
    const Value next = resolved_once(limits, result);
    if (next.base == result.base) break;
    result = next;
  }
  return result.base == 0 ? result : value;
}

bool State::relate(Value& a, Value& b) const {
  for (std::size_t i = 0; i < kMostSteps && a.base != b.base; ++i) {
    const Value next_a = resolved_once(limits, a), next_b = resolved_once(limits, b);
    if (next_a == a && next_b == b) return false;
    if (next_a.base == b.base) {
      a = next_a;
    } else if (next_b.base == a.base) {
      b = next_b;
    } else {
      a = next_a;
      b = next_b;
    }
  }
  return a.base == b.base;
}

bool is_same(const State& a, const State& b) {
  return a.registers == b.registers && a.stack == b.stack;
}

void State::learn(Condition condition, const Comparison& compared) {
  const auto fact = learned(condition, compared);
  if (!fact) return;
  limits[fact->first] = fact->second;
  if (!fact->second.is_number()) return;
  const auto replace = [&](Value& value) {
    if (value.base == fact->first)
      value = {0, value.low + fact->second.low, value.high + fact->second.low};
  };
  for (Value& value : registers) replace(value);
  for (auto& [offset, value] : stack) replace(value);
}

/// A number that is not the least or the most that it could be.
std::optional<std::pair<Base, Value>> State::not_at_end(const Value& left,
                                                        const Value& right) const {
  Value known = resolve({left.base, 0, 0});
  if (known.base != 0 || !right.is_exact()) return std::nullopt;
  const std::int64_t other = right.low - left.low;
  if (other == known.high)
    --known.high;
  else if (other == known.low)
    ++known.low;
  if (known.low > known.high) return std::nullopt;
  return std::pair(left.base, known);
}

std::optional<std::pair<Base, Value>> State::learned(Condition condition,
                                                     const Comparison& compared) const {
  using enum Condition;
  const Value right = resolve(compared.right);
  const Value& left = compared.left;
  if (right.base != 0 || left.base == 0 || left.base == kStack || !left.is_exact())
    return std::nullopt;
  Value limit{0, INT32_MIN, INT32_MAX};
  if (condition == eq) {
    limit = right;
  } else if (condition == ne) {
    return not_at_end(left, right);
  } else if (compared.zero_only) {
    return std::nullopt;
  } else if (condition == cc || condition == ls) {
    const std::int64_t most = right.high - (condition == ls ? 0 : 1);
    if (right.low < 0 || most < 0) return std::nullopt;
    limit = {0, 0, most};
  } else if (condition == lt || condition == le) {
    limit.high = right.high - (condition == lt ? 1 : 0);
  } else if (condition == gt || condition == ge) {
    limit.low = right.low + (condition == gt ? 1 : 0);
  } else {
    return std::nullopt;
  }
  // A sum that may wrap says nothing of its base, but a range of it that is known whole does.
  if (left.low != 0 && (limit.low == INT32_MIN || limit.high == INT32_MAX)) return std::nullopt;
  limit.low -= left.low;
  limit.high -= left.low;
  const Value known = resolve({left.base, 0, 0});
  if (known.base == 0)
    limit = {0, std::max(limit.low, known.low), std::min(limit.high, known.high)};
  if (limit.low > limit.high) return std::nullopt;
  return std::pair(left.base, limit);
}

namespace {

Value joined(const Value& a, const Value& b, Address at, const Location& location) {
  if (a == b) return a;
  const Value both{a.base, std::min(a.low, b.low), std::max(a.high, b.high)};
  if (a.base == b.base && !is_wide(both)) return both;
  return {base_of(Origin::joined, at, location), 0, 0};
}

/// A value, and what it is by what is known of its base, of the base of that, and so on.
class Chain {
 public:
  Chain(const Limits& limits, const Value& value) : values_{value} {
    while (size_ < kMostSteps) {
      const Value next = resolved_once(limits, values_[size_ - 1]);
      if (next == values_[size_ - 1]) break;
      values_[size_++] = next;
    }
  }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.begin() + size_; }

 private:
  std::array<Value, kMostSteps> values_;
  std::uint8_t size_ = 1;
};

/// Brings together what locations are on two ways to a place.
class Join {
 public:
  /// `a`, `b`: what is known on each way; `limits`: what is known on both.
  Join(Address at, const Limits& a, const Limits& b, Limits& limits)
      : at_(at), a_(a), b_(b), limits_(limits) {}

  /// Makes `left` what it is on either way; of two values with one base, what they are between.
  void operator()(const Location& where, Value& left, const Value& right) {
    if (left == right) return;
    const Value both = joined(left, right, at_, where);
    if (left.base != both.base || right.base != both.base) {
      limits_.erase(both.base);
      const auto range = range_of(left, right);
      if (range && range->base != both.base) limits_[both.base] = *range;
    }
    left = both;
  }

 private:
  /// The range of two values that have one base somewhere.
  [[nodiscard]] std::optional<Value> range_of(const Value& left, const Value& right) const {
    const Chain chain_a(a_, left), chain_b(b_, right);
    for (const Value& from : chain_a) {
      for (const Value& to : chain_b) {
        if (from.base == to.base)
          return Value{from.base, std::min(from.low, to.low), std::max(from.high, to.high)};
      }
    }
    return std::nullopt;
  }

  Address at_;
  const Limits &a_, &b_;
  Limits& limits_;
};

}  // namespace

void join(State& state, const State& other, Address at) {
  const Limits before = state.limits;
  state.limits.intersect(other.limits, [](Limits::Entry& mine, const Value& its) {
    Value& limit = mine.second;
    if (limit.base != its.base) return false;
    limit = {limit.base, std::min(limit.low, its.low), std::max(limit.high, its.high)};
    return true;
  });
  Join both(at, before, other.limits, state.limits);
  for (std::size_t i = 0; i < kRegisters; ++i)
    both({false, static_cast<std::int64_t>(i)}, state.registers[i], other.registers[i]);
  state.stack.intersect(other.stack, [&](auto& mine, const Value& its) {
    both({true, mine.first}, mine.second, its);
    return true;
  });
  if (state.comparison != other.comparison) state.comparison.reset();
  state.choice.reset();
  state.escaped = std::min(state.escaped, other.escaped);
  state.arguments_escaped = state.arguments_escaped || other.arguments_escaped;
}

std::optional<bool> holds(Condition condition, const Comparison& comparison) {
  using enum Condition;
  const Signs s = signs_of(comparison);
  if (condition == eq) return one_of(s.zero, s.negative || s.positive);
  if (condition == ne) return one_of(s.negative || s.positive, s.zero);
  // Of values that are not numbers, only the difference is known: their order may wrap.
  if (comparison.zero_only || resolved(comparison.left).base != 0) return std::nullopt;
  const bool is_signed = condition == lt || condition == le || condition == gt || condition == ge;
  if (!is_signed && !is_unsigned_order(comparison)) return std::nullopt;
  if (condition == lt || condition == cc) return one_of(s.negative, s.zero || s.positive);
  if (condition == ge || condition == cs) return one_of(s.zero || s.positive, s.negative);
  if (condition == gt || condition == hi) return one_of(s.positive, s.zero || s.negative);
  if (condition == le || condition == ls) return one_of(s.zero || s.negative, s.positive);
  return std::nullopt;
}

}  // namespace eagerx::gen::bound
