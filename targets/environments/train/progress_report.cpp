#include "targets/environments/train/progress_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

namespace eagerx::train {

namespace {

/// `number`: from 1.
std::string stage_name(const Description& description, double number) {
  const auto i = static_cast<std::size_t>(number) - 1;
  return i < description.stages.size() ? fmt::format("stage `{}`", description.stages[i].name)
                                       : "the graph as written";
}

/// "success 45 %, return 12.3"
std::string reached(const CurvePoint& point) {
  const std::string success = std::isnan(point.stage_success)
                                  ? std::string()
                                  : fmt::format("success {:.0f} %, ", 100.0 * point.stage_success);
  return fmt::format("{}return {:.4g}", success, point.stage_return);
}

}  // namespace

ProgressReport::ProgressReport(const Options& options, const Description& description,
                               std::uint64_t first_step, SharedTable table)
    : description_(description),
      seed_(options.settings.seed),
      folder_(options.tensorboard),
      progress_(first_step, options.steps, description.has_success, options.is_quiet, options.name),
      own_table_(options.csv),
      table_(table.file != nullptr ? *table.file : own_table_),
      table_text_(std::move(table.text)),
      own_record_(options, description),
      record_(table.record != nullptr ? *table.record : own_record_) {}

void ProgressReport::open_events(const std::vector<CurvePoint>& curve) {
  if (folder_.empty()) return;
  events_.emplace(folder_, description_.graph, curve);
  if (events_->folder() == folder_) return;
  progress_.finish();
  fmt::print(stderr, "note: `{}` has the curve of another training; that of this one is in `{}`\n",
             folder_, events_->folder());
}

void ProgressReport::warn(const std::string& problem, const char* continues) {
  progress_.finish();
  fmt::print(stderr, "warning: {}; the training continues {}\n", problem, continues);
}

void ProgressReport::write_table(const std::vector<CurvePoint>& curve) {
  table_.write([&] { return table_text_(curve); });
}

void ProgressReport::show(const std::vector<CurvePoint>& curve, const Evaluation& seen) {
  progress_.show(curve.back(), stage_of(curve));
  // A disk that is full now may have room in a second; at the end it is an error.
  // Parallel trainings have begun at different times.
  const std::chrono::duration<double> now_s = std::chrono::steady_clock::now().time_since_epoch();
  for (const std::string& problem : {table_.grow(now_s.count(), [&] { return table_text_(curve); }),
                                     record_.grow(seed_, now_s.count(), curve, seen)}) {
    if (!problem.empty()) warn(problem, "and tries again");
  }
  if (events_) show_events(curve.back(), seen);
}

/// "stage near: success 45 %"
std::string ProgressReport::stage_of(const std::vector<CurvePoint>& curve) const {
  if (std::isnan(curve.back().stage)) return {};
  std::string text = stage_name(description_, curve.back().stage);
  const auto seen = std::find_if(curve.rbegin(), curve.rend(), [&](const CurvePoint& point) {
    return point.stage != curve.back().stage || !std::isnan(point.stage_return);
  });
  if (seen == curve.rend() || seen->stage != curve.back().stage) return text;
  return text + ": " + reached(*seen);
}

void ProgressReport::tell_stage(const std::vector<CurvePoint>& curve) {
  const CurvePoint& point = curve.back();
  progress_.begin_stage(fmt::format("{} is passed after {} steps with {}; {} begins",
                                    stage_name(description_, point.stage), rounded(point.steps),
                                    reached(point), stage_name(description_, point.stage + 1.0)));
}

void ProgressReport::tell_last_evaluation(std::size_t episodes) {
  progress_.say(fmt::format("evaluating the best policy in {} other episodes",
                            rounded(static_cast<double>(episodes))));
}

void ProgressReport::show_events(const CurvePoint& point, const Evaluation& seen) {
  Scalars terms;
  for (std::size_t i = 0; !std::isnan(point.evaluation_return) && i < seen.terms.size(); ++i)
    terms.emplace_back("terms/" + description_.terms[i], seen.terms[i]);
  const bool was_written = events_->problem().empty();
  events_->append(point, terms);
  if (was_written && !events_->problem().empty()) warn(events_->problem(), "without it");
}

}  // namespace eagerx::train
