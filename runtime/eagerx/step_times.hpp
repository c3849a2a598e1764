// Times at which your own main loop calls step(), and the number of consecutive late steps.
#pragma once

#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/safety.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

/// The value of a missing measurement: NaN, which the guard handles, or 0 for whole numbers, which
/// have no NaN.
template <class Message>
constexpr Message not_measured() {
  using Scalar = ScalarOf<Message>;
  if constexpr (std::is_floating_point_v<Scalar>) {
    return filled<Message>(std::numeric_limits<Scalar>::quiet_NaN());
  } else {
    return filled<Message>(Scalar{});
  }
}

/// Extends a 32-bit clock to 64 bits: microseconds overflow after 71 minutes. Pass the time at
/// least that often.
class WideClock {
 public:
  std::uint64_t operator()(std::uint32_t now) {
    sum_ += static_cast<std::uint32_t>(now - last_);
    last_ = now;
    return sum_;
  }

 private:
  std::uint64_t sum_ = 0;
  std::uint32_t last_ = 0;
};

/// The instants n/Rate after start(), in microseconds of the caller's clock, which must be
/// monotonic. The instants are fixed: lateness does not accumulate, and the period is not rounded.
/// If the next instant has come, the current one is skipped, so a loop that hung does not catch up
/// with several steps on one measurement.
template <class Rate>
class StepTimes {
 public:
  /// Instant 0 is now. `max_lateness_ns`: a step may begin this late: Limits::kSafety.
  void start(std::uint64_t now_us, std::int64_t max_lateness_ns) {
    *this = {};
    start_us_ = now_us;
    due_us_ = now_us;
    next_us_ = now_us;
    max_lateness_us_ = static_cast<std::uint64_t>(max_lateness_ns) / kNsPerUs;
  }

  /// When the next step is due.
  std::uint64_t next_us() const { return next_us_; }
  /// Microseconds until the next step is due; 0 if it is due now.
  std::uint64_t until_next(std::uint64_t now_us) const {
    return now_us < next_us_ ? next_us_ - now_us : 0;
  }

  /// Begins the step that is due.
  void begin(std::uint64_t now_us) {
    const std::uint64_t late_us = now_us > next_us_ ? now_us - next_us_ : 0;
    std::uint64_t missed = periods_in(late_us);
    if (us_of(next_ + missed + 1) <= now_us) ++missed;  // instants are rounded
    const bool too_late = late_us > max_lateness_us_;
    late_in_a_row_ = too_late ? late_in_a_row_ + 1 + periods_in(late_us - max_lateness_us_) : 0;
    late_steps_ += too_late;
    missed_ += missed;
    worst_us_ = late_us > worst_us_ ? late_us : worst_us_;
    due_us_ = us_of(next_ + missed);
    next_ += missed + 1;
    next_us_ = us_of(next_);
  }

  /// The second argument of step(): the number of consecutive late steps, up to this one. Call it
  /// after the measurements, because these take time, too.
  std::uint64_t late_in_a_row(std::uint64_t now_us) const {
    return late_instants(late_in_a_row_, now_us > due_us_ ? now_us - due_us_ : 0, kPeriodUs,
                         max_lateness_us_);
  }

  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    f("steps too late", late_steps_);
    f("steps left out", missed_);
    f("latest by us", worst_us_);
  }

 private:
  static constexpr std::uint64_t kNsPerUs = 1'000;
  static constexpr std::uint64_t kUsPerSecond = 1'000'000;
  static constexpr std::uint64_t kWhole = kUsPerSecond * Rate::den / Rate::num;
  static constexpr std::uint64_t kPeriodUs = kWhole > 0 ? kWhole : 1;

  static std::uint64_t periods_in(std::uint64_t us) {
    return us / kUsPerSecond * Rate::num / Rate::den +
           us % kUsPerSecond * Rate::num / (kUsPerSecond * Rate::den);
  }
  /// The time of instant n, rounded down, so that n periods have passed. In two parts, so that it
  /// works for centuries.
  std::uint64_t us_of(std::uint64_t n) const {
    const std::uint64_t periods = n * Rate::den;
    return start_us_ + periods / Rate::num * kUsPerSecond +
           periods % Rate::num * kUsPerSecond / Rate::num;
  }

  std::uint64_t start_us_ = 0;
  std::uint64_t due_us_ = 0;   // of the current step
  std::uint64_t next_us_ = 0;  // of the next one
  std::uint64_t next_ = 0;
  std::uint64_t max_lateness_us_ = 0;
  std::uint64_t late_in_a_row_ = 0;
  std::uint64_t late_steps_ = 0;
  std::uint64_t missed_ = 0;
  std::uint64_t worst_us_ = 0;
};

}  // namespace eagerx
