// What a graph's task says of the episodes of a run, for the summary.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <targets/common/reward_check.hpp>
#include <targets/common/reward_text.hpp>
#include <targets/common/run.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/summary.hpp>
#include <type_traits>

namespace eagerx::linux_sim {

/// A graph without a task has nothing to record.
template <class Outcome>
class TaskRecord {
 public:
  void step(const Outcome& /*outcome*/) {}
  void end_episode() {}
  void describe(Summary& /*summary*/) const {}
  void count(Summary& /*summary*/) const {}
  std::string not_finite() const { return {}; }
};

/// Nothing of it allocates but describe() and what is behind it. Sums are doubles.
template <class Outcome>
requires requires {
  Outcome::kTerms;
}
class TaskRecord<Outcome> {
 public:
  void step(const Outcome& outcome) {
    last_ = outcome;
    has_begun_ = true;
    ++step_;
    if (!target::RewardCheck<Outcome>::is_finite(outcome)) [[unlikely]]
      note_not_finite(outcome);
    return_ += static_cast<double>(outcome.reward);
    for (std::size_t i = 0; i < Outcome::kTerms; ++i)
      sums_[i] += static_cast<double>(outcome.terms[i]);
  }

  /// An episode counts from its first step on, also if the run ended before it did.
  void end_episode() {
    if (!has_begun_) return;
    ++episodes_;
    successes_ += last_.success ? 1 : 0;
    terminations_ += last_.terminated ? 1 : 0;
    truncations_ += last_.truncated ? 1 : 0;
    if (std::isfinite(return_)) returns_.add(return_, episodes_);
    for (std::size_t i = 0; i < Outcome::kTerms; ++i) {
      if (std::isfinite(sums_[i])) terms_[i].add(sums_[i], episodes_);
    }
    step_ = 0;
    return_ = 0.0;
    sums_ = {};
    has_begun_ = false;
  }

  void describe(Summary& summary) const {
    if (episodes_ == 0) return;
    const auto of_all = [&](std::uint64_t count) {
      return std::to_string(count) + " of " + std::to_string(episodes_) + " episodes";
    };
    const std::uint64_t not_finite = episodes_ - returns_.count();
    const std::string others = not_finite == 0 ? "" : "not finite in " + of_all(not_finite);
    const char* const comma = others.empty() ? "" : "; ";
    summary.more.emplace_back("return:",
                              returns_.count() == 0 ? others : returns_.text("") + comma + others);
    std::size_t term = 0;
    last_.for_each([&](const std::string& name, auto value) {
      if (std::is_same_v<decltype(value), bool> || name == "reward") return;
      const Statistic& sums = terms_[term++];
      if (sums.count() > 0)
        summary.more.emplace_back("sum of task." + name + ":", sums.mean_text(""));
    });
    summary.more.emplace_back("success:", of_all(successes_));
    summary.more.emplace_back("terminated:", of_all(terminations_));
    summary.more.emplace_back("truncated:", of_all(truncations_));
  }

  /// Steps in which a term of the reward was not finite.
  void count(Summary& summary) const {
    check_.for_each_count(
        [&](const char* name, std::uint64_t steps) { summary.faults.emplace_back(name, steps); });
  }
  /// The first of them, or nothing.
  std::string not_finite() const {
    if (!first_) return {};
    return target::not_finite_text(first_->outcome, first_->place, first_->episode, first_->step);
  }

 private:
  [[gnu::noinline]] void note_not_finite(const Outcome& outcome) {
    const std::size_t place = check_.add(outcome);
    if (!first_) first_ = First{outcome, place, episodes_, step_};
  }

  struct First {
    Outcome outcome;
    std::size_t place;
    std::uint64_t episode, step;
  };

  Outcome last_{};
  bool has_begun_ = false;                      // an episode
  double return_ = 0.0;                         // of this episode
  std::array<double, Outcome::kTerms> sums_{};  // of this episode
  std::uint64_t episodes_ = 0, successes_ = 0, terminations_ = 0, truncations_ = 0;
  Statistic returns_;
  std::array<Statistic, Outcome::kTerms> terms_{};
  std::uint64_t step_ = 0;  // of this episode
  target::RewardCheck<Outcome> check_;
  std::optional<First> first_;
};

}  // namespace eagerx::linux_sim
