// The guard of a controller without an engine: its actions are measurements, and its observations
// are the outputs to the world.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/channel_counts.hpp>
#include <eagerx/safe_output.hpp>
#include <eagerx/verdict.hpp>
#include <optional>
#include <type_traits>

namespace eagerx {

/// If a measurement is late or not finite, or an output is not finite, the declared outputs replace
/// the controller's, and no node runs in that step. `Limits` is the generated struct of that name.
/// All zero until the first reset(); until then every output has its safe value.
template <class Limits>
class OutputGuard {
 public:
  using Action = typename Limits::Action;
  using Observation = typename Limits::Observation;
  static constexpr bool kTakesOver = true;
  static constexpr std::size_t kOutputs = Limits::kOutputNames.size();

  void reset() {
    verdict_.reset(false);
    acts_ = true;
    begins_anew_ = false;
    was_not_finite_ = false;
    is_reset_ = true;
    if constexpr (kDetectsFrozen) frozen_.same = {};
    Limits::for_each_kept(outputs_, [](auto& keeper, const auto& safe) { keeper.reset(safe); });
  }

  /// The outputs after a reset, before the first measurement: the safe values.
  Observation begin(Observation seen) {
    remember(seen);
    Limits::for_each_output(seen, outputs_, [](auto& window, auto& keeper, const auto& /*safe*/) {
      show(window, keeper);
    });
    return seen;
  }

  /// Returns the measurement for the nodes instead of `action`, if acts(). `late_in_a_row`: number
  /// of consecutive steps, up to now, later than `max_lateness`.
  Action check(Action action, std::uint64_t late_in_a_row) {
    return checked(action, true, late_in_a_row, is_frozen(action));
  }
  /// The same for a step without a measurement.
  Action miss(std::uint64_t late_in_a_row) {
    ++missing_;
    return checked(Limits::safe(), false, late_in_a_row, false);
  }
  /// Whether the nodes run in the last checked step.
  bool acts() const { return acts_; }
  /// Whether the nodes are reset before that step, because a safe output has ended.
  bool begins_anew() const { return begins_anew_; }

  /// The guarded outputs after the nodes have run.
  void leave(Observation& seen) {
    was_not_finite_ = false;
    remember(seen);
    bool right = true;
    Limits::for_each_output(seen, outputs_,
                            [&](const auto& window, const auto& /*keeper*/, const auto& safe) {
                              right = right && is_finite_within(window.back(), safe.space);
                            });
    if (!right && !may_leave(seen)) {
      verdict_.refuse();
      seen = safe(seen);
      return;
    }
    Limits::for_each_output(seen, outputs_, [&](auto& window, auto& keeper, const auto& safe) {
      const auto& message = window.back();
      keeper.leave(right ? message : safe.space.clipped(message), safe);
      show(window, keeper);
    });
  }

  /// The outputs of a step in which no node ran. `nothing`: an observation without messages.
  Observation stay(const Observation& nothing) { return safe(last(nothing)); }

  /// The same for the end of a run, without holding outputs.
  Observation stop(const Observation& nothing) {
    ++stops_;
    return safe(last(nothing), false);
  }

  /// Before the first reset: the safe values, regardless of the declared `hold` and `ramp`.
  Observation before_reset(Observation nothing) {
    Limits::for_each_output(nothing, outputs_, [](auto& window, auto& keeper, const auto& safe) {
      keeper.reset(safe);
      show(window, keeper);
    });
    return nothing;
  }

  /// Calls f(name, count) for each count.
  template <class F>
  void for_each_count(F&& f) const {
    verdict_.for_each_count(f);
    f("safe: action missing", missing_);
    if constexpr (kDetectsFrozen)
      frozen_.frozen.for_each(f, "safe: action frozen", Limits::kActionNames);
    not_finite_.for_each(f, "safe: output not finite", Limits::kOutputNames);
    limits_.for_each(f, "safe: output out of limits", Limits::kOutputNames);
    f("safe: stopped", stops_);
  }

