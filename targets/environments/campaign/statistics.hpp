// Statistics of runs. All are functions of the results in the order of the runs, so that no number
// of threads can change them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "targets/environments/campaign/results.hpp"
#include "targets/environments/client/intervals.hpp"

namespace eagerx::campaign {

using client::Interval;
using client::wilson;

inline constexpr std::array<unsigned, 7> kPercentages = {0, 5, 25, 50, 75, 95, 100};

/// The percentiles kPercentages of values that are sorted: the smallest value with at least p % of
/// all values at or below it (nearest rank). So each is a value of some run.
std::array<double, kPercentages.size()> percentiles(const std::vector<double>& sorted);

/// Returns for comparisons: one that is not finite counts as worse than all others.
std::vector<double> comparable(const std::vector<double>& returns);

/// Runs by their value, from the lowest on; of equal ones the earlier run first.
std::vector<std::uint32_t> order_of(const std::vector<double>& values);

/// Spearman's rank correlation, equal values have the mean of their ranks: -1 to 1. NaN where all
/// values of one are equal.
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

inline constexpr std::size_t kTenths = 10;

/// The runs whose value is in one tenth of all values, from the lowest tenth on.
struct Tenth {
  double low = 0.0, high = 0.0;  // values
  std::uint64_t runs = 0, successes = 0;
};
std::array<Tenth, kTenths> tenths(const std::vector<double>& values, const Results& results);

/// Runs from the worst on, at most `count`: without success first, then by their return, then in
/// their order.
std::vector<std::uint32_t> worst_runs(const Results& results, std::size_t count);

}  // namespace eagerx::campaign
