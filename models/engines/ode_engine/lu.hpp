// Small systems of linear equations.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <utility>

namespace eagerx::models {

/// P·A = L·U of a matrix A [N][N], by Gaussian elimination with partial pivoting; Golub, Van Loan:
/// Matrix Computations, 4th edition, 2013, algorithm 3.4.1. In a fixed order, so with the same bits
/// everywhere. If A is singular, solutions are infinite or NaN.
template <class Real, std::size_t N>
class Lu {
 public:
  using Matrix = std::array<Real, N * N>;  // row-major

  constexpr explicit Lu(const Matrix& a) : lu_(a) {
    for (std::size_t i = 0; i < N; ++i) row_[i] = i;
    for (std::size_t k = 0; k < N; ++k) {
      exchange(k);
      for (std::size_t i = k + 1; i < N; ++i) {
        const Real factor = at(i, k) / at(k, k);
        at(i, k) = factor;
        for (std::size_t j = k + 1; j < N; ++j) at(i, j) -= factor * at(k, j);
      }
    }
  }

  /// x [N] with A·x = b.
  constexpr Array<Real, N> solve(const Array<Real, N>& b) const {
    Array<Real, N> x{};
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = b[row_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= lu_[i * N + j] * x[j];
    }
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t j = i + 1; j < N; ++j) x[i] -= lu_[i * N + j] * x[j];
      x[i] = x[i] / lu_[i * N + i];
    }
    return x;
  }

 private:
  constexpr Real& at(std::size_t i, std::size_t j) { return lu_[i * N + j]; }

  /// Brings the largest number of column k, from row k on, to row k.
  constexpr void exchange(std::size_t k) {
    std::size_t largest = k;
    for (std::size_t i = k + 1; i < N; ++i) {
      if (eagerx::abs(at(i, k)) > eagerx::abs(at(largest, k))) largest = i;
    }
    if (largest == k) return;
    std::swap(row_[k], row_[largest]);
    for (std::size_t j = 0; j < N; ++j) std::swap(at(k, j), at(largest, j));
  }

  Matrix lu_;
  std::array<std::size_t, N> row_{};  // of A and b
};

}  // namespace eagerx::models