 private:
  static constexpr std::size_t kActions = Limits::kActionNames.size();
  static constexpr bool kDetectsFrozen = [] {
    for (const std::uint32_t steps : Limits::kFrozen) {
      if (steps > 0) return true;
    }
    return false;
  }();
  struct Nothing {};
  /// Number of consecutive steps in which each measurement was the same, bit for bit.
  struct Frozen {
    Action last{};
    std::array<std::uint32_t, kActions> same{};
    ChannelCounts<kActions> frozen;
  };

  Action checked(Action action, bool seen, std::uint64_t late_in_a_row, bool is_wrong) {
    const bool was_safe = verdict_.is_safe();
    acts_ = is_reset_ && verdict_.check(action, seen, late_in_a_row, is_wrong);
    begins_anew_ = acts_ && was_safe && (Limits::kResetsNodes || was_not_finite_);
    return action;
  }

  /// Whether a measurement has been the same for the number of steps in `frozen:`.
  bool is_frozen([[maybe_unused]] Action& action) {
    bool result = false;
    if constexpr (kDetectsFrozen) {
      std::size_t channel = 0;
      Limits::for_each_pair(action, frozen_.last, [&](const auto& now, const auto& before) {
        std::uint32_t& same = frozen_.same[channel];
        bool equal = same > 0;  // there was one before
        for (std::size_t i = 0; i < size_of<std::remove_cvref_t<decltype(now)>>; ++i)
          equal = equal && element(now, i) == element(before, i);
        same = !equal ? 1 : same < Limits::kFrozen[channel] ? same + 1 : same;
        if (Limits::kFrozen[channel] > 0 && same >= Limits::kFrozen[channel]) {
          frozen_.frozen.add(channel);
          result = true;
        }
        ++channel;
      });
      frozen_.last = action;
    }
    return result;
  }

  static constexpr bool kRemembers = !Limits::kAllOutputs;

  void remember(const Observation& seen) {
    if constexpr (kRemembers) last_ = seen;
  }
  const Observation& last(const Observation& nothing) const {
    if constexpr (kRemembers) return last_ ? *last_ : nothing;
    return nothing;
  }

  /// Replaces its window with the one message that leaves, with `seq` 0.
  template <class Window, class Keeper>
  static void show(Window& window, const Keeper& keeper) {
    window = std::remove_cvref_t<Window>(&keeper.message(), 1, 1);
  }

  /// Whether every output may leave, possibly after being moved into its limits.
  [[gnu::noinline, gnu::cold]] bool may_leave(Observation& seen) {
    bool right = true;
    std::size_t channel = 0;
    Limits::for_each_output(seen, outputs_,
                            [&](const auto& window, const auto& /*keeper*/, const auto& safe) {
                              const auto& message = window.back();
                              if (!is_finite(message)) {
                                not_finite_.add(channel);
                                was_not_finite_ = true;
                                right = false;
                              } else if (!safe.space.contains(message)) {
                                limits_.add(channel);
                                right = right && Limits::kSafety.clips;
                              }
                              ++channel;
                            });
    return right;
  }

  Observation safe(Observation seen, bool holds = true) {
    Limits::for_each_output(seen, outputs_, [&](auto& window, auto& keeper, const auto& safe) {
      keeper.be_safe(safe, holds);
      show(window, keeper);
    });
    return seen;
  }

  Verdict<Limits> verdict_;
  typename Limits::Outputs outputs_{};
  // The last messages of the nodes, for observations that are not outputs.
  [[no_unique_address]] std::conditional_t<kRemembers, std::optional<Observation>, Nothing> last_;
  bool is_reset_ = false;
  bool acts_ = false;
  bool begins_anew_ = false;
  bool was_not_finite_ = false;  // the last step of the nodes
  ChannelCounts<kOutputs> not_finite_;
  ChannelCounts<kOutputs> limits_;
  [[no_unique_address]] std::conditional_t<kDetectsFrozen, Frozen, Nothing> frozen_;
  std::uint64_t missing_ = 0;
  std::uint64_t stops_ = 0;
};

}  // namespace eagerx
