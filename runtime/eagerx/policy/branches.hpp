// What networks with branches need besides layers: parts of values, values that come together, and
// functions of each number. Each result is rounded once; sums go from the first to the last number.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>

namespace eagerx::policy {

/// `Count` numbers of `x` from `First` on, without a copy.
template <std::size_t First, std::size_t Count, std::size_t N>
inline const float (&slice(const float (&x)[N]))[Count] {
  static_assert(First + Count <= N, "a slice lies inside of its value");
  return reinterpret_cast<const float(&)[Count]>(x[First]);
}

/// A buffer as a value of `Count` numbers.
template <std::size_t Count, std::size_t N>
inline float (&front(float (&buffer)[N]))[Count] {
  static_assert(Count <= N, "a value lies inside of its buffer");
  return reinterpret_cast<float(&)[Count]>(buffer);
}

/// y: the numbers of all values, one value behind the other.
template <std::size_t M, std::size_t... N>
inline void join(float (&y)[M], const float (&... x)[N]) {
  static_assert((N + ...) == M, "a joined value has the numbers of its parts");
  std::size_t at = 0;
  const auto add = [&](const float* part, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) y[at + i] = part[i];
    at += count;
  };
  (add(x, N), ...);
}

/// One number goes with each of the others.
template <std::size_t M, std::size_t N>
constexpr float number_for(const float (&x)[N], std::size_t i) {
  static_assert(N == M || N == 1, "values of one size, or one number");
  return x[N == 1 ? 0 : i];
}

/// y = a + b.
template <std::size_t M, std::size_t A, std::size_t B>
inline void sum(float (&y)[M], const float (&a)[A], const float (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) + number_for<M>(b, i);
}

/// y = a - b.
template <std::size_t M, std::size_t A, std::size_t B>
inline void difference(float (&y)[M], const float (&a)[A], const float (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) - number_for<M>(b, i);
}

/// y = a b.
template <std::size_t M, std::size_t A, std::size_t B>
inline void product(float (&y)[M], const float (&a)[A], const float (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) * number_for<M>(b, i);
}

/// y = a / b.
template <std::size_t M, std::size_t A, std::size_t B>
inline void quotient(float (&y)[M], const float (&a)[A], const float (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) / number_for<M>(b, i);
}

/// y: a where the condition is not zero, else b. The other one may be NaN.
template <std::size_t M, std::size_t C, std::size_t A, std::size_t B>
inline void select(float (&y)[M], const float (&condition)[C], const float (&a)[A],
                   const float (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) {
    y[i] = number_for<M>(condition, i) != 0.0F ? number_for<M>(a, i) : number_for<M>(b, i);
  }
}

template <std::size_t N>
inline void sin(const float (&x)[N], float (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::sin(x[i]);
}
template <std::size_t N>
inline void cos(const float (&x)[N], float (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::cos(x[i]);
}
template <std::size_t N>
inline void exp(const float (&x)[N], float (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::exp(x[i]);
}
template <std::size_t N>
inline void abs(const float (&x)[N], float (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::abs(x[i]);
}
template <std::size_t N>
inline void sqrt(const float (&x)[N], float (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::sqrt(x[i]);
}
/// 1 where x > 0, else 0.
template <std::size_t N>
inline void above_zero(const float (&x)[N], float (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i] > 0.0F ? 1.0F : 0.0F;
}

/// Each row of N / M numbers becomes their sum.
template <std::size_t N, std::size_t M>
inline void row_sum(const float (&x)[N], float (&y)[M]) {
  constexpr std::size_t kLength = N / M;
  static_assert(kLength * M == N, "whole rows");
  for (std::size_t row = 0; row < M; ++row) {
    float total = 0.0F;
    for (std::size_t i = 0; i < kLength; ++i) total = total + x[row * kLength + i];
    y[row] = total;
  }
}

/// … their mean.
template <std::size_t N, std::size_t M>
inline void row_mean(const float (&x)[N], float (&y)[M]) {
  constexpr std::size_t kLength = N / M;
  row_sum(x, y);
  for (std::size_t row = 0; row < M; ++row) y[row] = y[row] / static_cast<float>(kLength);
}

/// … the root of the sum of their squares.
template <std::size_t N, std::size_t M>
inline void row_norm(const float (&x)[N], float (&y)[M]) {
  constexpr std::size_t kLength = N / M;
  static_assert(kLength * M == N, "whole rows");
  for (std::size_t row = 0; row < M; ++row) {
    float total = 0.0F;
    for (std::size_t i = 0; i < kLength; ++i) {
      const float number = x[row * kLength + i];
      total = total + number * number;
    }
    y[row] = eagerx::sqrt(total);
  }
}

}  // namespace eagerx::policy
