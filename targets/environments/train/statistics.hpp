// Running mean and variance.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace eagerx::train {

/// Sums of some rows.
struct Sums {
  explicit Sums(std::size_t width) : sum(width), squares(width) {}
  std::vector<double> sum, squares;  // [width]
  double count = 0.0;

  void clear() { *this = Sums(sum.size()); }
  void add(std::size_t i, double x) {
    sum[i] += x;
    squares[i] += x * x;
  }
};

/// Mean and variance of all rows so far (Chan, Golub, LeVeque 1983).
struct Statistics {
  explicit Statistics(std::size_t width) : mean(width), squares(width) {}
  std::vector<double> mean;     // [width]
  std::vector<double> squares;  // [width] sum of the squared differences from the mean
  double count = 0.0;

  void add(const Sums& more) {
    if (more.count == 0.0) return;
    const double all = count + more.count;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const double their_mean = more.sum[i] / more.count;
      const double theirs = more.squares[i] - more.count * their_mean * their_mean;
      const double difference = their_mean - mean[i];
      mean[i] += difference * more.count / all;
      squares[i] +=
          (theirs > 0.0 ? theirs : 0.0) + difference * difference * count * more.count / all;
    }
    count = all;
  }
  /// Further rows count as if there had been at most `most` rows so far.
  void forget_beyond(double most) {
    if (count <= most) return;
    for (double& one : squares) one *= most / count;
    count = most;
  }
  /// 1 / deviation; 1 for a constant, which no scale would help.
  double scale(std::size_t i) const {
    const double variance = count > 0.0 ? squares[i] / count : 0.0;
    const double least = 1e-12 * mean[i] * mean[i];  // float's rounding alone
    return variance > least && variance > 1e-16 ? 1.0 / std::sqrt(variance) : 1.0;
  }
};

}  // namespace eagerx::train
