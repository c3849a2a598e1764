#include "targets/environments/train/signs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace eagerx::train {
namespace {

constexpr double kPercent = 100.0;

bool any_success(const std::vector<CurvePoint>& curve) {
  return std::ranges::any_of(curve, [](const CurvePoint& point) {
    return point.success > 0.0 || point.evaluation_success > 0.0;
  });
}

/// Mean of the evaluations' returns from one share of the curve to another, 0 to 1.
double mean_return(const std::vector<double>& returns, double from, double to) {
  const auto at = [&](double share) {
    return static_cast<std::size_t>(share * static_cast<double>(returns.size()));
  };
  double sum = 0.0;
  for (std::size_t i = at(from); i < at(to); ++i) sum += returns[i];
  return sum / static_cast<double>(std::max<std::size_t>(at(to) - at(from), 1));
}

std::string flat(const std::vector<CurvePoint>& curve) {
  constexpr std::size_t kEnough = 12;
  constexpr double kHalf = 0.5, kThreeQuarters = 0.75, kLittle = 0.01;
  std::vector<double> returns;
  for (const CurvePoint& point : curve) {
    if (!std::isnan(point.evaluation_return)) returns.push_back(point.evaluation_return);
  }
  if (returns.size() < kEnough) return {};
  const auto [low, high] = std::ranges::minmax(returns);
  const double before = mean_return(returns, kHalf, kThreeQuarters);
  const double rise = mean_return(returns, kThreeQuarters, 1.0) - before;
  const double scale = std::max({high - low, kLittle * std::abs(high), 1e-12});
  if (std::abs(rise) > kLittle * scale) return {};
  return fmt::format("the return has stayed at {:.4g} since {} steps", before,
                     rounded(curve.back().steps * kHalf));
}

/// The evaluations of a while, or the last ones.
struct Success {
  double share, mean_return;
};

/// A return that rises while episodes no longer succeed.
std::string at_odds(const std::vector<CurvePoint>& curve) {
  constexpr std::size_t kLast = 3;
  constexpr double kMuch = 0.5, kHalf = 0.5;
  std::vector<Success> all;
  for (const CurvePoint& point : curve) {
    if (!std::isnan(point.evaluation_return))
      all.push_back({point.evaluation_success, point.evaluation_return});
  }
  if (all.size() <= kLast) return {};
  const auto last = std::span(all).last(kLast), before = std::span(all).first(all.size() - kLast);
  const Success best = *std::ranges::max_element(before, {}, &Success::share);
  const auto is_worse = [&](const Success& each) {
    return each.share <= kHalf * best.share && each.mean_return > best.mean_return;
  };
  if (best.share < kMuch || !std::ranges::all_of(last, is_worse)) return {};
  return fmt::format(
      "success has fallen from {:.0f} to {:.0f} % of the episodes while the return has risen from "
      "{:.4g} to {:.4g}: the reward wants something else than `success:`",
      kPercent * best.share, kPercent * last.back().share, best.mean_return,
      last.back().mean_return);
}

/// A term that is nearly all of the return hides the others.
std::string dominating(const Evaluation& evaluation, const Description& description) {
  constexpr double kMost = 0.95;
  double sum = 0.0, most = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 0; i < evaluation.terms.size(); ++i) {
    const double size = std::abs(evaluation.terms[i]);
    sum += size;
    if (size <= most) continue;
    most = size;
    at = i;
  }
  if (evaluation.terms.size() < 2 || most < kMost * sum || sum == 0.0) return {};
  return fmt::format("`{}` is {:.0f} % of the reward: the other terms hardly count",
                     description.terms[at], kPercent * most / sum);
}

/// Where each step costs and an end costs nothing, ending is learnt.
std::string early_ends(const Evaluation& evaluation, const Description& description) {
  constexpr double kMost = 0.9;
  const auto ends_early = [&](const Outcome& episode) {
    return !episode.success && episode.steps < description.episode_steps;
  };
  const auto count = std::ranges::count_if(evaluation.outcomes, ends_early);
  const auto all = static_cast<double>(evaluation.outcomes.size());
  if (evaluation.outcomes.empty() || static_cast<double>(count) < kMost * all ||
      evaluation.mean_return >= 0.0)
    return {};
  return fmt::format(
      "{} of {} episodes end early, on average after {:.4g} of {} steps, and the return is below "
      "0: if each step costs and an end does not, ending is learnt. A term that is below 0 where "
      "`terminated:` holds makes ends costly",
      count, evaluation.outcomes.size(), evaluation.mean_steps, description.episode_steps);
}

/// The observation of this column, such as "angle[1]".
std::string column_name(const Description& description, std::size_t column) {
  for (const Space& space : description.observations) {
    if (column < space.size)
      return space.size == 1 ? space.name : fmt::format("{}[{}]", space.name, column);
    column -= space.size;
  }
  return "?";
}

}  // namespace

std::vector<std::string> signs_of(const std::vector<CurvePoint>& curve,
                                  const Evaluation& evaluation, const Description& description) {
  constexpr double kMostSaturated = 0.9, kMostFar = 0.01;
  std::vector<std::string> signs;
  if (description.has_success && !any_success(curve))
    signs.emplace_back(
        "no episode has succeeded yet: `success:` may be out of reach, or episodes too short");
  if (std::string sign = at_odds(curve); !sign.empty()) signs.push_back(std::move(sign));
  if (std::string sign = flat(curve); !sign.empty()) signs.push_back(std::move(sign));
  if (std::string sign = early_ends(evaluation, description); !sign.empty())
    signs.push_back(std::move(sign));
  if (evaluation.saturated > kMostSaturated)
    signs.push_back(fmt::format("{:.0f} % of the actions are at their bounds",
                                kPercent * evaluation.saturated));
  const auto far = std::ranges::max_element(evaluation.far);
  if (far != evaluation.far.end() && *far > kMostFar)
    signs.push_back(fmt::format(
        "`{}` is more than 8 deviations from its mean in {:.0f} % of the steps",
        column_name(description, static_cast<std::size_t>(far - evaluation.far.begin())),
        kPercent * *far));
  if (std::string sign = dominating(evaluation, description); !sign.empty())
    signs.push_back(std::move(sign));
  return signs;
}

}  // namespace eagerx::train
