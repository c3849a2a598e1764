// SIMD vectors: N numbers that are computed together, like C++26's std::simd, with the operations
// that eagerx/math.hpp and entities use. One lane is one environment (or one sample): its bits are
// those of a plain number.
//
// Built on the vector types of GCC and Clang (GCC manual, "Using Vector Instructions through
// Built-in Functions"). A vector wider than a register is taken apart badly (8 to 10 times slower
// with g++ 12), so a SIMD vector is a few native registers, and operations go through them one by
// one: while the result of one is on its way the others are at work.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math/basic.hpp>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>
#include <eagerx/registers.hpp>
#include <type_traits>
#include <utility>

namespace eagerx {

// Copies register by register: GCC 12 copies the whole through memory, word by word.
// NOLINTBEGIN(bugprone-macro-parentheses): the name of a class
#define EAGERX_SIMD_COPIES(Class)                                                                \
  [[gnu::always_inline]] constexpr Class(const Class& other) {                                   \
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) { v[i] = other.v[i]; }); \
  }                                                                                              \
  [[gnu::always_inline]] constexpr Class& operator=(const Class& other) {                        \
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) { v[i] = other.v[i]; }); \
    return *this;                                                                                \
  }
// NOLINTEND(bugprone-macro-parentheses)

namespace detail {

/// Defined in eagerx/simd_conversion.hpp.
template <class To, class From>
struct SimdConversion;

}  // namespace detail

/// N truth values for SIMD vectors of numbers of `Bytes` bytes: true sets all bits of a lane.
template <std::size_t Bytes, std::size_t N, std::size_t Width = detail::kWidthFor<Bytes, N>>
struct Mask {
  using Lane = typename detail::SignedOf<Bytes>::type;
  static constexpr std::size_t kCount = N / Width;
  static constexpr std::size_t kWidth = Width;
  using Vector = typename detail::VectorOf<Lane, kWidth>::type;
  Vector v[kCount];

  Mask() = default;
  EAGERX_SIMD_COPIES(Mask)
  [[gnu::always_inline]] Mask(bool all) {  // NOLINT(google-explicit-constructor): as bool is
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) {
      v[i] = Vector{} - static_cast<Lane>(all);
    });
  }
  /// The truth values for SIMD vectors of numbers of another width.
  template <std::size_t Other>
  requires(Other != Bytes) [[gnu::always_inline]] explicit Mask(const Mask<Other, N>& other) {
    if constexpr (constexpr std::size_t kBetween = detail::size_between(Other, Bytes);
                  kBetween == Bytes) {
      detail::convert_integers(other, *this);
    } else {
      *this = Mask(Mask<kBetween, N>(other));
    }
  }
  /// Register i is f(i).
  template <class F>
  [[gnu::always_inline]] static Mask of(F&& f) {
    Mask result;
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) { result.v[i] = f(i); });
    return result;
  }

  // As for bool, except that both sides are computed.
  [[gnu::always_inline]] friend Mask operator&(const Mask& a, const Mask& b) {
    return of([&](auto i) __attribute__((always_inline)) { return a.v[i] & b.v[i]; });
  }
  [[gnu::always_inline]] friend Mask operator|(const Mask& a, const Mask& b) {
    return of([&](auto i) __attribute__((always_inline)) { return a.v[i] | b.v[i]; });
  }
  [[gnu::always_inline]] friend Mask operator&&(const Mask& a, const Mask& b) { return a & b; }
  [[gnu::always_inline]] friend Mask operator||(const Mask& a, const Mask& b) { return a | b; }
  [[gnu::always_inline]] friend Mask operator!(const Mask& a) {
    return of([&](auto i) __attribute__((always_inline)) { return ~a.v[i]; });
  }
  [[gnu::always_inline]] friend Mask operator==(const Mask& a, const Mask& b) {
    return of([&](auto i) __attribute__((always_inline)) { return ~(a.v[i] ^ b.v[i]); });
  }
  [[gnu::always_inline]] friend Mask operator!=(const Mask& a, const Mask& b) {
    return of([&](auto i) __attribute__((always_inline)) { return a.v[i] ^ b.v[i]; });
  }
};

