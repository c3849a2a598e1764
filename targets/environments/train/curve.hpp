// The learning curve, as CSV and as a picture.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace eagerx::train {

/// One iteration. NaN where there is nothing yet, or no evaluation.
struct CurvePoint {
  double steps;               // of all environments so far
  double mean_return;         // of the last 100 episodes that ended, or of all if there are fewer
  double success;             // share of them, 0 to 1
  double evaluation_return;   // of the deterministic policy
  double evaluation_success;  // 0 to 1
  double deviation;           // of the actions, mean; their range is -1…1
  double step_size;           // of Adam
  double divergence;          // of the last update
  double stage = kNone;       // of the task, from 1; behind the last one it is as written
  double stage_success = kNone;  // of the deterministic policy in it, 0 to 1
  double stage_return = kNone;

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
};

std::string curve_csv(const std::vector<CurvePoint>& points);
/// Return (left axis) and success (right axis) over steps.
std::string curve_svg(const std::vector<CurvePoint>& points, const std::string& title);

/// The same of several trainings: means over them, and between the least and the most a band. One
/// that has ended stays as it was.
std::string curves_svg(const std::vector<std::vector<CurvePoint>>& trainings,
                       const std::string& title);
/// The rows of curve_csv() of all trainings, each after its seed.
std::string curves_csv(const std::vector<std::vector<CurvePoint>>& trainings,
                       std::uint64_t first_seed);

}  // namespace eagerx::train
