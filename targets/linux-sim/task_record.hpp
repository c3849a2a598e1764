// Returns and successes of a run's episodes, for the summary.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/summary.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Only the constructor, describe() and the functions after it allocate. Sums are doubles. Records
/// nothing for a graph without a task.
class TaskRecord {
 public:
  explicit TaskRecord(const std::vector<Fields::Outcome>& outcomes);

  void step(const OutcomeView& outcome);
  /// An episode counts from its first step on, also if the run ended before it did.
  void end_episode();
  void describe(Summary& summary) const;
  /// Steps in which a term of the reward was not finite.
  void count(Summary& summary) const;
  /// The first of them, or nothing.
  std::string not_finite() const { return first_; }

 private:
  void note_not_finite(const OutcomeView& outcome);

  std::vector<std::string> numbers_;  // names: the reward itself, its terms
  std::size_t terms() const { return numbers_.size() - 1; }
  bool has_begun_ = false;
  std::uint64_t step_ = 0;
  double return_ = 0.0;
  std::vector<double> sums_;                                       // [terms]
  bool success_ = false, terminated_ = false, truncated_ = false;  // of the last step
  std::uint64_t episodes_ = 0, successes_ = 0, terminations_ = 0, truncations_ = 0;
  Statistic returns_;
  std::vector<Statistic> term_sums_;       // [terms]
  std::vector<std::uint32_t> not_finite_;  // [1 + terms] steps
  std::string first_;
};

}  // namespace eagerx::linux_sim
