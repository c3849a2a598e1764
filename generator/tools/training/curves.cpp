#include "generator/tools/training/curves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostCurvePoints = 1000;  // of a line

struct CurvePoint {
  double x = 0.0, y = 0.0, low = 0.0, high = 0.0;
};

/// The values of a curve that are drawn; nullptr: it has none.
using Values = std::function<const std::vector<double>*(const LearningCurve&)>;

/// One curve at steps that grow: its last value at or before them.
class Follower {
 public:
  Follower(const LearningCurve& curve, const std::vector<double>& values)
      : steps_(curve.steps), values_(values) {}
  double at(double steps) {
    for (; next_ < steps_.size() && steps_[next_] <= steps; ++next_) {
      if (!std::isnan(values_[next_])) last_ = values_[next_];
    }
    return last_;
  }

 private:
  const std::vector<double>& steps_;
  const std::vector<double>& values_;
  std::size_t next_ = 0;
  double last_ = std::numeric_limits<double>::quiet_NaN();
};

/// The steps at which some curve has a value.
std::vector<double> steps_of(const std::vector<LearningCurve>& curves, const Values& values) {
  std::vector<double> steps;
  for (const LearningCurve& curve : curves) {
    const std::vector<double>* const own = values(curve);
    for (std::size_t i = 0; own != nullptr && i < own->size(); ++i) {
      if (!std::isnan((*own)[i])) steps.push_back(curve.steps[i]);
    }
  }
  std::ranges::sort(steps);
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

std::vector<CurvePoint> points_of(const std::vector<LearningCurve>& curves, const Values& values) {
  std::vector<Follower> followers;
  for (const LearningCurve& curve : curves) {
    if (const std::vector<double>* own = values(curve)) followers.emplace_back(curve, *own);
  }
  std::vector<CurvePoint> points;
  for (const double steps : steps_of(curves, values)) {
    CurvePoint point{steps, 0.0, std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()};
    double count = 0.0;
    for (Follower& follower : followers) {
      const double value = follower.at(steps);
      if (std::isnan(value)) continue;
      point.y += value;
      point.low = std::min(point.low, value);
      point.high = std::max(point.high, value);
      count += 1.0;
    }
    point.y /= count;
    points.push_back(point);
  }
  return points;
}

/// So few that a page stays small: the last of each part, with the least and the most of it.
std::vector<CurvePoint> thinned(const std::vector<CurvePoint>& points) {
  if (points.size() <= kMostCurvePoints) return points;
  const std::size_t per = (points.size() + kMostCurvePoints - 1) / kMostCurvePoints;
  std::vector<CurvePoint> few;
  for (std::size_t first = 0; first < points.size(); first += per) {
    const std::size_t last = std::min(first + per, points.size()) - 1;
    CurvePoint point = points[last];
    for (std::size_t i = first; i < last; ++i) {
      point.low = std::min(point.low, points[i].low);
      point.high = std::max(point.high, points[i].high);
    }
    few.push_back(point);
  }
  return few;
}

Json numbers(const std::vector<CurvePoint>& points, double CurvePoint::*which) {
  Json list = Json::list();
  for (const CurvePoint& point : points) list.push_back(point.*which);
  return list;
}

class Chart {
 public:
  Chart(const std::vector<LearningCurve>& curves, const char* name, const char* unit)
      : curves_(curves), json_{{"name", name}, {"unit", unit}, {"lines", Json::list()}} {}

  void add(const std::string& name, const Values& values, std::optional<int> shade = std::nullopt) {
    const std::vector<CurvePoint> all = points_of(curves_, values);
    if (all.empty()) return;
    const std::vector<CurvePoint> points = thinned(all);
    Json line{{"name", name},
              {"x", numbers(points, &CurvePoint::x)},
              {"y", numbers(points, &CurvePoint::y)}};
    if (curves_.size() > 1 || points.size() < all.size()) {
      line["low"] = numbers(points, &CurvePoint::low);
      line["high"] = numbers(points, &CurvePoint::high);
    }
    if (shade) line["shade"] = *shade;
    json_["lines"].push_back(std::move(line));
    has_lines_ = true;
  }
  /// `shade`: its colour on the page; without one it is that of its place.
  void add_column(const std::string& name, std::string_view column,
                  std::optional<int> shade = std::nullopt) {
    const auto found = ranges::find(kCurveColumns, column);
    const auto place = static_cast<std::size_t>(found - kCurveColumns.begin());
    add(
        name, [place](const LearningCurve& curve) { return &curve.columns.at(place); }, shade);
  }
  void put(Json& charts) {
    if (has_lines_) charts.push_back(std::move(json_));
  }

 private:
  const std::vector<LearningCurve>& curves_;
  Json json_;
  bool has_lines_ = false;
};

}  // namespace

Json curve_charts(const std::vector<LearningCurve>& curves, const std::vector<std::string>& terms) {
  Json charts = Json::list();
  constexpr const char* kNoisy = "last 100 episodes, with noise";
  constexpr const char* kEvaluated = "evaluation, without noise";
  constexpr const char* kInStage = "in its stage, without noise";
  for (const auto& [name, unit, noisy, evaluated, in_stage] :
       {std::tuple("Return", "", "return", "eval_return", "stage_return"),
        std::tuple("Success", "%", "success_rate", "eval_success_rate", "stage_success_rate")}) {
    Chart chart(curves, name, unit);
    chart.add_column(kNoisy, noisy);
    chart.add_column(kEvaluated, evaluated, 1);
    chart.add_column(kInStage, in_stage, 2);
    chart.put(charts);
  }
  Chart of_terms(curves, "Terms of the return, in evaluations", "");
  for (std::size_t i = 0; i < terms.size(); ++i)
    of_terms.add(terms[i], [i](const LearningCurve& curve) {
      return i < curve.terms.size() ? &curve.terms[i] : nullptr;
    });
  of_terms.put(charts);
  for (const auto& [name, column] :
       {std::pair("Stage of the task, from 1", "stage"),
        {"KL divergence of an iteration", "approx_kl"},
        {"Learning rate", "learning_rate"},
        {"Standard deviation of the actions, whose range is −1 to 1", "std"}}) {
    Chart chart(curves, name, "");
    chart.add_column(name, column);
    chart.put(charts);
  }
  return charts;
}

}  // namespace eagerx::gen
