// Decides whether a program's inputs may act, or safe values take over: `safety:` of a graph.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/channel_counts.hpp>
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

/// False for NaN and infinity. One comparison if bounds are symmetric.
template <class T>
constexpr bool is_finite_within(T x, T low, T high) {
  if constexpr (std::is_floating_point_v<T>) {
    constexpr T kMost = std::numeric_limits<T>::max();
    if (low == -high) return eagerx::abs(x) <= (high < kMost ? high : kMost);
    return x >= low && x <= high && eagerx::abs(x) <= kMost;
  } else {
    return x >= low && x <= high;
  }
}
template <class Message>
constexpr bool is_finite_within(const Message& message, const Space<Message>& space) {
  bool within = true;
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    within = within &&
             is_finite_within(element(message, i), element(space.low, i), element(space.high, i));
  }
  return within;
}

/// Judges the action of each step. `Limits` is the generated struct of that name. All zero until
/// the first reset().
template <class Limits>
class Verdict {
 public:
  using Action = typename Limits::Action;
  static constexpr Safety kSafety = Limits::kSafety;
  static constexpr std::size_t kActions = Limits::kActionNames.size();

  /// `has_last`: whether the safe action may be held, as if it were the previous action.
  void reset(bool has_last) {
    right_ = kAllRight;
    bad_ = 0;
    is_safe_ = false;
    has_last_ = has_last;
    last_ = Limits::safe();
  }

  bool is_safe() const { return is_safe_; }

  /// False if the safe action takes over in this step; otherwise `action` becomes the action to
  /// apply. `seen`: whether the observation that the action answers was finite. `is_wrong`: whether
  /// the action has another problem, so that neither it nor the last one may act.
  bool check(Action& action, bool seen, std::uint64_t late_in_a_row, bool is_wrong = false) {
    const bool late = late_in_a_row >= kSafety.late;
    overruns_ += late ? 1U : 0U;
    // The usual case, without a problem, takes one check of each number.
    const bool right = is_right(action);
    const bool numbers = seen && (right || are_numbers(action));
    const bool within = numbers && (right || move_into_limits(action));
    bad_ = numbers ? 0 : bad_ + 1;
    const bool holds = kSafety.holds && bad_ > 0 && bad_ < kSafety.missed && !is_safe_ && has_last_;
    note(!late && !is_wrong && (numbers || holds) && (within || kSafety.clips || holds));
    if (is_safe_) {
      ++safe_steps_;
      remember(Limits::safe());
      return false;
    }
    if (holds) {
      action = last_;
    } else {
      remember(action);
      has_last_ = true;
    }
    return true;
  }

  /// The result of an allowed step is wrong: the safe values take over.
  void refuse() {
    note(false);
    ++safe_steps_;
  }

  template <class F>
  void for_each_count(F&& f) const {
    f("safe: steps", safe_steps_);
    f("safe: times", safe_times_);
    f("safe: overrun", overruns_);
    actions_.for_each(f, "safe: action not finite", Limits::kActionNames);
    limits_.for_each(f, "safe: action out of limits", Limits::kActionNames);
  }

 private:
  static constexpr std::uint32_t kAllRight = 0xffff'ffffU;

  void remember(const Action& action) {
    if constexpr (kSafety.holds) last_ = action;  // only this needs it
  }

  static bool is_right(Action& action) {
    bool right = true;
    Limits::for_each_action(action,
                            [&](const char* /*name*/, const auto& message, const auto& space) {
                              right = right && is_finite_within(message, space);
                            });
    return right;
  }

  [[gnu::noinline, gnu::cold]] bool are_numbers(Action& action) {
    bool given = true;
    Limits::for_each_action(action,
                            [&](const char* /*name*/, const auto& message, const auto& /*space*/) {
                              given = given && is_finite(message);
                            });
    if (!given) count_not_finite(action);
    return given;
  }

  void count_not_finite(Action& action) {
    std::size_t channel = 0;
    Limits::for_each_action(action,
                            [&](const char* /*name*/, const auto& message, const auto& /*space*/) {
                              if (!is_finite(message)) actions_.add(channel);
                              ++channel;
                            });
  }

  /// True if the action was within its limits.
  [[gnu::noinline, gnu::cold]] bool move_into_limits(Action& action) {
    bool within = true;
    std::size_t channel = 0;
    Limits::for_each_action(action, [&](const char* /*name*/, auto& message, const auto& space) {
      if (!space.contains(message)) {
        within = false;
        limits_.add(channel);
        message = space.clipped(message);
      }
      ++channel;
    });
    return within;
  }

  void note(bool right) {
    if (!right) {
      safe_times_ += is_safe_ ? 0U : 1U;
      is_safe_ = true;
      right_ = 0;
    } else if (is_safe_) {
      // The `recover`th consecutive good instant is the first whose action is applied.
      if (right_ != kAllRight) ++right_;
      is_safe_ = kSafety.recover == 0 || right_ < kSafety.recover;
    }
  }

  std::uint32_t right_ = 0;  // instants in a row since the last wrong one
  std::uint32_t bad_ = 0;    // instants in a row with a number that is not finite
  bool is_safe_ = false;
  bool has_last_ = false;
  Action last_{};
  std::uint64_t safe_steps_ = 0;
  std::uint64_t safe_times_ = 0;
  std::uint64_t overruns_ = 0;
  ChannelCounts<kActions> actions_;
  ChannelCounts<kActions> limits_;
};

}  // namespace eagerx