/// N numbers of type T, in registers of `Width` numbers each.
template <class T, std::size_t N, std::size_t Width = detail::kWidthFor<sizeof(T), N>>
struct Simd {
  static_assert(std::is_arithmetic_v<T> && std::has_single_bit(Width) && N % Width == 0);
  static constexpr std::size_t kCount = N / Width;
  static constexpr std::size_t kWidth = Width;
  using Vector = typename detail::VectorOf<T, kWidth>::type;
  using Truth = Mask<sizeof(T), N, Width>;
  using Lane = T;
  Vector v[kCount];

  Simd() = default;
  EAGERX_SIMD_COPIES(Simd)
  /// `x` in every lane. x - 0 is x for every x; x + 0 would lose the sign of -0.
  // NOLINTNEXTLINE(google-explicit-constructor): numbers broadcast
  [[gnu::always_inline]] constexpr Simd(T x) {
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) { v[i] = x - Vector{}; });
  }
  /// Converts the numbers of another SIMD vector to T, lane by lane like `static_cast`.
  template <class S, std::size_t Other>
  requires(!std::is_same_v<S, T>)
      [[gnu::always_inline]] explicit Simd(const Simd<S, N, Other>& other)
      : Simd(detail::SimdConversion<Simd, Simd<S, N, Other>>::of(other)) {}
  /// Register i is f(i).
  template <class F>
  [[gnu::always_inline]] static Simd of(F&& f) {
    Simd result;
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) { result.v[i] = f(i); });
    return result;
  }
  /// N numbers from memory, and to memory.
  [[gnu::always_inline]] static Simd load(const T* from) {
    return of([&](auto i) __attribute__((always_inline)) {
      Vector one;
      std::memcpy(&one, from + i * kWidth, sizeof one);
      return one;
    });
  }
  [[gnu::always_inline]] void store(T* to) const {
    detail::unrolled<kCount>([&](auto i) __attribute__((always_inline)) {
      std::memcpy(to + i * kWidth, &v[i], sizeof v[i]);
    });
  }

// NOLINTBEGIN(bugprone-macro-parentheses): an operator stands in no parentheses
#define EAGERX_SIMD_OPERATOR(op)                                                             \
  [[gnu::always_inline]] friend Simd operator op(const Simd& a, const Simd& b) {             \
    return of([&](auto i) __attribute__((always_inline)) { return a.v[i] op b.v[i]; });      \
  }                                                                                          \
  [[gnu::always_inline]] Simd& operator op##=(const Simd& b) {                               \
    detail::unrolled<kCount>([&](auto i)                                                     \
                                 __attribute__((always_inline)) { v[i] = v[i] op b.v[i]; }); \
    return *this;                                                                            \
  }
  EAGERX_SIMD_OPERATOR(+)
  EAGERX_SIMD_OPERATOR(-)
  EAGERX_SIMD_OPERATOR(*)
  EAGERX_SIMD_OPERATOR(/)
#undef EAGERX_SIMD_OPERATOR

#define EAGERX_SIMD_BITS(op)                                                                     \
  [[gnu::always_inline]] friend Simd operator op(const Simd& a,                                  \
                                                 const Simd& b) requires std::is_integral_v<T> { \
    return of([&](auto i) __attribute__((always_inline)) { return a.v[i] op b.v[i]; });          \
  }
  EAGERX_SIMD_BITS(&)
  EAGERX_SIMD_BITS(|)
  EAGERX_SIMD_BITS(^)
#undef EAGERX_SIMD_BITS

#define EAGERX_SIMD_COMPARISON(op)                                                             \
  [[gnu::always_inline]] friend Truth operator op(const Simd& a, const Simd& b) {              \
    return Truth::of([&](auto i) __attribute__((always_inline)) { return a.v[i] op b.v[i]; }); \
  }
  EAGERX_SIMD_COMPARISON(<)
  EAGERX_SIMD_COMPARISON(<=)
  EAGERX_SIMD_COMPARISON(>)
  EAGERX_SIMD_COMPARISON(>=)
  EAGERX_SIMD_COMPARISON(==)
  EAGERX_SIMD_COMPARISON(!=)
