// Dense matrices and Cholesky's factors, for the normal equations.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace eagerx::identification {

// A library for this would have to be installed wherever a program is built.

/// Square, symmetric where Cholesky's factors are taken.
class Matrix {
 public:
  explicit Matrix(std::size_t n, std::size_t columns)
      : columns_(columns), data_(n * columns, 0.0) {}
  double& operator()(std::size_t i, std::size_t k) { return data_[i * columns_ + k]; }
  double operator()(std::size_t i, std::size_t k) const { return data_[i * columns_ + k]; }

 private:
  std::size_t columns_;
  std::vector<double> data_;
};

/// The lower factor in place; false if `a` [n, n] is not positive definite.
inline bool factor(Matrix& a, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k; i < n; ++i) {
      double sum = a(i, k);
      for (std::size_t m = 0; m < k; ++m) sum -= a(i, m) * a(k, m);
      if (i == k && !(sum > 0.0)) return false;
      a(i, k) = i == k ? std::sqrt(sum) : sum / a(k, k);
    }
  }
  return true;
}

/// Solves with the factor; x has the right-hand side first.
inline void solve(const Matrix& factors, std::size_t n, std::vector<double>& x) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= factors(i, k) * x[k];
    x[i] /= factors(i, i);
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= factors(k, i) * x[k];
    x[i] /= factors(i, i);
  }
}

}  // namespace eagerx::identification
