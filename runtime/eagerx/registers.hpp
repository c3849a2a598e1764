// Registers of numbers: what eagerx/simd.hpp is built of.
//
// Built on the vector types of GCC and Clang (GCC manual, "Using Vector Instructions through
// Built-in Functions").
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math/sqrt.hpp>
#include <type_traits>
#include <utility>

namespace eagerx {

/// Bytes of a register of the target's instruction set.
#if defined(__AVX512F__)
inline constexpr std::size_t kRegisterBytes = 64;
#elif defined(__AVX2__)
inline constexpr std::size_t kRegisterBytes = 32;
#else
inline constexpr std::size_t kRegisterBytes = 16;  // SSE2, NEON; plain code elsewhere
#endif

namespace detail {

template <class T, std::size_t Width>
struct VectorOf {
  using type __attribute__((vector_size(sizeof(T) * Width))) = T;
};

/// How many of N numbers of `Bytes` bytes fit into a register.
template <std::size_t Bytes, std::size_t N>
inline constexpr std::size_t kWidthFor = N* Bytes > kRegisterBytes ? kRegisterBytes / Bytes : N;

template <std::size_t Bytes>
struct SignedOf;
template <>
struct SignedOf<1> {
  using type = std::int8_t;
};
template <>
struct SignedOf<2> {
  using type = std::int16_t;
};
template <>
struct SignedOf<4> {
  using type = std::int32_t;
};
template <>
struct SignedOf<8> {
  using type = std::int64_t;
};

/// The next size on the way from one to another, by doubling or halving.
constexpr std::size_t size_between(std::size_t from, std::size_t to) {
  return from < to ? 2 * from : from > to ? from / 2 : to;
}

/// Calls f(0), f(1), …, f(Count - 1). Not a loop, because compilers keep arrays in registers only
/// if all indexes are constants.
template <std::size_t Count, class F>
[[gnu::always_inline]] inline constexpr void unrolled(F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<Count>{});
}

/// Lanes `First`, `First` + `Step`, … of two registers, `Count` of them.
template <std::size_t First, std::size_t Step, std::size_t Count, class Vector>
[[gnu::always_inline]] inline auto picked(const Vector& a, const Vector& b) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    return __builtin_shufflevector(a, b, (First + Step * I)...);
  }
  (std::make_index_sequence<Count>{});
}

/// Lanes `First` to `First` + `Count` - 1 of registers of `Width` lanes each.
template <std::size_t First, std::size_t Count, std::size_t Width, class Vector>
[[gnu::always_inline]] inline auto lanes_from(const Vector* registers) {
  constexpr std::size_t kRegister = First / Width;
  if constexpr (Count == Width) {
    return registers[kRegister];
  } else if constexpr (Count < Width) {
    return picked<First % Width, 1, Count>(registers[kRegister], registers[kRegister]);
  } else {
    return picked<0, 1, Count>(lanes_from<First, Count / 2, Width>(registers),
                               lanes_from<First + Count / 2, Count / 2, Width>(registers));
  }
}

/// Converts 32-bit integers to 64 bits: one instruction instead of the compiler's three.
template <class To, class From>
[[gnu::always_inline]] inline To widened(const From& from) {
  constexpr bool kWords = sizeof(from[0]) == 4 && sizeof(To) == 2 * sizeof(From);
#if defined(__AVX2__) && !defined(__clang__)
  using Words [[maybe_unused, gnu::vector_size(sizeof(From))]] = int;
  constexpr bool kSigned [[maybe_unused]] =
      std::is_signed_v<std::remove_cvref_t<decltype(from[0])>>;
#if defined(__AVX512F__)
  if constexpr (kWords && sizeof(To) == 64) {
    using Vector = typename VectorOf<long long, 8>::type;
    const auto words = std::bit_cast<Words>(from);
    if constexpr (kSigned)
      return std::bit_cast<To>(
          __builtin_ia32_pmovsxdq512_mask(words, Vector{}, static_cast<char>(-1)));
    if constexpr (!kSigned)
      return std::bit_cast<To>(
          __builtin_ia32_pmovzxdq512_mask(words, Vector{}, static_cast<char>(-1)));
  }
#endif
  if constexpr (kWords && sizeof(To) == 32) {
    const auto words = std::bit_cast<Words>(from);
    if constexpr (kSigned) return std::bit_cast<To>(__builtin_ia32_pmovsxdq256(words));
    if constexpr (!kSigned) return std::bit_cast<To>(__builtin_ia32_pmovzxdq256(words));
  }
#endif
  static_cast<void>(kWords);
  return __builtin_convertvector(from, To);
}

