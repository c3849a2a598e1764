// Learning curves, and the lines that a page draws of them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// Columns of a curve other than `steps`, named as in `train --csv` and `train --record`.
inline constexpr std::array<std::string_view, 10> kCurveColumns = {
    "return",        "success_rate", "eval_return", "eval_success_rate", "std",
    "learning_rate", "approx_kl",    "stage",       "stage_return",      "stage_success_rate"};

/// Of a file; a page of more says nothing.
inline constexpr std::size_t kMostTrainings = 1000;
/// Of all curves of a file together: 400 MB.
inline constexpr std::size_t kMostNumbers = 50'000'000;

/// Of one training, an element an iteration; NaN where there is nothing.
struct LearningCurve {
  std::uint64_t seed = 0;
  std::vector<double> steps;  // of all environments so far; each more than the one before
  std::array<std::vector<double>, kCurveColumns.size()> columns;
  std::vector<std::vector<double>> terms;  // [terms] of the reward, of evaluations
};

/// A list of {name, unit, lines}; a line is {name, x, y}, and, for several curves or for more
/// points than the page shows, {low, high} of the values behind each point. For several curves it
/// is their mean; a curve that has ended keeps its last value.
Json curve_charts(const std::vector<LearningCurve>& curves, const std::vector<std::string>& terms);

}  // namespace eagerx::gen
