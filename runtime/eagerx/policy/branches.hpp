// Operations of networks with branches: parts of values, values that come together, and
// functions of each number. Each result is rounded once; sums go from the first to the last number.
// R is float, or a SIMD vector of them.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>

namespace eagerx::policy {

/// `Count` numbers of `x` starting at `First`, without a copy.
template <std::size_t First, std::size_t Count, class R, std::size_t N>
inline const R (&slice(const R (&x)[N]))[Count] {
  static_assert(First + Count <= N, "a slice lies inside of its value");
  return reinterpret_cast<const R(&)[Count]>(x[First]);
}

/// A buffer as a value of `Count` numbers.
template <std::size_t Count, class R, std::size_t N>
inline R (&front(R (&buffer)[N]))[Count] {
  static_assert(Count <= N, "a value lies inside of its buffer");
  return reinterpret_cast<R(&)[Count]>(buffer);
}

/// y: the concatenated numbers of all values.
template <class R, std::size_t M, std::size_t... N>
inline void join(R (&y)[M], const R (&... x)[N]) {
  static_assert((N + ...) == M, "a joined value has the numbers of its parts");
  std::size_t at = 0;
  const auto add = [&](const R* part, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) y[at + i] = part[i];
    at += count;
  };
  (add(x, N), ...);
}

/// A single number is combined with each of the others.
template <std::size_t M, class R, std::size_t N>
constexpr const R& number_for(const R (&x)[N], std::size_t i) {
  static_assert(N == M || N == 1, "values of one size, or one number");
  return x[N == 1 ? 0 : i];
}

/// y = a + b.
template <class R, std::size_t M, std::size_t A, std::size_t B>
inline void sum(R (&y)[M], const R (&a)[A], const R (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) + number_for<M>(b, i);
}

/// y = a - b.
template <class R, std::size_t M, std::size_t A, std::size_t B>
inline void difference(R (&y)[M], const R (&a)[A], const R (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) - number_for<M>(b, i);
}

/// y = a b.
template <class R, std::size_t M, std::size_t A, std::size_t B>
inline void product(R (&y)[M], const R (&a)[A], const R (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) * number_for<M>(b, i);
}

/// y = a / b.
template <class R, std::size_t M, std::size_t A, std::size_t B>
inline void quotient(R (&y)[M], const R (&a)[A], const R (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) y[i] = number_for<M>(a, i) / number_for<M>(b, i);
}

/// y: a where the condition is not zero, else b. The other one may be NaN.
template <class R, std::size_t M, std::size_t C, std::size_t A, std::size_t B>
inline void select(R (&y)[M], const R (&condition)[C], const R (&a)[A], const R (&b)[B]) {
  for (std::size_t i = 0; i < M; ++i) {
    y[i] = eagerx::select(number_for<M>(condition, i) != R(0.0F), number_for<M>(a, i),
                          number_for<M>(b, i));
  }
}

template <class R, std::size_t N>
inline void sin(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::sin(x[i]);
}
template <class R, std::size_t N>
inline void cos(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::cos(x[i]);
}
template <class R, std::size_t N>
inline void exp(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::exp(x[i]);
}
template <class R, std::size_t N>
inline void abs(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::abs(x[i]);
}
template <class R, std::size_t N>
inline void sqrt(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::sqrt(x[i]);
}
template <class R, std::size_t N>
inline void round_to_even(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::round_to_even(x[i]);
}
template <class R, std::size_t N>
inline void floor(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::floor(x[i]);
}
template <class R, std::size_t N>
inline void ceil(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::ceil(x[i]);
}
/// 1 where x > 0, else 0.
template <class R, std::size_t N>
inline void above_zero(const R (&x)[N], R (&y)[N]) {
  for (std::size_t i = 0; i < N; ++i) y[i] = eagerx::select(x[i] > R(0.0F), R(1.0F), R(0.0F));
}

/// The sum of each row of N / M numbers.
template <class R, std::size_t N, std::size_t M>
inline void row_sum(const R (&x)[N], R (&y)[M]) {
  constexpr std::size_t kLength = N / M;
  static_assert(kLength * M == N, "whole rows");
  for (std::size_t row = 0; row < M; ++row) {
    R total(0.0F);
    for (std::size_t i = 0; i < kLength; ++i) total = total + x[row * kLength + i];
    y[row] = total;
  }
}

/// … their mean.
template <class R, std::size_t N, std::size_t M>
inline void row_mean(const R (&x)[N], R (&y)[M]) {
  constexpr std::size_t kLength = N / M;
  row_sum(x, y);
  for (std::size_t row = 0; row < M; ++row) y[row] = y[row] / R(static_cast<float>(kLength));
}

/// … the root of the sum of their squares.
template <class R, std::size_t N, std::size_t M>
inline void row_norm(const R (&x)[N], R (&y)[M]) {
  constexpr std::size_t kLength = N / M;
  static_assert(kLength * M == N, "whole rows");
  for (std::size_t row = 0; row < M; ++row) {
    R total(0.0F);
    for (std::size_t i = 0; i < kLength; ++i) {
      const R number = x[row * kLength + i];
      total = total + number * number;
    }
    y[row] = eagerx::sqrt(total);
  }
}

}  // namespace eagerx::policy
