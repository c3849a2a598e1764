// Counts rewards that are not finite, and names the first of a step. Steps may run in several
// threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <targets/common/reward_check.hpp>
#include <targets/common/run.hpp>
#include <targets/environments/base/place_of_reward.hpp>

namespace eagerx::environments {

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
    std::string text;
    if constexpr (requires { Outcome::kTerms; }) {  // a graph with a task
      target::RewardCheck<Outcome>::for_each_number(
          first_->outcome, [&](std::size_t i, const char* name, auto value) {
            if (i == first_->blamed)
              text = not_finite_text(name, static_cast<double>(value), first_->place);
          });
    }
    return text;
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
