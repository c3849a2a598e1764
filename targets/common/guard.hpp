// The safe action in the agent's place, as the graph declares it under `safety:`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/safety.hpp>
#include <eagerx/space.hpp>
#include <type_traits>

namespace eagerx::target {

/// Every action of a run goes through check(). Graphs without `safety:` cost nothing.
template <class Graph>
class Guard {
 public:
  using Action = typename Graph::Action;
  using Observation = typename Graph::Observation;
  static constexpr Safety kSafety = Graph::kSafety;

  /// An episode begins: a safe action that only a reset ends is over.
  void reset() {
    right_ = kAllRight;
    bad_ = 0;
    is_safe_ = false;
    last_ = Graph::safe();
  }

  /// What is applied in place of `action`, the agent's answer to `observation`. `late_in_a_row`:
  /// instants up to now that were later than `max_lateness`.
  Action check(const Observation& observation, Action action, std::uint64_t late_in_a_row) {
    if constexpr (!kSafety.declared) {
      return action;
    } else {
      const bool late = late_in_a_row >= kSafety.late;
      overruns_ += late;
      const bool numbers = are_numbers(observation, action);
      const bool within = numbers && move_into_limits(action);
      bad_ = numbers ? 0 : bad_ + 1;
      const bool holds = kSafety.holds && bad_ > 0 && bad_ < kSafety.missed && !is_safe_;
      note(!late && (numbers || holds) && (within || kSafety.clips || holds));
      if (is_safe_) {
        ++safe_steps_;
        return last_ = Graph::safe();
      }
      return holds ? last_ : last_ = action;
    }
  }

  /// The end of a run before its time: an interrupt, or a board that is too late.
  Action stop() {
    ++stops_;
    return Graph::safe();
  }

  /// f(name, count) for each.
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

  template <class Message>
  static bool is_finite(const Message& message) {
    bool finite = true;
    if constexpr (std::is_floating_point_v<ScalarOf<Message>>) {
      for (std::size_t i = 0; i < size_of<Message>; ++i)
        finite = finite && eagerx::isfinite(element(message, i));
    }
    return finite;
  }

  bool are_numbers(const Observation& observation, Action& action) {
    bool seen = true;
    Graph::for_each_observation(
        observation, [&](const char* /*name*/, const auto& window, const auto& /*space*/) {
          for (std::uint32_t i = 0; i < window.size(); ++i) seen = seen && is_finite(window[i]);
        });
    bool given = true;
    Graph::for_each_action(action,
                           [&](const char* /*name*/, const auto& message, const auto& /*space*/) {
                             given = given && is_finite(message);
                           });
    observations_ += !seen;
    actions_ += seen && !given;  // an agent that was given NaN may answer with it
    return seen && given;
  }

  /// True if it was within them.
  bool move_into_limits(Action& action) {
    bool within = true;
    Graph::for_each_action(action, [&](const char* /*name*/, auto& message, const auto& space) {
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

  std::uint32_t right_ = kAllRight;  // instants in a row since the last wrong one
  std::uint32_t bad_ = 0;            // instants in a row with a number that is not finite
  bool is_safe_ = false;
  Action last_ = Graph::safe();
  std::uint64_t safe_steps_ = 0;
  std::uint64_t safe_times_ = 0;
  std::uint64_t overruns_ = 0;
  std::uint64_t observations_ = 0;
  std::uint64_t actions_ = 0;
  std::uint64_t limits_ = 0;
  std::uint64_t stops_ = 0;
};

}  // namespace eagerx::target
