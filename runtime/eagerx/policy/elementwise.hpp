// Elementwise operations of a network with constants: scaling, shifting, clipping. `c`
// holds one constant for all numbers or one for each. Each result is rounded once.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/policy/panel.hpp>

namespace eagerx::policy {

template <std::size_t N, std::size_t Constants>
constexpr float constant_for(const float (&c)[Constants], std::size_t i) {
  static_assert(Constants == 1 || Constants == N, "one constant, or one for each number");
  return c[Constants == 1 ? 0 : i];
}

/// y = x + c.
template <class R, std::size_t N, std::size_t Constants>
inline void add(const float (&c)[Constants], const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i] + R(constant_for<N>(c, i));
}

/// y = x - c.
template <class R, std::size_t N, std::size_t Constants>
inline void subtract(const float (&c)[Constants], const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i] - R(constant_for<N>(c, i));
}

/// y = c x.
template <class R, std::size_t N, std::size_t Constants>
inline void multiply(const float (&c)[Constants], const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i] * R(constant_for<N>(c, i));
}

/// y = x / c.
template <class R, std::size_t N, std::size_t Constants>
inline void divide(const float (&c)[Constants], const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i] / R(constant_for<N>(c, i));
}

/// y = max(x, c); NaN stays NaN.
template <class R, std::size_t N, std::size_t Constants>
inline void at_least(const float (&c)[Constants], const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) {
    const R bound(constant_for<N>(c, i));
    y[i] = eagerx::select(x[i] < bound, bound, x[i]);
  }
}

/// y = min(x, c); NaN stays NaN.
template <class R, std::size_t N, std::size_t Constants>
inline void at_most(const float (&c)[Constants], const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) {
    const R bound(constant_for<N>(c, i));
    y[i] = eagerx::select(bound < x[i], bound, x[i]);
  }
}

/// y[i] = x[from[i]]: another order, or some of the numbers.
template <class Index, class R, std::size_t N, std::size_t M>
inline void reorder(const Index (&from)[M], const R (&x)[N], R (&y)[M]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = x[from[i]];
}

/// y = A(x): an activation that follows no layer.
template <Activation A, std::size_t N>
inline void apply(const float (&x)[N], float (&y)[N], float slope = 0.0F) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i];
  activate_all<A, N>(y, slope);
}

}  // namespace eagerx::policy
