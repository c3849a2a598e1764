#include "targets/environments/client/intervals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace eagerx::client {

Interval wilson(std::uint64_t successes, std::uint64_t runs) {
  if (runs == 0) return {};
  constexpr double kZ = 1.959963984540054;  // 97.5 % of a standard normal are below
  const auto n = static_cast<double>(runs);
  const double p = static_cast<double>(successes) / n;
  const double middle = p + kZ * kZ / (2.0 * n);
  const double half = kZ * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n));
  const double scale = 1.0 + kZ * kZ / n;
  // At the ends they are 0 and 1 but for rounding.
  return {successes == 0 ? 0.0 : (middle - half) / scale,
          successes == runs ? 1.0 : (middle + half) / scale};
}

Mean mean_of(const std::vector<double>& values) {
  // 97.5 % are below, with one degree of freedom and more; of many nearly as the normal one.
  constexpr double kStudent[] = {12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23,
                                 2.20,  2.18, 2.16, 2.14, 2.13, 2.12, 2.11, 2.10, 2.09, 2.09};
  constexpr double kMany = 2.0;
  Mean result;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) result.mean += value / count;
  if (values.size() < 2) return result;
  double squares = 0.0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  const std::size_t free = values.size() - 1;
  const double factor = free <= std::size(kStudent) ? kStudent[free - 1] : kMany;
  result.half = factor * std::sqrt(squares / (count - 1.0) / count);
  return result;
}

std::string text_of(const Mean& mean) {
  constexpr double kWhole = 99.5;  // from here on two digits would need an exponent
  const std::string half =
      mean.half < kWhole ? fmt::format("{:.2g}", mean.half) : fmt::format("{:.0f}", mean.half);
  return fmt::format("{:.4g} +- {}", mean.mean, half);
}

}  // namespace eagerx::client
