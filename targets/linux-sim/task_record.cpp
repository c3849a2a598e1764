#include <cmath>
#include <targets/common/reward_check.hpp>
#include <targets/common/reward_text.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/task_record.hpp>

namespace eagerx::linux_sim {

TaskRecord::TaskRecord(const std::vector<Fields::Outcome>& outcomes) {
  for (const Fields::Outcome& each : outcomes) {
    if (!each.is_flag) numbers_.push_back(each.name);
  }
  if (numbers_.empty()) numbers_.emplace_back("reward");
  sums_.resize(terms());
  term_sums_.resize(terms());
  not_finite_.resize(1 + terms());
}

void TaskRecord::step(const OutcomeView& outcome) {
  if (outcome.terms == nullptr) return;
  success_ = outcome.success;
  terminated_ = outcome.terminated;
  truncated_ = outcome.truncated;
  has_begun_ = true;
  ++step_;
  if (!std::isfinite(outcome.reward)) [[unlikely]]
    note_not_finite(outcome);
  return_ += outcome.reward;
  for (std::size_t i = 0; i < sums_.size(); ++i)
    sums_[i] += number_of(outcome.scalar, outcome.terms, i);
}

void TaskRecord::note_not_finite(const OutcomeView& outcome) {
  const std::size_t place =
      outcome.scalar == Scalar::f64
          ? target::count_not_finite(static_cast<const double*>(outcome.terms), terms(),
                                     not_finite_.data())
          : target::count_not_finite(static_cast<const float*>(outcome.terms), terms(),
                                     not_finite_.data());
  if (!first_.empty()) return;
  const double value =
      place == 0 ? outcome.reward : number_of(outcome.scalar, outcome.terms, place - 1);
  first_ = target::number_not_finite_text(numbers_[place], value, episodes_, step_);
}

void TaskRecord::end_episode() {
  if (!has_begun_) return;
  ++episodes_;
  successes_ += success_ ? 1 : 0;
  terminations_ += terminated_ ? 1 : 0;
  truncations_ += truncated_ ? 1 : 0;
  if (std::isfinite(return_)) returns_.add(return_, episodes_);
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (std::isfinite(sums_[i])) term_sums_[i].add(sums_[i], episodes_);
    sums_[i] = 0.0;
  }
  step_ = 0;
  return_ = 0.0;
  has_begun_ = false;
}

void TaskRecord::describe(Summary& summary) const {
  if (episodes_ == 0) return;
  const auto of_all = [&](std::uint64_t count) {
    return std::to_string(count) + " of " + std::to_string(episodes_) + " episodes";
  };
  const std::uint64_t not_finite = episodes_ - returns_.count();
  const std::string others = not_finite == 0 ? "" : "not finite in " + of_all(not_finite);
  const char* const comma = others.empty() ? "" : "; ";
  summary.more.emplace_back("return:",
                            returns_.count() == 0 ? others : returns_.text("") + comma + others);
  for (std::size_t i = 0; i < term_sums_.size(); ++i) {
    if (term_sums_[i].count() > 0)
      summary.more.emplace_back("sum of task." + numbers_[1 + i] + ":",
                                term_sums_[i].mean_text(""));
  }
  summary.more.emplace_back("success:", of_all(successes_));
  summary.more.emplace_back("terminated:", of_all(terminations_));
  summary.more.emplace_back("truncated:", of_all(truncations_));
}

void TaskRecord::count(Summary& summary) const {
  for (std::size_t i = 0; i < not_finite_.size(); ++i) {
    if (not_finite_[i] > 0)
      summary.faults.emplace_back("not finite: task." + numbers_[i], not_finite_[i]);
  }
}

}  // namespace eagerx::linux_sim
