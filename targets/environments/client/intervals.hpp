// Confidence intervals of figures from samples.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace eagerx::client {

/// An interval of a probability.
struct Interval {
  double low = 0.0, high = 1.0;
};

/// Score interval of 95 % for a probability of which `successes` of `runs` were seen (Wilson 1927):
/// also near 0 and 1, where the normal interval is too short.
Interval wilson(std::uint64_t successes, std::uint64_t runs);

/// A mean and the half-width of its 95 % interval (Student 1908), which is 0 for fewer than two
/// values.
struct Mean {
  double mean = 0.0, half = 0.0;
};
Mean mean_of(const std::vector<double>& values);
/// "-66.47 +- 160", for people.
std::string text_of(const Mean& mean);

}  // namespace eagerx::client
