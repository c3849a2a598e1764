// The guard of a program's actions: what reaches the actuators in place of what the agent wants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/safety.hpp>
#include <eagerx/space.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

template <class Message>
constexpr bool is_finite(const Message& message) {
  bool finite = true;
  if constexpr (std::is_floating_point_v<ScalarOf<Message>>) {
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      finite = finite && eagerx::isfinite(element(message, i));
  }
  return finite;
}

/// What `safety:` in the graph says: when the safe action takes the agent's place, and when it
/// ends.
template <class Limits>
class Takeover {
 public:
  using Action = typename Limits::Action;
  using Observation = typename Limits::Observation;
  static constexpr Safety kSafety = Limits::kSafety;

  void reset() {
    right_ = kAllRight;
    bad_ = 0;
    is_safe_ = false;
    seen_ = true;
    last_ = Limits::safe();
  }

  /// What an observation is padded with before its first message is no number, either.
  void see(const Observation& observation) {
    seen_ = true;
    Limits::for_each_observation(
        observation, [&](const char* /*name*/, const auto& window, const auto& /*space*/) {
          for (std::uint32_t i = 0; i < window.size(); ++i) seen_ = seen_ && is_finite(window[i]);
        });
  }

  void saw(bool is_finite) { seen_ = is_finite; }

  Action judge(Action action, std::uint64_t late_in_a_row) {
    const bool late = late_in_a_row >= kSafety.late;
    overruns_ += late;
    const bool numbers = are_numbers(action);
    const bool within = numbers && move_into_limits(action);
    bad_ = numbers ? 0 : bad_ + 1;
    const bool holds = kSafety.holds && bad_ > 0 && bad_ < kSafety.missed && !is_safe_;
    note(!late && (numbers || holds) && (within || kSafety.clips || holds));
    if (is_safe_) {
      ++safe_steps_;
      return last_ = Limits::safe();
    }
    return holds ? last_ : last_ = action;
  }

  void stop() { ++stops_; }

  template <class F>
  void for_each_count(F&& f) const {
    f("safe: steps", safe_steps_);
    f("safe: times", safe_times_);
    f("safe: overrun", overruns_);
    f("safe: observation not finite", observations_);
    f("safe: action not finite", actions_);
    f("safe: action out of limits", limits_);
    f("safe: stopped", stops_);
  }

 private:
  static constexpr std::uint32_t kAllRight = 0xffff'ffffU;

  bool are_numbers(Action& action) {
    bool given = true;
    Limits::for_each_action(action,
                            [&](const char* /*name*/, const auto& message, const auto& /*space*/) {
                              given = given && is_finite(message);
                            });
    observations_ += !seen_;
    actions_ += seen_ && !given;  // an agent that was given NaN may answer with it
    return seen_ && given;
  }

  /// True if it was within them.
  bool move_into_limits(Action& action) {
    bool within = true;
    Limits::for_each_action(action, [&](const char* /*name*/, auto& message, const auto& space) {
      within = within && space.contains(message);
      message = space.clipped(message);
    });
    limits_ += !within;
    return within;
  }

  void note(bool right) {
    if (!right) {
      safe_times_ += !is_safe_;
      is_safe_ = true;
      right_ = 0;
    } else if (is_safe_) {
      // The instant that completes `recover` right ones is the first whose action is applied.
      if (right_ != kAllRight) ++right_;
      is_safe_ = kSafety.recover == 0 || right_ < kSafety.recover;
    }
  }

  std::uint32_t right_ = 0;  // instants in a row since the last wrong one
  std::uint32_t bad_ = 0;    // instants in a row with a number that is not finite
  bool is_safe_ = false;
  bool seen_ = false;  // whether the latest observation was finite
  Action last_{};
  std::uint64_t safe_steps_ = 0;
  std::uint64_t safe_times_ = 0;
  std::uint64_t overruns_ = 0;
  std::uint64_t observations_ = 0;
  std::uint64_t actions_ = 0;
  std::uint64_t limits_ = 0;
  std::uint64_t stops_ = 0;
};

/// A graph without `safety:`: nobody takes over.
struct NoTakeover {};

