// The numbers of SIMD vectors as those of another type. Part of eagerx/simd.hpp.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/registers.hpp>
#include <eagerx/simd.hpp>
#include <type_traits>

namespace eagerx::detail {

/// Lane by lane like `static_cast`.
template <class T, class S, std::size_t N, std::size_t W, std::size_t V>
struct SimdConversion<Simd<T, N, W>, Simd<S, N, V>> {
  using To = Simd<T, N, W>;
  using From = Simd<S, N, V>;
  using Vector = typename To::Vector;
  using Words = Simd<std::int32_t, N>;  // there are instructions for these
  static constexpr bool kIntegers = std::is_integral_v<T> && std::is_integral_v<S>;
  static constexpr bool kOneInteger = std::is_integral_v<T> != std::is_integral_v<S>;
  static constexpr std::size_t kBetween = size_between(sizeof(S), sizeof(T));

  [[gnu::always_inline]] static To of(const From& from) {
    if constexpr (kIntegers) {
      return of_integers(from);
    } else if constexpr (kOneInteger && sizeof(T) == 4 && sizeof(S) == 4) {
      return To::of([&](auto i) { return __builtin_convertvector(from.v[i], Vector); });
    } else if constexpr (kOneInteger && sizeof(T) * sizeof(S) < 16) {
      return To(Words(from));  // float and fewer than 32 bits
#if defined(__AVX512DQ__)
    } else if constexpr (kOneInteger && sizeof(T) * sizeof(S) == 32) {  // float and 64 bits
      return of_one_integer(from);
#endif
    } else if constexpr (kOneInteger && sizeof(T) + sizeof(S) > 8 &&
                         !std::is_same_v<T, std::int32_t> && !std::is_same_v<S, std::int32_t>) {
      Words words;  // which mostly are enough
      return fit(from, words) ? To(words) : one_by_one(from);
    } else {
      return one_by_one(from);
    }
  }

 private:
  [[gnu::always_inline]] static To of_integers(const From& from) {
    if constexpr (kBetween == sizeof(T)) {
      To to;
      convert_integers(from, to);
      return to;
    } else {
      using Signed = typename SignedOf<kBetween>::type;
      using Between = std::conditional_t<std::is_signed_v<S>, Signed, std::make_unsigned_t<Signed>>;
      return To(Simd<Between, N>(from));
    }
  }

  [[gnu::always_inline]] static To of_one_integer(const From& from) {
    return To::of([&](auto i) {
      if constexpr (sizeof(T) > sizeof(S)) {
        return __builtin_convertvector(
            (lanes_from<i * To::kWidth, To::kWidth, From::kWidth>(&from.v[0])), Vector);
      } else if constexpr (From::kCount == To::kCount) {
        return __builtin_convertvector(from.v[i], Vector);
      } else {
        using Half = typename VectorOf<T, From::kWidth>::type;
        return picked<0, 1, To::kWidth>(__builtin_convertvector(from.v[2 * i], Half),
                                        __builtin_convertvector(from.v[2 * i + 1], Half));
      }
    });
  }

  /// Whether all numbers, truncated, fit into std::int32_t; `words` are the results.
  [[gnu::always_inline]] static bool fit(const From& from, Words& words) {
    if constexpr (std::is_floating_point_v<S>) {
      const auto inside = (from > From(S(-0x1p31F))) & (from < From(S(0x1p31F)));
      if (any(!inside)) return false;
    } else if constexpr (std::is_unsigned_v<S>) {
      constexpr auto kMost = From(static_cast<S>(0x7fffffff));
      if (sizeof(S) >= 4 && any(from > kMost)) return false;
    } else if constexpr (sizeof(S) == 8) {
      return halves_fit(from, words);
    }
    words = Words(from);
    return true;
  }
  /// Whether the upper half of each number is the sign of the lower one, which are `words`.
  [[gnu::always_inline]] static bool halves_fit(const From& from, Words& words) {
    words = Words(from);
    Words upper;
    convert_integers<1>(from, upper);
    return !any((words >> 31) != upper);
  }

  [[gnu::always_inline]] static To one_by_one(const From& from) {
    const From copy = from;  // what has an address stays in memory: that are copies
    To to;
    put_one_by_one(copy, to);
    return to;
  }
  static void put_one_by_one(const From& from, To& to) {
    using Number [[gnu::may_alias]] = S;
    using Result [[gnu::may_alias]] = T;
    const auto* const numbers = reinterpret_cast<const Number*>(&from);
    auto* const results = reinterpret_cast<Result*>(&to);
    for (std::size_t i = 0; i < N; ++i) results[i] = static_cast<T>(numbers[i]);
  }
};

}  // namespace eagerx::detail
