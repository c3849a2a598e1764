// Registers of floats, with the words that eagerx/math.hpp is written in (GCC and Clang vector
// extensions).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math.hpp>
#include <utility>

namespace eagerx::policy {

/// Floats in a register.
#if defined(__AVX__)
inline constexpr std::size_t kLanes = 8;
#else
inline constexpr std::size_t kLanes = 4;
#endif

/// A vector of `Lanes` numbers; a plain number for one lane.
template <class T, std::size_t Lanes>
struct VectorOf {
  using type __attribute__((vector_size(sizeof(T) * Lanes))) = T;
};
template <class T>
struct VectorOf<T, 1> {
  using type = T;
};
template <std::size_t Lanes>
using FloatVector = typename VectorOf<float, Lanes>::type;

template <class Vector>
[[gnu::always_inline]] inline Vector load(const float* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Keeps operations on `v` in the order of the source: compilers would finish one sum before they
/// begin the next, and wait for each addition.
template <class Vector>
[[gnu::always_inline]] inline void in_order([[maybe_unused]] Vector& v) {
  if constexpr (sizeof(Vector) >= 16) {  // clang keeps shorter ones elsewhere
#if defined(__AVX512VL__)
    asm volatile("" : "+v"(v));
#elif defined(__SSE2__)
    asm volatile("" : "+x"(v));
#elif defined(__aarch64__)
    asm volatile("" : "+w"(v));
#endif
  }
}

/// `Count` registers of `Width` numbers each. Operations go through the registers one by one: while
/// the result of one is on its way the others are at work.
template <class T, std::size_t Width, std::size_t Count>
struct Registers {
  using Vector = typename VectorOf<T, Width>::type;
  Vector v[Count];

  /// Calls f with the number of each register. No loop: compilers keep arrays in registers only if
  /// they know every index from the start.
  template <class F>
  [[gnu::always_inline]] static void each(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (f(I), ...);
    }
    (std::make_index_sequence<Count>{});
  }

  Registers() = default;
  // x - 0 is x for every x; x + 0 would lose the sign of -0.
  [[gnu::always_inline]] explicit Registers(T x) {
    each([&](std::size_t i) { v[i] = x - Vector{}; });
  }
  /// Register i is f(i).
  template <class F>
  [[gnu::always_inline]] static Registers of(F&& f) {
    Registers result;
    each([&](std::size_t i) { result.v[i] = f(i); });
    return result;
  }
  [[gnu::always_inline]] static Registers load(const T* from) {
    return of([&](std::size_t i) { return policy::load<Vector>(from + i * Width); });
  }
  [[gnu::always_inline]] void store(T* to) const {
    each([&](std::size_t i) { std::memcpy(to + i * Width, &v[i], sizeof v[i]); });
  }
};

template <std::size_t Width, std::size_t Count>
using FloatLanes = Registers<float, Width, Count>;
template <std::size_t Width, std::size_t Count>
using BitLanes = Registers<std::uint32_t, Width, Count>;
/// All bits set where true.
template <std::size_t Width, std::size_t Count>
using MaskLanes = Registers<std::int32_t, Width, Count>;

// NOLINTBEGIN(bugprone-macro-parentheses): a template and an operator stand in no parentheses
#define EAGERX_POLICY_BINARY(R, op)                                                       \
  template <std::size_t W, std::size_t C>                                                 \
  [[gnu::always_inline]] inline R<W, C> operator op(const R<W, C>& a, const R<W, C>& b) { \
    return R<W, C>::of([&](std::size_t i) { return a.v[i] op b.v[i]; });                  \
  }
EAGERX_POLICY_BINARY(FloatLanes, +)
EAGERX_POLICY_BINARY(FloatLanes, -)
EAGERX_POLICY_BINARY(FloatLanes, *)
EAGERX_POLICY_BINARY(FloatLanes, /)
EAGERX_POLICY_BINARY(BitLanes, +)
EAGERX_POLICY_BINARY(BitLanes, -)
EAGERX_POLICY_BINARY(BitLanes, &)
EAGERX_POLICY_BINARY(BitLanes, |)
#undef EAGERX_POLICY_BINARY
// NOLINTEND(bugprone-macro-parentheses)

#define EAGERX_POLICY_COMPARISON(op)                                                     \
  template <std::size_t W, std::size_t C>                                                \
  [[gnu::always_inline]] inline MaskLanes<W, C> operator op(const FloatLanes<W, C>& a,   \
                                                            const FloatLanes<W, C>& b) { \
    return MaskLanes<W, C>::of([&](std::size_t i) { return a.v[i] op b.v[i]; });         \
  }
EAGERX_POLICY_COMPARISON(<)
EAGERX_POLICY_COMPARISON(>=)
EAGERX_POLICY_COMPARISON(==)
#undef EAGERX_POLICY_COMPARISON

template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline FloatLanes<W, C> operator-(const FloatLanes<W, C>& a) {
  return FloatLanes<W, C>::of([&](std::size_t i) { return -a.v[i]; });
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline BitLanes<W, C> operator<<(const BitLanes<W, C>& a, int shift) {
  return BitLanes<W, C>::of(
      [&](std::size_t i) { return a.v[i] << static_cast<std::uint32_t>(shift); });
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline BitLanes<W, C> operator>>(const BitLanes<W, C>& a, int shift) {
  return BitLanes<W, C>::of(
      [&](std::size_t i) { return a.v[i] >> static_cast<std::uint32_t>(shift); });
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline FloatLanes<W, C> select(const MaskLanes<W, C>& mask,
                                                      const FloatLanes<W, C>& when_true,
                                                      const FloatLanes<W, C>& when_false) {
  return FloatLanes<W, C>::of(
      [&](std::size_t i) { return mask.v[i] ? when_true.v[i] : when_false.v[i]; });
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline BitLanes<W, C> bits(const FloatLanes<W, C>& x) {
  using Vector = typename BitLanes<W, C>::Vector;
  return BitLanes<W, C>::of([&](std::size_t i) { return std::bit_cast<Vector>(x.v[i]); });
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline FloatLanes<W, C> unbits(const BitLanes<W, C>& x) {
  using Vector = typename FloatLanes<W, C>::Vector;
  return FloatLanes<W, C>::of([&](std::size_t i) { return std::bit_cast<Vector>(x.v[i]); });
}

/// The smaller number, `b` if they are equal or one is NaN; the larger one. One instruction on x86,
/// where compilers make two or three.
template <class Vector>
[[gnu::always_inline]] inline Vector smaller(Vector a, Vector b) {
#if defined(__AVX__)
  if constexpr (sizeof(Vector) == 32) return __builtin_ia32_minps256(a, b);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(Vector) == 16) return __builtin_ia32_minps(a, b);
#endif
  return a < b ? a : b;
}
template <class Vector>
[[gnu::always_inline]] inline Vector larger(Vector a, Vector b) {
#if defined(__AVX__)
  if constexpr (sizeof(Vector) == 32) return __builtin_ia32_maxps256(a, b);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(Vector) == 16) return __builtin_ia32_maxps(a, b);
#endif
  return a > b ? a : b;
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline FloatLanes<W, C> min(const FloatLanes<W, C>& a,
                                                   const FloatLanes<W, C>& b) {
  return FloatLanes<W, C>::of([&](std::size_t i) { return smaller(b.v[i], a.v[i]); });
}
template <std::size_t W, std::size_t C>
[[gnu::always_inline]] inline FloatLanes<W, C> max(const FloatLanes<W, C>& a,
                                                   const FloatLanes<W, C>& b) {
  return FloatLanes<W, C>::of([&](std::size_t i) { return larger(b.v[i], a.v[i]); });
}

}  // namespace eagerx::policy

namespace eagerx {
template <std::size_t Width, std::size_t Count>
struct LaneTraits<policy::FloatLanes<Width, Count>> {
  using Lane = float;
  using Bits = policy::BitLanes<Width, Count>;
  static constexpr int kLanes = static_cast<int>(Width * Count);
};
}  // namespace eagerx
