// What a graph's task says of the episodes of a run, for the summary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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
};

/// Nothing of it allocates but describe(). Sums are doubles.
template <class Outcome>
requires requires {
  Outcome::kTerms;
}
class TaskRecord<Outcome> {
 public:
  void step(const Outcome& outcome) {
    last_ = outcome;
    has_begun_ = true;
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
    returns_.add(return_, episodes_);
    for (std::size_t i = 0; i < Outcome::kTerms; ++i) terms_[i].add(sums_[i], episodes_);
    return_ = 0.0;
    sums_ = {};
    has_begun_ = false;
  }

  void describe(Summary& summary) const {
    if (episodes_ == 0) return;
    const auto of_all = [&](std::uint64_t count) {
      return std::to_string(count) + " of " + std::to_string(episodes_) + " episodes";
    };
    summary.more.emplace_back("return:", returns_.text(""));
    std::size_t term = 0;
    last_.for_each([&](const std::string& name, auto value) {
      if (std::is_same_v<decltype(value), bool> || name == "reward") return;
      summary.more.emplace_back("sum of task." + name + ":", terms_[term++].mean_text(""));
    });
    summary.more.emplace_back("success:", of_all(successes_));
    summary.more.emplace_back("terminated:", of_all(terminations_));
    summary.more.emplace_back("truncated:", of_all(truncations_));
  }

 private:
  Outcome last_{};
  bool has_begun_ = false;                      // an episode
  double return_ = 0.0;                         // of this episode
  std::array<double, Outcome::kTerms> sums_{};  // of this episode
  std::uint64_t episodes_ = 0, successes_ = 0, terminations_ = 0, truncations_ = 0;
  Statistic returns_;
  std::array<Statistic, Outcome::kTerms> terms_{};
};

}  // namespace eagerx::linux_sim
