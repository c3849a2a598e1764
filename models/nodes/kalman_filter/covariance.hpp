// The covariance of an estimate.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// P [N][N], kept symmetric.
template <class Real, std::size_t N>
class Covariance {
 public:
  using Vector = std::array<Real, N>;
  using Matrix = std::array<Real, N * N>;

  /// A diagonal (N values) or a whole matrix.
  template <class Lane, std::size_t Size>
  void reset(const std::array<Lane, Size>& initial) {
    p_ = {};
    add(initial);
  }

  /// P := A·P·Aᵀ + Q, with Q as in reset.
  template <class Lane, std::size_t Size>
  void predict(const Matrix& a, const std::array<Lane, Size>& q) {
    Matrix ap;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < N; ++j) {
        Real sum = a[i * N] * p_[j];
        for (std::size_t k = 1; k < N; ++k) sum += a[i * N + k] * p_[k * N + j];
        ap[i * N + j] = sum;
      }
    }
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Real sum = ap[i * N] * a[j * N];
        for (std::size_t k = 1; k < N; ++k) sum += ap[i * N + k] * a[j * N + k];
        p_[i * N + j] = sum;
        p_[j * N + i] = sum;
      }
    }
    add(q);
  }

  /// One number is measured, c·x with variance r, where `measured` holds: P −= k·c·P. The gain k;
  /// it is not to be used where nothing is measured.
  template <class Truth>
  Vector update(const Vector& c, const Real& r, const Truth& measured) {
    Vector pc;  // P·cᵀ
    for (std::size_t i = 0; i < N; ++i) {
      Real sum = p_[i * N] * c[0];
      for (std::size_t k = 1; k < N; ++k) sum += p_[i * N + k] * c[k];
      pc[i] = sum;
    }
    Real variance = r;
    for (std::size_t i = 0; i < N; ++i) variance += c[i] * pc[i];
    Vector gain;
    for (std::size_t i = 0; i < N; ++i) gain[i] = pc[i] / variance;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const Real after = p_[i * N + j] - gain[i] * pc[j];
        p_[i * N + j] = select(measured, after, p_[i * N + j]);
        p_[j * N + i] = p_[i * N + j];
      }
    }
    return gain;
  }

  [[nodiscard]] TruthOf<Real> is_finite() const {
    TruthOf<Real> finite = true;
    for (const Real& x : p_) finite = finite && eagerx::isfinite(x);
    return finite;
  }

 private:
  template <class Lane, std::size_t Size>
  void add(const std::array<Lane, Size>& list) {
    static_assert(Size == N || Size == N * N,
                  "`p` and `q` have a value for each state, or order x order values");
    if constexpr (Size == N) {
      for (std::size_t i = 0; i < N; ++i) p_[i * N + i] += Real(list[i]);
    } else {
      for (std::size_t i = 0; i < N * N; ++i) p_[i] += Real(list[i]);
    }
  }

  Matrix p_{};
};

}  // namespace eagerx::models
