// The guard of a program's actions: decides what reaches the actuators instead of the agent's
// action.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/actuator_bounds.hpp>
#include <eagerx/channel_counts.hpp>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/safety.hpp>
#include <eagerx/space.hpp>
#include <eagerx/verdict.hpp>
#include <limits>
#include <type_traits>

namespace eagerx {

/// Implements `safety:` of the graph: when the safe action replaces the agent's, and when the agent
/// takes over again.
template <class Limits>
class Takeover {
 public:
  using Action = typename Limits::Action;
  using Observation = typename Limits::Observation;
  static constexpr std::size_t kObservations = Limits::kObservationNames.size();

  void reset() {
    verdict_.reset(true);
    seen_ = true;
  }

  /// An observation without a message because of `skip` is not a fault; padding for another reason
  /// is NaN.
  void see(const Observation& observation) {
    seen_ = true;
    std::size_t channel = 0;
    Limits::for_each_observation(
        observation, [&](const char* /*name*/, const auto& window, const auto& /*space*/) {
          seen_ = seen_ && (waits(window, channel) || are_finite(window));
          ++channel;
        });
    if (!seen_) find_not_finite(observation);
  }

  /// The same, for each channel.
  void saw(std::size_t channel, bool is_finite) {
    if (channel == 0) seen_ = true;
    seen_ = seen_ && is_finite;
    not_finite_[channel] = !is_finite;
  }
  void saw_numbers() { seen_ = true; }

  Action check(Action action, std::uint64_t late_in_a_row) {
    if (!seen_) count_not_seen();
    return verdict_.check(action, seen_, late_in_a_row) ? action : Limits::safe();
  }

  void stop() { ++stops_; }

  template <class F>
  void for_each_count(F&& f) const {
    verdict_.for_each_count(f);
    observations_.for_each(f, "safe: observation not finite", Limits::kObservationNames);
    f("safe: stopped", stops_);
  }

 private:
  template <class Window>
  static bool waits(const Window& window, std::size_t channel) {
    if constexpr (requires { window.received(); }) {
      return Limits::kMayWait[channel] && window.received() == 0;
    } else {
      return false;  // without padding there is nothing that is no message
    }
  }

  template <class Window>
  static bool are_finite(const Window& window) {
    // All of them: of a loop that ends early, compilers make one with several entries, which has no
    // bound.
    bool finite = true;
    for (std::uint32_t i = 0; i < window.size(); ++i) finite &= is_finite(window[i]);
    return finite;
  }

  [[gnu::noinline, gnu::cold]] void find_not_finite(const Observation& observation) {
    std::size_t channel = 0;
    Limits::for_each_observation(
        observation, [&](const char* /*name*/, const auto& window, const auto& /*space*/) {
          not_finite_[channel] = !waits(window, channel) && !are_finite(window);
          ++channel;
        });
  }

  [[gnu::noinline, gnu::cold]] void count_not_seen() {
    for (std::size_t i = 0; i < kObservations; ++i) {
      if (not_finite_[i]) observations_.add(i);
    }
  }

  Verdict<Limits> verdict_;
  bool seen_ = false;                             // whether the latest observation was finite
  std::array<bool, kObservations> not_finite_{};  // which were not, if it was not
  ChannelCounts<kObservations> observations_;
  std::uint64_t stops_ = 0;
};

/// A graph without `safety:`: no safe action takes over.
struct NoTakeover {};

/// Every action passes through check(). The result is finite, within the space of the action, and
/// within those of the connected actuators: the safe action replaces a non-finite one, an action
/// out of its space is moved into it, and both are counted. With `safety:` in the graph, the safe
/// action replaces the agent's as specified there. `Limits` is the generated struct of that name.
/// All zero until the first reset().
template <class Limits>
class Guard {
 public:
  using Action = typename Limits::Action;
  using Observation = typename Limits::Observation;
  static constexpr bool kTakesOver = Limits::kSafety.declared;

  /// Begins an episode: ends a safe action that only a reset ends.
  void reset() {
    if constexpr (kTakesOver) takeover_.reset();
  }

  /// The observation that the next action answers.
  void see(const Observation& observation) {
    if constexpr (kTakesOver) takeover_.see(observation);
  }
  /// The same for an observation that is stored elsewhere: all numbers are finite, or saw() is
  /// called for each channel, from the first to the last.
  void saw_numbers() {
    if constexpr (kTakesOver) takeover_.saw_numbers();
  }
  void saw(std::size_t channel, bool is_finite) {
    if constexpr (kTakesOver) takeover_.saw(channel, is_finite);
  }

  /// Returns the action to apply instead of `action`. `late_in_a_row`: number of consecutive
  /// instants, up to now, later than `max_lateness`; without `safety:` nothing is too late.
  Action check(Action action, std::uint64_t late_in_a_row) {
    if constexpr (kTakesOver) {
      action = takeover_.check(action, late_in_a_row);
    } else {
      static_cast<void>(late_in_a_row);
    }
    return is_applicable(action) ? action : corrected(action);
  }

  /// The safe action, for a run that ends early: an interrupt, or a board that is too late.
  Action stop() {
    if constexpr (kTakesOver) takeover_.stop();
    const Action safe = Limits::safe();
    return is_applicable(safe) ? safe : corrected(safe);
  }

  /// An action on its way to an actuator, after a processor.
  template <class Message>
  Message within(std::size_t channel, const Space<Message>& space, const Message& message) {
    return beyond_.within(channel, space, message);
  }

  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    if constexpr (kTakesOver) takeover_.for_each_count(f);
    not_finite_.for_each(f, kTakesOver ? "safe: safe action not finite" : "safe: action not finite",
                         Limits::kActionNames);
    beyond_.for_each_count(f, Limits::kActionNames);
    if constexpr (!kTakesOver)
      limits_.for_each(f, "safe: action out of limits", Limits::kActionNames);
  }

  template <class, std::size_t>
  friend class LaneGuard;

 private:
  /// Whether the action can be applied unchanged: one comparison if bounds are symmetric.
  static bool is_applicable(Action action) {
    bool applicable = true;
    Limits::for_each_applied(action, [&](const auto& message, const auto& space) {
      for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(message)>>; ++i) {
        applicable = applicable && is_finite_within(element(message, i), element(space.low, i),
                                                    element(space.high, i));
      }
    });
    return applicable;
  }

  /// Rare, so it is kept out of the hot path.
  [[gnu::noinline, gnu::cold]] Action corrected(Action action) {
    bool finite = true;
    std::size_t channel = 0;
    Limits::for_each_action(action,
                            [&](const char* /*name*/, const auto& message, const auto& /*space*/) {
                              if (!is_finite(message)) {
                                finite = false;
                                not_finite_.add(channel);
                              }
                              ++channel;
                            });
    if (!finite) action = Limits::safe();
    channel = 0;
    Limits::for_each_action(action, [&](const char* /*name*/, auto& message, const auto& space) {
      if (finite && !space.contains(message)) limits_.add(channel);
      message = space.clipped(message);
      ++channel;
    });
    channel = 0;
    Limits::for_each_applied(action, [&](auto& message, const auto& space) {
      if (!space.contains(message)) beyond_.add(channel);
      message = space.clipped(message);
      ++channel;
    });
    return action;
  }

  [[no_unique_address]] std::conditional_t<kTakesOver, Takeover<Limits>, NoTakeover> takeover_{};
  static constexpr std::size_t kActions = Limits::kActionNames.size();
  ChannelCounts<kActions> not_finite_;
  ChannelCounts<kActions> limits_;
  ActuatorBounds<kActions> beyond_;
};

}  // namespace eagerx
