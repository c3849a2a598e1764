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

/// x := L⁻¹ x with the lower factor.
inline void solve_lower(const Matrix& factors, std::size_t n, std::vector<double>& x) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= factors(i, k) * x[k];
    x[i] /= factors(i, i);
  }
}

/// x := L⁻ᵀ x with the lower factor.
inline void solve_upper(const Matrix& factors, std::size_t n, std::vector<double>& x) {
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= factors(k, i) * x[k];
    x[i] /= factors(i, i);
  }
}

/// Solves with the factor; x has the right-hand side first.
inline void solve(const Matrix& factors, std::size_t n, std::vector<double>& x) {
  solve_lower(factors, n, x);
  solve_upper(factors, n, x);
}

/// Eigenvalues on the diagonal of the symmetric `a` [n, n], eigenvectors in the columns of what it
/// returns: Jacobi's method.
inline Matrix diagonalize(Matrix& a, std::size_t n) {
  constexpr int kSweeps = 30;
  Matrix vectors(n, n);
  for (std::size_t i = 0; i < n; ++i) vectors(i, i) = 1.0;
  const auto turn = [n](Matrix& m, std::size_t p, std::size_t q, double c, double s, bool rows) {
    for (std::size_t i = 0; i < n; ++i) {
      double& x = rows ? m(p, i) : m(i, p);
      double& y = rows ? m(q, i) : m(i, q);
      const double turned = c * x - s * y;
      y = s * x + c * y;
      x = turned;
    }
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t p = 0; p + 1 < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (a(p, q) == 0.0) continue;
        const double angle = 0.5 * std::atan2(2.0 * a(p, q), a(q, q) - a(p, p));
        const double c = std::cos(angle), s = std::sin(angle);
        turn(a, p, q, c, s, false);
        turn(a, p, q, c, s, true);
        turn(vectors, p, q, c, s, false);
      }
    }
  }
  return vectors;
}

}  // namespace eagerx::identification
