// Polynomials, and sums and products in two words.
#pragma once

#include <array>
#include <eagerx/math/vocabulary.hpp>
#include <utility>

namespace eagerx::detail {

/// Horner's rule: ((c[0] x + c[1]) x + c[2]) … (highest degree first), unrolled.
template <class R, std::size_t N>
[[gnu::always_inline]] constexpr R horner(R x, const std::array<LaneOf<R>, N>& c) {
  R sum = R(c[0]);
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    ((sum = sum * x + R(c[I + 1])), ...);
  }
  (std::make_index_sequence<N - 1>{});
  return sum;
}

/// The unevaluated sum of two numbers: `low` is the part that does not fit into `high`.
template <class R>
struct TwoWords {
  R high;
  R low;
};

/// a + b without error, for |a| >= |b| or a = 0 (Dekker 1971).
template <class R>
[[gnu::always_inline]] constexpr TwoWords<R> exact_sum(R a, R b) {
  const R sum = a + b;
  return {sum, b - (sum - a)};
}

/// x = high + low, each of half as many digits (Veltkamp).
template <class R>
[[gnu::always_inline]] constexpr TwoWords<R> halves(R x) {
  using T = LaneOf<R>;
  const R shifted = R(sizeof(T) == 4 ? T(4097) : T(134217729)) * x;  // (2^12 or 2^27) + 1
  const R high = shifted - (shifted - x);
  return {high, x - high};
}

/// a * b without error, unless it is subnormal or a factor is close to overflow (Dekker 1971;
/// without FMA, which not every target has).
template <class R>
[[gnu::always_inline]] constexpr TwoWords<R> exact_product(R a, R b) {
  const TwoWords<R> x = halves(a);
  const TwoWords<R> y = halves(b);
  const R product = a * b;
  const R low = ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
  return {product, low};
}

}  // namespace eagerx::detail