#undef EAGERX_SIMD_COMPARISON
  // NOLINTEND(bugprone-macro-parentheses)

  [[gnu::always_inline]] friend Simd operator-(const Simd& a) {
    return of([&](auto i) __attribute__((always_inline)) { return -a.v[i]; });
  }
  [[gnu::always_inline]] friend Simd operator~(const Simd& a) requires std::is_integral_v<T> {
    return of([&](auto i) __attribute__((always_inline)) { return ~a.v[i]; });
  }
  [[gnu::always_inline]] friend Simd operator<<(const Simd& a,
                                                int shift) requires std::is_integral_v<T> {
    return of([&](auto i)
                  __attribute__((always_inline)) { return a.v[i] << static_cast<T>(shift); });
  }
  [[gnu::always_inline]] friend Simd operator>>(const Simd& a,
                                                int shift) requires std::is_integral_v<T> {
    return of([&](auto i)
                  __attribute__((always_inline)) { return a.v[i] >> static_cast<T>(shift); });
  }
};

template <class T, std::size_t N, std::size_t W>
struct LaneTraits<Simd<T, N, W>> {
  using Lane = T;
  using Bits = Simd<std::make_unsigned_t<typename detail::SignedOf<sizeof(T)>::type>, N, W>;
  static constexpr int kLanes = static_cast<int>(N);
};

template <std::size_t Bytes, std::size_t N, std::size_t W>
struct LaneTraits<Mask<Bytes, N, W>> {
  using Lane = bool;
  static constexpr int kLanes = static_cast<int>(N);
};

/// Messages may consist of SIMD vectors and masks, too.
template <class T, std::size_t N, std::size_t W>
inline constexpr bool is_number<Simd<T, N, W>> = true;
template <std::size_t Bytes, std::size_t N, std::size_t W>
inline constexpr bool is_number<Mask<Bytes, N, W>> = true;

/// `when_true` in the lanes whose mask is true, `when_false` in the others; both are computed.
template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<T, N, W> select(
    const Mask<sizeof(T), N, W>& mask, const Simd<T, N, W>& when_true,
    const std::type_identity_t<Simd<T, N, W>>& when_false) {
  return Simd<T, N, W>::of([&](auto i) __attribute__((always_inline)) {
    return mask.v[i] ? when_true.v[i] : when_false.v[i];
  });
}
/// With the truth values of numbers of another width.
template <std::size_t Bytes, class T, std::size_t N, std::size_t W, std::size_t Other>
requires(Bytes != sizeof(T)) [[gnu::always_inline]] inline Simd<T, N, W> select(
    const Mask<Bytes, N, Other>& mask, const Simd<T, N, W>& when_true,
    const std::type_identity_t<Simd<T, N, W>>& when_false) {
  return select(Mask<sizeof(T), N, W>(mask), when_true, when_false);
}
/// Of two masks.
template <std::size_t Bytes, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Mask<Bytes, N, W> select(
    const Mask<Bytes, N, W>& mask, const std::type_identity_t<Mask<Bytes, N, W>>& when_true,
    const std::type_identity_t<Mask<Bytes, N, W>>& when_false) {
  return (mask & when_true) | ((!mask) & when_false);
}

/// True if the mask is true in any lane.
template <std::size_t Bytes, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline bool any(const Mask<Bytes, N, W>& mask) {
  using Truth = Mask<Bytes, N, W>;
  typename Truth::Vector all = mask.v[0];
  detail::unrolled<Truth::kCount>([&](auto i) __attribute__((always_inline)) { all |= mask.v[i]; });
  return detail::any_lane(all);
}

