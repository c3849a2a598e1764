// Real time on a board: every slot begins at its own deadline, counted from the reset.
#pragma once

#include <cstdint>
#include <eagerx/safety.hpp>
#include <eagerx/trace.hpp>

namespace eagerx::target {

/// How well the slots of a run kept to their deadlines, in ticks of the clock.
struct Timing {
  std::uint64_t slots = 0;          // that had a deadline
  std::uint64_t late = 0;           // whose deadline was over before the slot before them was done
  std::uint64_t worst = 0;          // largest lateness
  std::uint64_t late_in_a_row = 0;  // up to now
  std::uint64_t too_late_in_a_row = 0;  // that began later than the graph's `max_lateness`
  struct Range {
    std::uint64_t least = 0, most = 0, sum = 0;

    void add(std::uint64_t value) {
      least = sum == 0 || value < least ? value : least;
      most = value > most ? value : most;
      sum += value;
    }
  };
  Range busy;    // from the beginning of a slot to its end, the agent included
  Range period;  // from the beginning of a slot to that of the next
};

/// The use of the time: nothing, measure, or hold slots to their deadlines.
enum class Pace : std::uint8_t { free, measured, paced };

/// No work between slots. Other classes have kWorks = true, until(deadline, late slots), which
/// returns some microseconds before the deadline, and measured(), which replaces it if there are no
/// deadlines.
struct NoIdleWork {
  static constexpr bool kWorks = false;
};

/// Hooks that fold the hash as HashTrace does and, on request, wait for the deadline of each slot.
/// The grid of deadlines is fixed: lateness does not accumulate, and a late slot begins
/// immediately. It never sleeps, because `wfi` has wrong timing under QEMU. `Clock` has static
/// ticks(), wait_for(ticks) and hz().
template <class Clock, class IdleWork = NoIdleWork>
class PacedHooks : public HashTrace {
 public:
  static constexpr bool kWaitsForSlots = true;

  [[no_unique_address]] IdleWork idle_work{};

  void set_pace(Pace pace, std::int64_t max_lateness_ns) {
    constexpr std::uint64_t kNsPerSecond = 1'000'000'000;
    const auto ns = static_cast<std::uint64_t>(max_lateness_ns);
    pace_ = pace;
    max_lateness_ =
        ns / kNsPerSecond * Clock::hz() + ns % kNsPerSecond * Clock::hz() / kNsPerSecond;
  }

  template <class Rate>
  void wait_for_slot(Rate /*rate*/, Seq tick) {
    if (pace_ == Pace::free) return;
    if (tick == 0) {
      timing_.late_in_a_row = 0;
      timing_.too_late_in_a_row = 0;
      start_ = Clock::ticks();
      begun_ = start_;
      deadline_ = start_;
      return;
    }
    // In two parts, so that it works for centuries with any rate and clock.
    const std::uint64_t periods = tick * Rate::den;
    const std::uint64_t deadline =
        start_ + periods / Rate::num * Clock::hz() + periods % Rate::num * Clock::hz() / Rate::num;
    if (deadline == deadline_) return;  // another rate of the same slot
    deadline_ = deadline;
    begin_slot(deadline);
  }

  /// A step in which no node runs takes its time, too: the grid of deadlines moves by a period of
  /// `Rate`, that of the step.
  template <class Rate>
  void stand_still(Rate /*rate*/) {
    if (pace_ == Pace::free) return;
    const std::uint64_t period = Clock::hz() * Rate::den / Rate::num;
    start_ += period;
    deadline_ += period;
    begin_slot(deadline_);
  }

  const Timing& timing() const { return timing_; }

  /// Slots in a row that were too late, now that the answer to the latest one is about to be
  /// applied; `Rate` is that of the agent.
  template <class Rate>
  std::uint64_t too_late_in_a_row(Rate /*rate*/) const {
    if (pace_ != Pace::paced) return 0;
    constexpr std::uint64_t kShortest = 1;
    const std::uint64_t period = Clock::hz() * Rate::den / Rate::num;
    const std::uint64_t now = Clock::ticks();
    return late_instants(timing_.too_late_in_a_row, now > deadline_ ? now - deadline_ : 0,
                         period > 0 ? period : kShortest, max_lateness_);
  }

 private:
  [[gnu::noinline]] void begin_slot(std::uint64_t deadline) {
    std::uint64_t now = Clock::ticks();
    ++timing_.slots;
    timing_.busy.add(now - begun_);
    if (pace_ == Pace::paced) now = wait_until(deadline, now);
    if constexpr (IdleWork::kWorks) {
      if (pace_ == Pace::measured) now = idle_work.measured();
    }
    timing_.period.add(now - begun_);
    begun_ = now;
  }

  std::uint64_t wait_until(std::uint64_t deadline, std::uint64_t now) {
    if (now > deadline) {
      ++timing_.late;
      ++timing_.late_in_a_row;
      timing_.worst = now - deadline > timing_.worst ? now - deadline : timing_.worst;
    } else {
      timing_.late_in_a_row = 0;
    }
    if (now < deadline) {
      if constexpr (IdleWork::kWorks) idle_work.until(deadline, timing_.late);
      Clock::wait_for(deadline);
      now = Clock::ticks();
    }
    // Checked after the wait, during which a debugger may have stopped the core.
    const bool too_late = now > deadline && now - deadline > max_lateness_;
    timing_.too_late_in_a_row = too_late ? timing_.too_late_in_a_row + 1 : 0;
    return now;
  }

  std::uint64_t start_ = 0;
  std::uint64_t begun_ = 0;
  std::uint64_t deadline_ = 0;
  std::uint64_t max_lateness_ = 0;
  Pace pace_ = Pace::free;
  Timing timing_;
};

}  // namespace eagerx::target