/// The first (`Half` = 0) or second numbers of the pairs in two registers.
template <std::size_t Half, class Vector>
[[gnu::always_inline]] inline Vector halves_of(const Vector& a, const Vector& b) {
#if defined(__AVX2__) && !defined(__clang__)
  if constexpr (sizeof(Vector) == 32 && sizeof(a[0]) == 4) {
    // Within blocks of 128 bits, then these in order: compilers need four instructions.
    using Floats = typename VectorOf<float, 8>::type;
    using Pairs = typename VectorOf<long long, 4>::type;
    constexpr int kChoice = Half == 0 ? 0x88 : 0xdd;
    const Floats mixed =
        __builtin_ia32_shufps256(std::bit_cast<Floats>(a), std::bit_cast<Floats>(b), kChoice);
    return std::bit_cast<Vector>(__builtin_ia32_permdi256(std::bit_cast<Pairs>(mixed), 0xd8));
  }
#endif
  return picked<Half, 2, sizeof(Vector) / sizeof(a[0])>(a, b);
}

/// Converts integers of registers to those of other registers, which are as wide, twice as wide or
/// half as wide, as `static_cast` does. `Half` = 1: of those twice as wide the upper halves.
template <std::size_t Half = 0, class To, class From>
[[gnu::always_inline]] inline void convert_integers(const From& from, To& to) {
  using T = typename To::Lane;
  using S = typename From::Lane;
  using Vector = typename To::Vector;
  unrolled<To::kCount>([&](auto i) {
    constexpr std::size_t kFirst = i * To::kWidth;
    if constexpr (sizeof(T) >= sizeof(S)) {
      to.v[i] = widened<Vector>(lanes_from<kFirst, To::kWidth, From::kWidth>(&from.v[0]));
    } else {  // the lower half of each: in memory, the first
      using Halves = typename VectorOf<T, 2 * From::kWidth>::type;
      if constexpr (From::kCount == 1) {
        const auto whole = std::bit_cast<Halves>(from.v[0]);
        to.v[i] = picked<Half, 2, To::kWidth>(whole, whole);
      } else {
        to.v[i] = halves_of<Half>(std::bit_cast<Halves>(from.v[2 * i]),
                                  std::bit_cast<Halves>(from.v[2 * i + 1]));
      }
    }
  });
}

/// Whether any of the truth values, which set all bits of a lane or none, is true.
template <class Vector>
[[gnu::always_inline]] inline bool any_lane(const Vector& truth) {
#if defined(__SSE2__) && !defined(__clang__)
  using Words [[maybe_unused, gnu::vector_size(sizeof(Vector))]] = long long;
#if defined(__AVX512F__)
  if constexpr (sizeof(Vector) == 64)
    return __builtin_ia32_ptestmq512(std::bit_cast<Words>(truth), std::bit_cast<Words>(truth),
                                     0xff) != 0;
#endif
#if defined(__AVX__)
  if constexpr (sizeof(Vector) == 32)
    return __builtin_ia32_ptestz256(std::bit_cast<Words>(truth), std::bit_cast<Words>(truth)) == 0;
#endif
  using Bytes [[gnu::vector_size(sizeof(Vector))]] = char;
  if constexpr (sizeof(Vector) == 16)
    return __builtin_ia32_pmovmskb128(std::bit_cast<Bytes>(truth)) != 0;
#endif
  constexpr std::size_t kBytes = sizeof(Vector);
  using Word = std::conditional_t<kBytes % 8 == 0, std::uint64_t, std::uint8_t>;
  Word words[kBytes / sizeof(Word)];
  std::memcpy(words, &truth, kBytes);
  Word either = 0;
  for (const Word word : words) either = static_cast<Word>(either | word);
  return either != 0;
}

