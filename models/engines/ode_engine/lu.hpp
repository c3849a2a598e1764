// Small systems of linear equations.
#pragma once

#include <array>
#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <type_traits>
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
    if constexpr (!kInLanes) {
      for (std::size_t i = 0; i < N; ++i) row_[i] = i;
    }
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
    if constexpr (kInLanes) x = exchanged(b);
    for (std::size_t i = 0; i < N; ++i) {
      if constexpr (!kInLanes) x[i] = b[row_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= lu_[i * N + j] * x[j];
    }
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t j = i + 1; j < N; ++j) x[i] -= lu_[i * N + j] * x[j];
      x[i] = x[i] / lu_[i * N + i];
    }
    return x;
  }

 private:
  static constexpr bool kInLanes = lanes<Real> > 1;
  using Row = std::conditional_t<kInLanes, CountOf<Real>, std::size_t>;

  constexpr Real& at(std::size_t i, std::size_t j) { return lu_[i * N + j]; }

  /// Brings the largest number of column k, from row k on, to row k.
  constexpr void exchange(std::size_t k) {
    if constexpr (kInLanes) {
      Row largest(static_cast<LaneOf<Row>>(k));
      Real most = eagerx::abs(at(k, k));
      for (std::size_t i = k + 1; i < N; ++i) {
        const Real size = eagerx::abs(at(i, k));
        const auto larger = size > most;
        most = select(larger, size, most);
        largest = select(larger, Row(static_cast<LaneOf<Row>>(i)), largest);
      }
      row_[k] = largest;
      for (std::size_t i = k + 1; i < N; ++i) {
        const auto here = largest == Row(static_cast<LaneOf<Row>>(i));
        for (std::size_t j = 0; j < N; ++j) exchange_if(here, at(k, j), at(i, j));
      }
    } else {
      std::size_t largest = k;
      for (std::size_t i = k + 1; i < N; ++i) {
        if (eagerx::abs(at(i, k)) > eagerx::abs(at(largest, k))) largest = i;
      }
      if (largest == k) return;
      std::swap(row_[k], row_[largest]);
      for (std::size_t j = 0; j < N; ++j) std::swap(at(k, j), at(largest, j));
    }
  }

  /// b as the rows of A were, one exchange after the other.
  constexpr Array<Real, N> exchanged(Array<Real, N> b) const requires kInLanes {
    for (std::size_t k = 0; k + 1 < N; ++k) {
      for (std::size_t i = k + 1; i < N; ++i)
        exchange_if(row_[k] == Row(static_cast<LaneOf<Row>>(i)), b[k], b[i]);
    }
    return b;
  }
  static constexpr void exchange_if(const TruthOf<Real>& mask, Real& a, Real& b) {
    const Real was = a;
    a = select(mask, b, a);
    b = select(mask, was, b);
  }

  Matrix lu_;
  std::array<Row, N> row_{};  // of A and b; over SIMD vectors with which row each was exchanged
};

}  // namespace eagerx::models
