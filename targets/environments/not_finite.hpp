// Rewards that are no numbers: counted, and the first of a step named. Steps of several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <targets/common/reward_check.hpp>
#include <targets/common/reward_text.hpp>
#include <targets/common/run.hpp>

namespace eagerx::environments {

/// Which environment, and when.
struct PlaceOfReward {
  std::uint32_t environment = 0;  // of the batch
  std::uint32_t number = 0;
  std::uint64_t seed = 0;
  std::uint32_t episode = 0, step = 0;  // from 0 on
};

template <class Graph>
class NotFinite {
 public:
  using Outcome = typename target::OutcomeOf<Graph>::Type;

  /// Before a step of the batch.
  void begin_step() {
    if (first_) first_.reset();
  }
  bool is_any() const { return first_.has_value(); }

  /// By any thread.
  [[gnu::noinline]] void note(const PlaceOfReward& place, const Outcome& outcome) {
    const std::lock_guard lock(mutex_);
    const std::size_t blamed = check_.add(outcome);
    if (!first_ || place.environment < first_->place.environment)
      first_ = First{place, outcome, blamed};
  }

  /// Of the step, in the environment that comes first.
  std::string text() const {
    if constexpr (requires { Outcome::kTerms; }) {
      const PlaceOfReward& place = first_->place;
      return target::not_finite_text(first_->outcome, first_->blamed, place.episode,
                                     std::uint64_t{place.step} + 1) +
             ", of environment " + std::to_string(place.environment) + " (seed " +
             std::to_string(place.seed) + ", number " + std::to_string(place.number) + ")";
    } else {
      return {};  // a graph without a task
    }
  }

  template <class F>
  void for_each_count(F&& f) const {
    check_.for_each_count(f);
  }

 private:
  struct First {
    PlaceOfReward place;
    Outcome outcome;
    std::size_t blamed;
  };
  std::mutex mutex_;
  target::RewardCheck<Outcome> check_;
  std::optional<First> first_;  // of this step
};

}  // namespace eagerx::environments
