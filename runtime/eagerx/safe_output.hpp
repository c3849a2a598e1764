// Outputs of a controller without an engine while it applies safe values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/space.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

/// The safe value of an output, `safety: {outputs: …}` of a graph.
template <class Message>
struct SafeOutput {
  static constexpr std::uint64_t kAlways = std::numeric_limits<std::uint64_t>::max();

  Message value;                  // in the end
  Space<Message> space;           // everything that leaves is within
  std::uint64_t hold_steps;       // for which the last good output stays first
  ScalarOf<Message> most_change;  // of an element in a step, to `value` and back; 0: at once
};

/// The guarded value of one output. All zero until the first reset().
template <class Message>
class OutputKeeper {
 public:
  const Message& message() const { return message_; }

  void reset(const SafeOutput<Message>& safe) {
    take(safe.value);
    state_ = State::fresh;
    safe_steps_ = 0;
  }

  /// A step whose output, which is finite and within its space, may leave.
  void leave(const Message& good, const SafeOutput<Message>& safe) {
    if (state_ == State::away && ramps(safe) && approach(good, safe.most_change)) {
      safe_steps_ = 0;
      return;
    }
    take(good);
    state_ = State::good;
  }

  /// A step with the safe output. `holds`: whether the last good output may stay.
  void be_safe(const SafeOutput<Message>& safe, bool holds) {
    const bool had_good = state_ != State::fresh;
    if (state_ == State::good) {
      safe_steps_ = 0;
      state_ = State::away;
    }
    if (holds && had_good && safe_steps_ < safe.hold_steps) {
      ++safe_steps_;
    } else {
      safe_steps_ = safe.hold_steps;  // holding is over for this time
      if (!ramps(safe) || !approach(safe.value, safe.most_change)) take(safe.value);
    }
  }

 private:
  static bool ramps(const SafeOutput<Message>& safe) {
    return safe.most_change > ScalarOf<Message>{};
  }

  void take(const Message& message) {
    message_ = message;
    rest_ = {};
  }

  /// A step of the ramp towards `target`; false if it is reached, or if there is no ramp. The
  /// rounding error of a step is carried to the next one (TwoSum, Knuth 4.2.2); otherwise a slow
  /// ramp would stall.
  bool approach(const Message& target, ScalarOf<Message> most_change) {
    if constexpr (!std::is_floating_point_v<ScalarOf<Message>>) return false;
    bool is_there = true;
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      auto& x = element(message_, i);
      auto& rest = element(rest_, i);
      const auto& end = element(target, i);
      const bool rises = end > x && end - x > most_change;
      const bool falls = x > end && x - end > most_change;
      if (!rises && !falls) {
        x = end;
        rest = {};
        continue;
      }
      const auto term = (rises ? most_change : -most_change) + rest;
      const auto sum = x + term;
      const auto added = sum - x;
      rest = (x - (sum - added)) + (term - added);
      x = sum;
      is_there = false;
    }
    return !is_there;
  }

  Message message_{};
  Message rest_{};  // of a ramp: what its steps have rounded away
  /// No good output since the reset; the last good one; safe, or on the way back.
  enum class State : std::uint8_t { fresh, good, away };

  std::uint64_t safe_steps_ = 0;  // in a row in which it was held
  State state_ = State::fresh;
};

}  // namespace eagerx
