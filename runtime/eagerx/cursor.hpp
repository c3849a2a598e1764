// Counts the messages that an input has received, if that is not simply its source's counter:
// SEMANTICS §3. Additions only; with source rate / own rate = A/B in lowest terms and x = ceil(B ·
// source rate · delay).
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx {

/// The number of messages received up to a tick, and the number of them in the window.
struct Received {
  Seq end;
  Seq held;
};

/// floor((A n - x) / B) for n, n + 1, … without dividing again.
template <std::int64_t A, std::int64_t B>
class FloorSequence {
 public:
  constexpr void start(std::int64_t n, std::int64_t x) {
    const std::int64_t numerator = A * n - x;
    value_ = numerator >= 0 ? numerator / B : -((B - 1 - numerator) / B);
    rest_ = static_cast<Rest>(numerator - value_ * B);
  }
  constexpr void advance() {
    value_ += A / B;
    rest_ += static_cast<Rest>(A % B);
    if (rest_ >= static_cast<Rest>(B)) {
      rest_ -= static_cast<Rest>(B);
      ++value_;
    }
  }
  constexpr std::int64_t value() const { return value_; }

  template <std::int64_t, std::int64_t, std::size_t>
  friend class FloorLanes;  // lanes.hpp

 private:
  // Below 2 B; half the instructions on a 32-bit core.
  using Rest = std::conditional_t<(B < (std::int64_t{1} << 30)), std::int32_t, std::int64_t>;
  std::int64_t value_ = 0;
  Rest rest_ = 0;
};

/// A delayed input: max(1, floor((A n - x) / B) + 1) messages by tick n. Message 0 arrives
/// regardless of the delay.
template <std::int64_t A, std::int64_t B>
class DelayCursor {
 public:
  constexpr void reset(std::int64_t x) { sent_.start(0, x); }
  /// Messages by this tick; the next call is for the next tick.
  constexpr Seq take() {
    const std::int64_t total = sent_.value() + 1;
    sent_.advance();
    return total < 1 ? 1 : static_cast<Seq>(total);
  }

  template <std::int64_t, std::int64_t, std::size_t>
  friend class DelayLanes;

 private:
  FloorSequence<A, B> sent_;
};

/// A skipped input: nothing at tick 0, then max(0, min(c(n + Off) - c(n + Off - 1), c(n) + 1)) more
/// at each tick, with c(n) = floor((A n - x) / B).
template <std::int64_t A, std::int64_t B, std::int64_t Off>
class SkipCursor {
 public:
  constexpr void reset(std::int64_t x) {
    sent_.start(0, x);
    ahead_.start(Off, x);
    total_ = 0;
  }
  constexpr Seq take() {
    const Seq now = total_;
    const std::int64_t before = ahead_.value();
    sent_.advance();
    ahead_.advance();
    const std::int64_t most = sent_.value() + 1;
    const std::int64_t arriving = ahead_.value() - before < most ? ahead_.value() - before : most;
    if (arriving > 0) total_ += static_cast<Seq>(arriving);
    return now;
  }

  template <std::int64_t, std::int64_t, std::int64_t, std::size_t>
  friend class SkipLanes;

 private:
  FloorSequence<A, B> sent_;
  FloorSequence<A, B> ahead_;
  Seq total_ = 0;
};

/// The new messages since the last tick, for window 0.
class NewMessages {
 public:
  constexpr void reset() { seen_ = 0; }
  constexpr Received take(Seq total) {
    const Seq fresh = total - seen_;
    seen_ = total;
    return {total, fresh};
  }

  template <std::size_t>
  friend class NewLanes;

 private:
  Seq seen_ = 0;
};

}  // namespace eagerx
