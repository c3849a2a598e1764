// The steady state of numbers that depend only on themselves, such as a filter's covariance.
#pragma once

#include <algorithm>
#include <cstddef>
#include <eagerx/math.hpp>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace eagerx::linearize {

/// d of m·d = right by Gauss, with pivots; empty where m [n][n] is singular.
inline std::vector<double> solved(std::vector<std::vector<double>> m, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (eagerx::abs(m[i][k]) > eagerx::abs(m[pivot][k])) pivot = i;
    }
    if (!(eagerx::abs(m[pivot][k]) > 0.0)) return {};
    std::swap(m[k], m[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = m[i][k] / m[k][k];
      if (factor == 0.0) continue;
      for (std::size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
      right[i] -= factor * right[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right[k] -= m[k][j] * right[j];
    right[k] /= m[k][k];
  }
  return right;
}

/// Numbers of a node on which no number of anything else and no input has an effect, and that do
/// not rest: by node. `a` [n][n]: derivatives of all numbers; by number, its `node` (-1: of none),
/// whether it `moves`, and whether it is `independent` of inputs.
inline std::vector<std::vector<std::size_t>> independent_numbers(
    const std::vector<std::vector<double>>& a, const std::vector<std::ptrdiff_t>& node,
    const std::vector<bool>& moves, const std::vector<bool>& independent) {
  const std::size_t n = a.size();
  std::vector<bool> constant(n, true), alone(n);  // a parameter or a clock; what is looked for
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k)
      constant[i] = constant[i] && a[i][k] == (i == k ? 1.0 : 0.0);
    alone[i] = independent[i] && node[i] >= 0 && !constant[i];
  }
  const auto has_effect = [&](std::size_t k, std::size_t i) {
    return a[i][k] != 0.0 && !(alone[k] && node[k] == node[i]) && !(constant[k] && !moves[k]);
  };
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; alone[i] && k < n; ++k) {
        if (!has_effect(k, i)) continue;
        alone[i] = false;
        again = true;
      }
    }
  }
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t first = 0; first < n; ++first) {
    if (!alone[first]) continue;
    std::vector<std::size_t> own;
    bool any = false;
    for (std::size_t i = first; i < n; ++i) {
      if (!alone[i] || node[i] != node[first]) continue;
      own.push_back(i);
      any = any || moves[i];
      alone[i] = false;
    }
    if (any) groups.push_back(std::move(own));
  }
  return groups;
}

/// Where x := f(x) comes to rest: the iteration itself, and steps of Newton's method between its
/// rounds, for slow ones. On the Riccati equation these are Hewer's, and converge quadratically
/// from each stabilizing gain (IEEE Transactions on Automatic Control 16, 1971).
class Settling {
 public:
  using Numbers = std::vector<double>;
  using Map = std::function<Numbers(const Numbers&)>;
  using Slopes = std::function<std::vector<Numbers>(const Numbers&)>;  // [n][n] of f

  Settling(Map f, Slopes slopes) : f_(std::move(f)), slopes_(std::move(slopes)) {}

  /// False if x does not come to rest; then it is anything.
  bool run(Numbers& x) {
    largest_.assign(x.size(), 0.0);
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
      for (int i = 0; i < kSteps; ++i) {
        Numbers next = f_(x);
        if (!are_finite(next)) return false;
        const bool rests = is_at_rest(x, next);
        change_ = change(x, next);
        x = std::move(next);
        if (rests) return true;
      }
      while (newton(x)) {
      }
      if (!(change_ < before / 2.0)) break;  // it circles, or only rounding is left
      before = change_;
    }
    return change_ < kRounding;
  }

 private:
  static constexpr int kRounds = 10, kSteps = 200, kMostNewton = 20;
  static constexpr std::size_t kLargestNewton = 400;
  static constexpr double kRounding = 1e-12;

  static bool are_finite(const Numbers& x) {
    return std::all_of(x.begin(), x.end(), [](double each) { return eagerx::isfinite(each); });
  }
  /// To its last bits.
  static bool is_at_rest(const Numbers& x, const Numbers& next) {
    constexpr double kBits = 4.0 * std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (eagerx::abs(next[i] - x[i]) > kBits * eagerx::abs(next[i])) return false;
    }
    return true;
  }
  /// The largest change, relative to the maximum of each number.
  double change(const Numbers& x, const Numbers& next) {
    double most = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      largest_[i] = std::max({largest_[i], eagerx::abs(x[i]), eagerx::abs(next[i])});
      if (largest_[i] > 0.0) most = std::max(most, eagerx::abs(next[i] - x[i]) / largest_[i]);
    }
    return most;
  }
  /// Takes a step that halves the change; false without one.
  bool newton(Numbers& x) {
    if (x.size() > kLargestNewton || newtons_ >= kMostNewton) return false;
    ++newtons_;
    const Numbers next = f_(x);
    std::vector<Numbers> m = slopes_(x);
    Numbers right(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      m[i][i] -= 1.0;
      right[i] = x[i] - next[i];
    }
    Numbers there = solved(std::move(m), std::move(right));
    if (there.empty()) return false;
    for (std::size_t i = 0; i < x.size(); ++i) there[i] += x[i];
    if (!are_finite(there)) return false;
    const Numbers after = f_(there);
    if (!are_finite(after)) return false;
    const Numbers largest = largest_;
    const double smaller = change(there, after);
    if (!(smaller < change_ / 2.0)) {
      largest_ = largest;
      return false;
    }
    change_ = smaller;
    x = after;
    return true;
  }

  Map f_;
  Slopes slopes_;
  Numbers largest_;
  double change_ = 0.0;
  int newtons_ = 0;
};

}  // namespace eagerx::linearize