/// Every action goes through check(). What comes out is finite, within the space of the action, and
/// within those of the actuators that it is connected to: an action that is not finite becomes the
/// safe one, one out of its space is moved into it, and both are counted. With `safety:` in the
/// graph, the safe action takes the agent's place as that says. `Limits` is the generated struct of
/// that name. All zero until the first reset().
template <class Limits>
class Guard {
 public:
  using Action = typename Limits::Action;
  using Observation = typename Limits::Observation;
  static constexpr bool kTakesOver = Limits::kSafety.declared;

  /// An episode begins: a safe action that only a reset ends is over.
  void reset() {
    if constexpr (kTakesOver) takeover_.reset();
  }

  /// The observation that the next action answers.
  void see(const Observation& observation) {
    if constexpr (kTakesOver) takeover_.see(observation);
  }
  /// The same of an observation that is finite, or not.
  void saw(bool is_finite) {
    if constexpr (kTakesOver) takeover_.saw(is_finite);
  }

  /// What is applied in place of `action`. `late_in_a_row`: instants up to now that were later than
  /// `max_lateness`; without `safety:` nothing is too late.
  Action check(Action action, std::uint64_t late_in_a_row) {
    if constexpr (kTakesOver) {
      action = takeover_.judge(action, late_in_a_row);
    } else {
      static_cast<void>(late_in_a_row);
    }
    return is_applicable(action) ? action : corrected(action);
  }

  /// The safe action, for the end of a run before its time: an interrupt, or a board that is too
  /// late.
  Action stop() {
    if constexpr (kTakesOver) takeover_.stop();
    const Action safe = Limits::safe();
    return is_applicable(safe) ? safe : corrected(safe);
  }

  /// An action on its way to an actuator, after a processor.
  template <class Message>
  Message within(const Space<Message>& space, const Message& message) {
    const bool finite = is_finite(message);
    if (finite && space.contains(message)) return message;
    ++beyond_;
    return space.clipped(finite ? message : Message{});
  }

  /// f(name, count) for each.
  template <class F>
  void for_each_count(F&& f) const {
    if constexpr (kTakesOver) takeover_.for_each_count(f);
    f(kTakesOver ? "safe: safe action not finite" : "safe: action not finite", not_finite_);
    f("safe: action beyond its actuator", beyond_);
    if constexpr (!kTakesOver) f("safe: action out of limits", limits_);
  }

  template <std::size_t>
  friend class LaneGuard;

 private:
  /// Whether nothing needs to be done, which is one comparison where bounds are symmetric.
  static bool is_applicable(Action action) {
    bool applicable = true;
    Limits::for_each_applied(action, [&](const auto& message, const auto& space) {
      for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>; ++i) {
        applicable = applicable &&
                     is_within(element(message, i), element(space.low, i), element(space.high, i));
      }
    });
    return applicable;
  }

  /// NaN and infinity never are.
  template <class T>
  static bool is_within(T x, T low, T high) {
    if constexpr (std::is_floating_point_v<T>) {
      constexpr T kMost = std::numeric_limits<T>::max();
      if (low == -high) return eagerx::abs(x) <= (high < kMost ? high : kMost);
      return x >= low && x <= high && eagerx::abs(x) <= kMost;
    } else {
      return x >= low && x <= high;
    }
  }

  /// Rare, so it is kept out of the way.
  [[gnu::noinline, gnu::cold]] Action corrected(Action action) {
    bool finite = true;
    bool within = true;
    Limits::for_each_action(action,
                            [&](const char* /*name*/, const auto& message, const auto& space) {
                              finite = finite && is_finite(message);
                              within = within && space.contains(message);
                            });
    not_finite_ += !finite;
    if (!finite) action = Limits::safe();
    limits_ += finite && !within;
    Limits::for_each_action(action, [](const char* /*name*/, auto& message, const auto& space) {
      message = space.clipped(message);
    });
    within = true;
    Limits::for_each_applied(action, [&](auto& message, const auto& space) {
      within = within && space.contains(message);
      message = space.clipped(message);
    });
    beyond_ += !within;
    return action;
  }

  [[no_unique_address]] std::conditional_t<kTakesOver, Takeover<Limits>, NoTakeover> takeover_{};
  std::uint32_t not_finite_ = 0;
  std::uint32_t limits_ = 0;
  std::uint32_t beyond_ = 0;
};

}  // namespace eagerx