/// 32-bit truth values as one bit for each lane.
template <class Vector>
[[gnu::always_inline]] inline std::uint64_t lane_bits(const Vector& truth) {
#if defined(__SSE2__) && !defined(__clang__)
#if defined(__AVX512F__)
  if constexpr (sizeof(Vector) == 64)
    return static_cast<std::uint16_t>(__builtin_ia32_ptestmd512(truth, truth, 0xffff));
#endif
#if defined(__AVX__)
  if constexpr (sizeof(Vector) == 32) {
    using Floats [[gnu::vector_size(32)]] = float;
    return static_cast<std::uint64_t>(__builtin_ia32_movmskps256(std::bit_cast<Floats>(truth)));
  }
#endif
  if constexpr (sizeof(Vector) == 16) {
    using Floats [[gnu::vector_size(16)]] = float;
    return static_cast<std::uint64_t>(__builtin_ia32_movmskps(std::bit_cast<Floats>(truth)));
  }
#endif
  constexpr std::size_t kWidth = sizeof(Vector) / 4;
  std::uint32_t lanes[kWidth];
  std::memcpy(lanes, &truth, sizeof lanes);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < kWidth; ++i) bits |= std::uint64_t{lanes[i] & 1U} << i;
  return bits;
}

/// The products of the lower halves of 64-bit numbers: one instruction, which compilers do not
/// always find.
template <class Vector>
[[gnu::always_inline]] inline Vector product_of_lower_halves(const Vector& a, const Vector& b) {
#if defined(__SSE2__) && !defined(__clang__)
  using Halves [[maybe_unused, gnu::vector_size(sizeof(Vector))]] = int;
#if defined(__AVX512F__)
  if constexpr (sizeof(Vector) == 64)
    return std::bit_cast<Vector>(__builtin_ia32_pmuludq512_mask(
        std::bit_cast<Halves>(a), std::bit_cast<Halves>(b), typename VectorOf<long long, 8>::type{},
        static_cast<char>(-1)));
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(Vector) == 32)
    return std::bit_cast<Vector>(
        __builtin_ia32_pmuludq256(std::bit_cast<Halves>(a), std::bit_cast<Halves>(b)));
#endif
  if constexpr (sizeof(Vector) == 16)
    return std::bit_cast<Vector>(
        __builtin_ia32_pmuludq128(std::bit_cast<Halves>(a), std::bit_cast<Halves>(b)));
#endif
  constexpr std::uint64_t kLower = 0xffffffffU;
  return (a & kLower) * (b & kLower);
}

/// b < a ? b : a and a < b ? b : a: one instruction instead of the compiler's two or three.
template <class Vector>
[[gnu::always_inline]] inline Vector smaller(const Vector& a, const Vector& b) {
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(a[0])>, float>) {
#if defined(__AVX512F__) && !defined(__clang__)
    if constexpr (sizeof(Vector) == 64)
      return __builtin_ia32_minps512_mask(b, a, b, static_cast<short>(-1), 4);
#endif
#if defined(__AVX__)
    if constexpr (sizeof(Vector) == 32) return __builtin_ia32_minps256(b, a);
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(Vector) == 16) return __builtin_ia32_minps(b, a);
#endif
  }
  return b < a ? b : a;
}
template <class Vector>
[[gnu::always_inline]] inline Vector larger(const Vector& a, const Vector& b) {
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(a[0])>, float>) {
#if defined(__AVX512F__) && !defined(__clang__)
    if constexpr (sizeof(Vector) == 64)
      return __builtin_ia32_maxps512_mask(b, a, b, static_cast<short>(-1), 4);
#endif
#if defined(__AVX__)
    if constexpr (sizeof(Vector) == 32) return __builtin_ia32_maxps256(b, a);
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(Vector) == 16) return __builtin_ia32_maxps(b, a);
#endif
  }
  return a < b ? b : a;
}

/// The root of each number.
template <class Vector>
[[gnu::always_inline]] inline Vector roots(const Vector& x) {
  using T = std::remove_cvref_t<decltype(x[0])>;
#if !defined(__clang__)
  if constexpr (std::is_same_v<T, float>) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Vector) == 64)
      return __builtin_ia32_sqrtps512_mask(x, x, static_cast<short>(-1), 4);
#endif
#if defined(__AVX__)
    if constexpr (sizeof(Vector) == 32) return __builtin_ia32_sqrtps256(x);
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(Vector) == 16) return __builtin_ia32_sqrtps(x);
#endif
  }
#endif
  Vector root;
  for (std::size_t k = 0; k < sizeof(Vector) / sizeof(T); ++k) root[k] = sqrt(x[k]);
  return root;
}

}  // namespace detail
}  // namespace eagerx
