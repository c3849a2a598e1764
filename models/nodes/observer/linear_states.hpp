// The state of a linear system in discrete time.
#pragma once

#include <array>
#include <cstddef>
#include <models/nodes/block.hpp>

namespace eagerx::models {

/// Whether state `i` of x := A·x + … moves little in a tick: it is then kept as a compensated sum
/// of (A − 1)·x, which neither stalls nor loses the digits in which A differs from 1.
template <std::size_t Order, std::size_t Size>
constexpr bool is_slow(const std::array<double, Size>& a, std::size_t i) {
  return a[i * Order + i] >= 0.5 && a[i * Order + i] <= 2.0;
}

/// A, with A − 1 in the diagonals of slow states.
template <std::size_t Order, std::size_t Size>
constexpr std::array<double, Size> increments_of(std::array<double, Size> a) {
  for (std::size_t i = 0; i < Order; ++i) {
    if (is_slow<Order>(a, i)) a[i * Order + i] -= 1.0;
  }
  return a;
}

template <class Real, std::size_t N>
struct LinearStates {
  std::array<CompensatedSum<Real>, N> x{};

  void set(std::size_t i, const Real& value) { x[i].set(value); }
  void add(std::size_t i, const Real& value) { x[i] = x[i].plus(value); }
  [[nodiscard]] std::array<Real, N> values() const {
    std::array<Real, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = x[i].value;
    return result;
  }
  /// x := A·x + drive, with A and increments_of(A).
  template <class Matrix, class Increments>
  void advance(const Matrix& a, const Increments& increments, const std::array<Real, N>& drive) {
    const auto before = values();
    for (std::size_t i = 0; i < N; ++i) {
      const Real move = row_times<Real>(increments, i, before) + drive[i];
      if (is_slow<N>(a, i)) {
        add(i, move);
      } else {
        set(i, move);
      }
    }
  }
  [[nodiscard]] TruthOf<Real> is_finite() const {
    TruthOf<Real> finite = true;
    for (const auto& each : x) finite = finite && eagerx::isfinite(each.value);
    return finite;
  }
};

}  // namespace eagerx::models
