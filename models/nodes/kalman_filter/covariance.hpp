// The covariance of an estimate.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// P = U·D·Uᵀ with U [N][N] unit upper triangular and D [N] diagonal.
template <class Number, std::size_t N>
struct Factors {
  std::array<Number, N * N> u{};
  std::array<Number, N> d{};
};

/// The factors of a diagonal (N values) or a whole matrix, computed by the compiler; what rounding
/// made negative in a singular matrix is 0. Bierman: Factorization Methods for Discrete Sequential
/// Estimation, 1977, III.4.
template <std::size_t N, std::size_t Size>
constexpr Factors<double, N> factors_of(const std::array<double, Size>& list) {
  static_assert(Size == N || Size == N * N,
                "`p` and `q` have a value for each state, or order x order values");
  Factors<double, N> result;
  for (std::size_t i = 0; i < N; ++i) result.u[i * N + i] = 1.0;
  if constexpr (Size == N) {
    for (std::size_t i = 0; i < N; ++i) result.d[i] = list[i];
    return result;
  } else {
    std::array<double, Size> p = list;
    for (std::size_t j = N; j-- > 0;) {
      result.d[j] = p[j * N + j] > 0.0 ? p[j * N + j] : 0.0;
      for (std::size_t i = 0; i < j; ++i) {
        const double column = p[i * N + j];
        const double u = result.d[j] > 0.0 ? column / result.d[j] : 0.0;
        result.u[i * N + j] = u;
        for (std::size_t k = 0; k <= i; ++k) {
          p[k * N + i] -= p[k * N + j] * u;
          p[i * N + k] = p[k * N + i];
        }
      }
    }
    return result;
  }
}

/// P [N][N] of a filter, kept as its factors: it stays symmetric and positive, and keeps as many
/// digits as P itself in numbers of twice the length. Bierman's update and Thornton's prediction:
/// Grewal, Andrews: Kalman Filtering, 4th edition, 2015, tables 7.11 and 7.13.
template <class Real, std::size_t N>
class Covariance {
 public:
  using Vector = std::array<Real, N>;
  using Matrix = std::array<Real, N * N>;
  using Constants = Factors<double, N>;

  void reset(const Constants& initial) {
    for (std::size_t i = 0; i < N * N; ++i) f_.u[i] = Real(constant<Real>(initial.u[i]));
    for (std::size_t i = 0; i < N; ++i) f_.d[i] = Real(constant<Real>(initial.d[i]));
  }

  /// P := A·P·Aᵀ + Q: rows of [A·U, U of Q], made orthogonal under the weights [D, D of Q].
  void predict(const Matrix& a, const Constants& q) {
    std::array<Vector, N> au;  // A·U
    std::array<Vector, N> qu;  // U of Q
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        Real sum = a[i * N + j];
        for (std::size_t k = 0; k < j; ++k) sum += a[i * N + k] * f_.u[k * N + j];
        au[i][j] = sum;
        qu[i][j] = Real(constant<Real>(q.u[i * N + j]));
      }
    }
    const Vector before = f_.d;
    const auto product = [&](std::size_t i, std::size_t j) {
      Real sum(0);
      for (std::size_t k = 0; k < N; ++k) sum += (au[i][k] * before[k]) * au[j][k];
      for (std::size_t k = 0; k < N; ++k)
        sum += (qu[i][k] * Real(constant<Real>(q.d[k]))) * qu[j][k];
      return sum;
    };
    for (std::size_t j = N; j-- > 0;) {
      f_.d[j] = product(j, j);
      for (std::size_t i = 0; i < j; ++i) {
        const Real u = select(f_.d[j] > Real(0), product(i, j) / f_.d[j], Real(0));
        f_.u[i * N + j] = u;
        for (std::size_t k = 0; k < N; ++k) {
          au[i][k] -= u * au[j][k];
          qu[i][k] -= u * qu[j][k];
        }
      }
    }
  }

  /// One number is measured, c·x with variance r, where `measured` holds: P −= k·c·P. The gain k;
  /// it is not to be used where nothing is measured.
  template <class Truth>
  Vector update(const Vector& c, const Real& r, const Truth& measured) {
    Vector gain{};
    Factors<Real, N> after = f_;
    Real variance = r;
    for (std::size_t j = 0; j < N; ++j) {
      Real f = c[j];  // Uᵀ·c
      for (std::size_t k = 0; k < j; ++k) f += f_.u[k * N + j] * c[k];
      const Real g = f_.d[j] * f;
      const Real before = variance;
      variance += f * g;
      after.d[j] = f_.d[j] * (before / variance);
      const Real slope = -f / before;
      for (std::size_t i = 0; i < j; ++i) {
        const Real u = f_.u[i * N + j];
        after.u[i * N + j] = u + gain[i] * slope;
        gain[i] += g * u;
      }
      gain[j] = g;
    }
    for (std::size_t i = 0; i < N; ++i) gain[i] = gain[i] / variance;
    for (std::size_t i = 0; i < N * N; ++i) f_.u[i] = select(measured, after.u[i], f_.u[i]);
    for (std::size_t i = 0; i < N; ++i) f_.d[i] = select(measured, after.d[i], f_.d[i]);
    return gain;
  }

  /// Of c·x, without noise: c·P·cᵀ.
  [[nodiscard]] Real variance(const Vector& c) const {
    Real sum(0);
    for (std::size_t j = 0; j < N; ++j) {
      Real f = c[j];  // Uᵀ·c
      for (std::size_t k = 0; k < j; ++k) f += f_.u[k * N + j] * c[k];
      sum += f_.d[j] * f * f;
    }
    return sum;
  }

  [[nodiscard]] TruthOf<Real> is_finite() const {
    TruthOf<Real> finite = true;
    for (const Real& x : f_.u) finite = finite && eagerx::isfinite(x);
    for (const Real& x : f_.d) finite = finite && eagerx::isfinite(x);
    return finite;
  }

 private:
  Factors<Real, N> f_{};
};

}  // namespace eagerx::models
