#include "targets/environments/train/showing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace eagerx::train {

Showing::Showing(const Options& options, const Description& description, std::uint64_t first_step,
                 Table table)
    : description_(description),
      folder_(options.tensorboard),
      table_(std::move(table)),
      progress_(first_step, options.steps, description.has_success, options.is_quiet),
      curve_file_(options.csv) {}

void Showing::open_events(const std::vector<CurvePoint>& curve) {
  if (folder_.empty()) return;
  events_.emplace(folder_, description_.graph);
  for (const CurvePoint& point : curve) events_->append(point);
}

void Showing::warn(const std::string& problem, const char* goes_on) {
  progress_.finish();
  fmt::print(stderr, "warning: {}; the training goes on {}\n", problem, goes_on);
}

void Showing::show(const std::vector<CurvePoint>& curve, const Evaluation& seen) {
  progress_.show(curve.back());
  // A disk that is full now may have room in a second; at the end it is an error.
  const std::string problem = curve_file_.grow(progress_.seconds(), [&] { return table_(curve); });
  if (!problem.empty()) warn(problem, "and tries again");
  if (events_) show_events(curve.back(), seen);
}

void Showing::show_events(const CurvePoint& point, const Evaluation& seen) {
  Scalars terms;
  for (std::size_t i = 0; !std::isnan(point.evaluation_return) && i < seen.terms.size(); ++i)
    terms.emplace_back("terms/" + description_.terms[i], seen.terms[i]);
  const bool was_written = events_->problem().empty();
  events_->append(point, terms);
  if (was_written && !events_->problem().empty()) warn(events_->problem(), "without it");
}

}  // namespace eagerx::train