/// A bit for each lane, set if the mask is true.
template <std::size_t N, std::size_t W>
requires(N <= 64) [[gnu::always_inline]] inline std::uint64_t lane_bits(const Mask<4, N, W>& mask) {
  std::uint64_t all = 0;
  detail::unrolled<Mask<4, N, W>::kCount>([&](auto i) __attribute__((always_inline)) {
    all |= detail::lane_bits(mask.v[i]) << (i * W);
  });
  return all;
}

/// The IEEE 754 bits of each number, and back.
template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline BitsOf<Simd<T, N, W>> bits(const Simd<T, N, W>& x) {
  using Bits = BitsOf<Simd<T, N, W>>;
  return Bits::of([&](auto i) __attribute__((always_inline)) {
    return std::bit_cast<typename Bits::Vector>(x.v[i]);
  });
}
template <std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<float, N, W> unbits(const Simd<std::uint32_t, N, W>& x) {
  using Real = Simd<float, N, W>;
  return Real::of([&](auto i) __attribute__((always_inline)) {
    return std::bit_cast<typename Real::Vector>(x.v[i]);
  });
}
template <std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<double, N, W> unbits(const Simd<std::uint64_t, N, W>& x) {
  using Real = Simd<double, N, W>;
  return Real::of([&](auto i) __attribute__((always_inline)) {
    return std::bit_cast<typename Real::Vector>(x.v[i]);
  });
}

/// The product of the lower 32 bits of each lane.
template <std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<std::uint64_t, N, W> product_of_lower_halves(
    const Simd<std::uint64_t, N, W>& a, const Simd<std::uint64_t, N, W>& b) {
  return Simd<std::uint64_t, N, W>::of([&](auto i) __attribute__((always_inline)) {
    return detail::product_of_lower_halves(a.v[i], b.v[i]);
  });
}

template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<T, N, W> sqrt(const Simd<T, N, W>& x) {
  return Simd<T, N, W>::of([&](auto i)
                               __attribute__((always_inline)) { return detail::roots(x.v[i]); });
}

/// Like those of plain numbers.
template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<T, N, W> min(const Simd<T, N, W>& a,
                                                const std::type_identity_t<Simd<T, N, W>>& b) {
  return Simd<T, N, W>::of([&](auto i) __attribute__((always_inline)) {
    return detail::smaller(a.v[i], b.v[i]);
  });
}
template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline Simd<T, N, W> max(const Simd<T, N, W>& a,
                                                const std::type_identity_t<Simd<T, N, W>>& b) {
  return Simd<T, N, W>::of([&](auto i) __attribute__((always_inline)) {
    return detail::larger(a.v[i], b.v[i]);
  });
}

/// Lane `i`: 0 <= i < N.
template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline T lane(const Simd<T, N, W>& x, int i) {
  T value;
  std::memcpy(&value, reinterpret_cast<const char*>(&x) + static_cast<std::size_t>(i) * sizeof(T),
              sizeof value);
  return value;
}
template <std::size_t Bytes, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline bool lane(const Mask<Bytes, N, W>& mask, int i) {
  typename Mask<Bytes, N, W>::Lane value;
  std::memcpy(&value, reinterpret_cast<const char*>(&mask) + static_cast<std::size_t>(i) * Bytes,
              sizeof value);
  return value != 0;
}
template <class T, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline void set_lane(Simd<T, N, W>& x, int i,
                                            std::type_identity_t<T> value) {
  std::memcpy(reinterpret_cast<char*>(&x) + static_cast<std::size_t>(i) * sizeof(T), &value,
              sizeof value);
}
template <std::size_t Bytes, std::size_t N, std::size_t W>
[[gnu::always_inline]] inline void set_lane(Mask<Bytes, N, W>& mask, int i, bool value) {
  using Lane = typename Mask<Bytes, N, W>::Lane;
  const auto all = static_cast<Lane>(-static_cast<int>(value));
  std::memcpy(reinterpret_cast<char*>(&mask) + static_cast<std::size_t>(i) * Bytes, &all,
              sizeof all);
}

}  // namespace eagerx

#include <eagerx/simd_conversion.hpp>
