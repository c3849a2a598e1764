#include "targets/environments/campaign/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace eagerx::campaign {
namespace {

/// [values] from 1 on, equal values have their mean.
std::vector<double> ranks(const std::vector<double>& values) {
  const std::vector<std::uint32_t> order = order_of(values);
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    const double rank = (static_cast<double>(i + 1) + static_cast<double>(end)) / 2.0;
    for (; i < end; ++i) result[order[i]] = rank;
  }
  return result;
}

}  // namespace

std::array<double, kPercentages.size()> percentiles(const std::vector<double>& sorted) {
  constexpr std::size_t kWhole = 100;
  std::array<double, kPercentages.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::size_t rank = (kPercentages[i] * sorted.size() + kWhole - 1) / kWhole;
    result[i] = sorted.empty() ? 0.0 : sorted[std::max<std::size_t>(rank, 1) - 1];
  }
  return result;
}

std::vector<double> comparable(const std::vector<double>& returns) {
  std::vector<double> result = returns;
  for (double& one : result) {
    if (!std::isfinite(one)) one = -std::numeric_limits<double>::infinity();
  }
  return result;
}

std::vector<std::uint32_t> order_of(const std::vector<double>& values) {
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return values[a] != values[b] ? values[a] < values[b] : a < b;
  });
  return order;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> ranks_a = ranks(a), ranks_b = ranks(b);
  const double mean = (static_cast<double>(a.size()) + 1.0) / 2.0;  // of both
  double both = 0.0, squares_a = 0.0, squares_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double from_a = ranks_a[i] - mean, from_b = ranks_b[i] - mean;
    both += from_a * from_b;
    squares_a += from_a * from_a;
    squares_b += from_b * from_b;
  }
  if (squares_a == 0.0 || squares_b == 0.0) return std::numeric_limits<double>::quiet_NaN();
  return both / std::sqrt(squares_a * squares_b);
}

std::array<Tenth, kTenths> tenths(const std::vector<double>& values, const Results& results) {
  const std::vector<std::uint32_t> order = order_of(values);
  std::array<Tenth, kTenths> all;
  for (std::size_t t = 0; t < kTenths; ++t) {
    const std::size_t first = t * order.size() / kTenths;
    const std::size_t end = (t + 1) * order.size() / kTenths;
    if (first == end) continue;
    all[t] = {values[order[first]], values[order[end - 1]], end - first, 0};
    for (std::size_t i = first; i < end; ++i)
      all[t].successes += results.succeeded(order[i]) ? 1U : 0U;
  }
  return all;
}

std::vector<std::uint32_t> worst_runs(const Results& results, std::size_t count) {
  const std::vector<double> returns = comparable(results.returns);
  std::vector<std::uint32_t> order(results.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(count, order.size()));
  std::partial_sort(order.begin(), end, order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (results.succeeded(a) != results.succeeded(b)) return !results.succeeded(a);
    return returns[a] != returns[b] ? returns[a] < returns[b] : a < b;
  });
  return {order.begin(), end};
}

}  // namespace eagerx::campaign
