// EAGERx's message counts (SEMANTICS §3) in exact integers.
#pragma once

#include <algorithm>
#include <cstdint>

namespace eagerx::gen {

/// floor(x / y) for y > 0.
constexpr std::int64_t floor_div(std::int64_t x, std::int64_t y) {
  return x >= 0 ? x / y : -((-x + y - 1) / y);
}
/// ceil(x / y) for y > 0.
constexpr std::int64_t ceil_div(std::int64_t x, std::int64_t y) {
  return -floor_div(-x, y);
}

/// The counts of one connection: source rate / own rate = a/b, x = ceil(b · source rate · delay).
struct Counts {
  std::int64_t a = 1, b = 1, x = 0;
  bool skip = false;

  /// Ticks that a skipped input looks ahead or back.
  [[nodiscard]] constexpr std::int64_t off() const {
    if (!skip) return 0;
    return b > a ? (b + a - 1) / a - 1 : -1;
  }
  [[nodiscard]] constexpr std::int64_t cum(std::int64_t n) const { return floor_div(a * n - x, b); }
  /// Messages received at tick n.
  [[nodiscard]] constexpr std::int64_t at(std::int64_t n) const {
    if (n == 0) return skip ? 0 : 1;
    const std::int64_t delta = cum(n + off()) - cum(n + off() - 1);
    return std::max<std::int64_t>(0, std::min(delta, cum(n) + (skip ? 1 : 0)));
  }
  /// Messages that the source has sent at the time of tick n, that instant included.
  [[nodiscard]] constexpr std::int64_t sent(std::int64_t n) const {
    return floor_div(a * n, b) + 1;
  }
  /// Whether the source sends at the very instant of tick n.
  [[nodiscard]] constexpr bool sends_at(std::int64_t n) const { return (a * n) % b == 0; }
};

}  // namespace eagerx::gen
