// Packs: N numbers that are computed together, in the words that eagerx/math.hpp and entities are
// written in. One lane is one environment (or one sample): its bits are those of a plain number.
//
// Built on the vector types of GCC and Clang (GCC manual, "Using Vector Instructions through
// Built-in Functions"). A vector wider than a register is taken apart badly (8 to 10 times slower
// with g++ 12), so a pack is a few native registers, and operations go through them one by one:
// while the result of one is on its way the others are at work.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math/sqrt.hpp>
#include <eagerx/math/vocabulary.hpp>
#include <eagerx/message.hpp>
#include <type_traits>
#include <utility>

namespace eagerx {

/// Bytes of a register of the instruction set that is compiled for.
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

/// Registers for N numbers of type T, and how many numbers each holds.
template <class T, std::size_t N>
inline constexpr std::size_t kRegistersFor = N * sizeof(T) > kRegisterBytes
                                                 ? N * sizeof(T) / kRegisterBytes
                                                 : 1;

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

/// The lanes of registers one after the other in memory, where loops over them become vectors
/// again. (A copy in an array of their own would go through memory a word at a time.)
template <class Vector, std::size_t Count>
[[gnu::always_inline]] inline auto* lanes_of(Vector (&registers)[Count]) {
  using Plain [[gnu::may_alias]] = std::remove_cvref_t<decltype(registers[0][0])>;
  using Lane = std::conditional_t<std::is_const_v<Vector>, const Plain, Plain>;
  return reinterpret_cast<Lane*>(&registers);
}

/// f(0), f(1), …, f(Count - 1). No loop: compilers keep arrays in registers only if they know every
/// index from the start.
template <std::size_t Count, class F>
[[gnu::always_inline]] inline constexpr void unrolled(F&& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
    (f(std::integral_constant<std::size_t, I>{}), ...);
  }
  (std::make_index_sequence<Count>{});
}

}  // namespace detail

/// N truth values beside packs of numbers of `Bytes` bytes: all bits of a lane are set where true.
template <std::size_t Bytes, std::size_t N>
struct Mask {
  using Lane = typename detail::SignedOf<Bytes>::type;
  static constexpr std::size_t kCount = detail::kRegistersFor<Lane, N>;
  static constexpr std::size_t kWidth = N / kCount;
  using Vector = typename detail::VectorOf<Lane, kWidth>::type;
  Vector v[kCount];

  Mask() = default;
  [[gnu::always_inline]] Mask(bool all) {  // NOLINT(google-explicit-constructor): as bool is
    detail::unrolled<kCount>([&](auto i) { v[i] = Vector{} - static_cast<Lane>(all); });
  }
  /// The truth values beside packs of numbers of another width.
  template <std::size_t Other>
  requires(Other != Bytes) [[gnu::always_inline]] explicit Mask(const Mask<Other, N>& other) {
    const auto* const from = detail::lanes_of(other.v);
    auto* const to = detail::lanes_of(v);
    for (std::size_t i = 0; i < N; ++i) to[i] = static_cast<Lane>(from[i]);
  }
  /// Register i is f(i).
  template <class F>
  [[gnu::always_inline]] static Mask of(F&& f) {
    Mask result;
    detail::unrolled<kCount>([&](auto i) { result.v[i] = f(i); });
    return result;
  }

  // As for bool, except that both sides are computed.
  [[gnu::always_inline]] friend Mask operator&(const Mask& a, const Mask& b) {
    return of([&](auto i) { return a.v[i] & b.v[i]; });
  }
  [[gnu::always_inline]] friend Mask operator|(const Mask& a, const Mask& b) {
    return of([&](auto i) { return a.v[i] | b.v[i]; });
  }
  [[gnu::always_inline]] friend Mask operator&&(const Mask& a, const Mask& b) { return a & b; }
  [[gnu::always_inline]] friend Mask operator||(const Mask& a, const Mask& b) { return a | b; }
  [[gnu::always_inline]] friend Mask operator!(const Mask& a) {
    return of([&](auto i) { return ~a.v[i]; });
  }
  [[gnu::always_inline]] friend Mask operator==(const Mask& a, const Mask& b) {
    return of([&](auto i) { return ~(a.v[i] ^ b.v[i]); });
  }
  [[gnu::always_inline]] friend Mask operator!=(const Mask& a, const Mask& b) {
    return of([&](auto i) { return a.v[i] ^ b.v[i]; });
  }
};

/// N numbers of type T.
template <class T, std::size_t N>
struct Pack {
  static_assert(std::is_arithmetic_v<T> && std::has_single_bit(N), "2^k plain numbers");
  static constexpr std::size_t kCount = detail::kRegistersFor<T, N>;
  static constexpr std::size_t kWidth = N / kCount;
  using Vector = typename detail::VectorOf<T, kWidth>::type;
  using Truth = Mask<sizeof(T), N>;
  Vector v[kCount];

  Pack() = default;
  /// `x` in every lane. x - 0 is x for every x; x + 0 would lose the sign of -0.
  // NOLINTNEXTLINE(google-explicit-constructor): numbers broadcast
  [[gnu::always_inline]] constexpr Pack(T x) {
    detail::unrolled<kCount>([&](auto i) { v[i] = x - Vector{}; });
  }
  /// The numbers of another pack as T, lane by lane as `static_cast` does.
  template <class S>
  requires(!std::is_same_v<S, T>) [[gnu::always_inline]] explicit Pack(const Pack<S, N>& other) {
    if constexpr (std::is_floating_point_v<T> != std::is_floating_point_v<S> &&
                  sizeof(T) + sizeof(S) > 8 && !std::is_same_v<S, std::int32_t> &&
                  !std::is_same_v<T, std::int32_t>) {
      // Below AVX-512 no instruction converts these, but there is one for 32 bits, which mostly do.
      if (fits_32_bits(other)) {
        *this = Pack(Pack<std::int32_t, N>(other));
        return;
      }
    }
    const auto* const from = detail::lanes_of(other.v);
    auto* const to = detail::lanes_of(v);
    for (std::size_t i = 0; i < N; ++i) to[i] = static_cast<T>(from[i]);
  }
  /// Register i is f(i).
  template <class F>
  [[gnu::always_inline]] static Pack of(F&& f) {
    Pack result;
    detail::unrolled<kCount>([&](auto i) { result.v[i] = f(i); });
    return result;
  }
  /// N numbers from memory, and to memory.
  [[gnu::always_inline]] static Pack load(const T* from) {
    Pack result;
    std::memcpy(result.v, from, sizeof result.v);
    return result;
  }
  [[gnu::always_inline]] void store(T* to) const { std::memcpy(to, v, sizeof v); }

// NOLINTBEGIN(bugprone-macro-parentheses): an operator stands in no parentheses
#define EAGERX_PACK_OPERATOR(op)                                                 \
  [[gnu::always_inline]] friend Pack operator op(const Pack& a, const Pack& b) { \
    return of([&](auto i) { return a.v[i] op b.v[i]; });                         \
  }                                                                              \
  [[gnu::always_inline]] Pack& operator op##=(const Pack& b) {                   \
    detail::unrolled<kCount>([&](auto i) { v[i] = v[i] op b.v[i]; });            \
    return *this;                                                                \
  }
  EAGERX_PACK_OPERATOR(+)
  EAGERX_PACK_OPERATOR(-)
  EAGERX_PACK_OPERATOR(*)
  EAGERX_PACK_OPERATOR(/)
#undef EAGERX_PACK_OPERATOR

#define EAGERX_PACK_BITS(op)                                                                     \
  [[gnu::always_inline]] friend Pack operator op(const Pack& a,                                  \
                                                 const Pack& b) requires std::is_integral_v<T> { \
    return of([&](auto i) { return a.v[i] op b.v[i]; });                                         \
  }
  EAGERX_PACK_BITS(&)
  EAGERX_PACK_BITS(|)
  EAGERX_PACK_BITS(^)
#undef EAGERX_PACK_BITS

#define EAGERX_PACK_COMPARISON(op)                                                \
  [[gnu::always_inline]] friend Truth operator op(const Pack& a, const Pack& b) { \
    return Truth::of([&](auto i) { return a.v[i] op b.v[i]; });                   \
  }
  EAGERX_PACK_COMPARISON(<)
  EAGERX_PACK_COMPARISON(<=)
  EAGERX_PACK_COMPARISON(>)
  EAGERX_PACK_COMPARISON(>=)
  EAGERX_PACK_COMPARISON(==)
  EAGERX_PACK_COMPARISON(!=)
#undef EAGERX_PACK_COMPARISON
  // NOLINTEND(bugprone-macro-parentheses)

  [[gnu::always_inline]] friend Pack operator-(const Pack& a) {
    return of([&](auto i) { return -a.v[i]; });
  }
  [[gnu::always_inline]] friend Pack operator~(const Pack& a) requires std::is_integral_v<T> {
    return of([&](auto i) { return ~a.v[i]; });
  }
  [[gnu::always_inline]] friend Pack operator<<(const Pack& a,
                                                int shift) requires std::is_integral_v<T> {
    return of([&](auto i) { return a.v[i] << static_cast<T>(shift); });
  }
  [[gnu::always_inline]] friend Pack operator>>(const Pack& a,
                                                int shift) requires std::is_integral_v<T> {
    return of([&](auto i) { return a.v[i] >> static_cast<T>(shift); });
  }
};

/// Whether each number, without what is behind its point, is an std::int32_t.
template <class S, std::size_t N>
[[gnu::always_inline]] inline bool fits_32_bits(const Pack<S, N>& x) {
  if constexpr (std::is_floating_point_v<S>) {
    const auto inside = x > Pack<S, N>(S(-0x1p31F)) & x < Pack<S, N>(S(0x1p31F));
    return !any(!inside);
  } else {
    const auto* const from = detail::lanes_of(x.v);
    S lost = 0;
    for (std::size_t i = 0; i < N; ++i)
      lost |= from[i] ^ static_cast<S>(static_cast<std::int32_t>(from[i]));
    return lost == 0;
  }
}

template <class T, std::size_t N>
struct LaneTraits<Pack<T, N>> {
  using Lane = T;
  using Bits = Pack<std::make_unsigned_t<typename detail::SignedOf<sizeof(T)>::type>, N>;
  static constexpr int kLanes = static_cast<int>(N);
};

template <std::size_t Bytes, std::size_t N>
struct LaneTraits<Mask<Bytes, N>> {
  using Lane = bool;
  static constexpr int kLanes = static_cast<int>(N);
};

/// Messages consist of packs and masks as well as of numbers.
template <class T, std::size_t N>
inline constexpr bool is_number<Pack<T, N>> = true;
template <std::size_t Bytes, std::size_t N>
inline constexpr bool is_number<Mask<Bytes, N>> = true;

/// `when_true` in the lanes where `mask` holds, `when_false` elsewhere; both are computed.
template <class T, std::size_t N>
[[gnu::always_inline]] inline Pack<T, N> select(
    const Mask<sizeof(T), N>& mask, const Pack<T, N>& when_true,
    const std::type_identity_t<Pack<T, N>>& when_false) {
  return Pack<T, N>::of([&](auto i) { return mask.v[i] ? when_true.v[i] : when_false.v[i]; });
}
/// With the truth values of numbers of another width.
template <std::size_t Bytes, class T, std::size_t N>
requires(Bytes != sizeof(T)) [[gnu::always_inline]] inline Pack<T, N> select(
    const Mask<Bytes, N>& mask, const Pack<T, N>& when_true,
    const std::type_identity_t<Pack<T, N>>& when_false) {
  return select(Mask<sizeof(T), N>(mask), when_true, when_false);
}
/// Of two masks.
template <std::size_t Bytes, std::size_t N>
[[gnu::always_inline]] inline Mask<Bytes, N> select(
    const Mask<Bytes, N>& mask, const std::type_identity_t<Mask<Bytes, N>>& when_true,
    const std::type_identity_t<Mask<Bytes, N>>& when_false) {
  return (mask & when_true) | ((!mask) & when_false);
}

/// True if the mask holds in any lane.
template <std::size_t Bytes, std::size_t N>
[[gnu::always_inline]] inline bool any(const Mask<Bytes, N>& mask) {
  using Truth = Mask<Bytes, N>;
  typename Truth::Vector all = mask.v[0];
  for (std::size_t i = 1; i < Truth::kCount; ++i) all |= mask.v[i];
  constexpr std::size_t kBytes = sizeof(all);
  using Word = std::conditional_t<kBytes % 8 == 0, std::uint64_t, std::uint8_t>;
  Word words[kBytes / sizeof(Word)];
  std::memcpy(words, &all, kBytes);
  Word either = 0;
  for (const Word word : words) either = static_cast<Word>(either | word);
  return either != 0;
}

/// The IEEE 754 bits of each number, and back.
template <class T, std::size_t N>
[[gnu::always_inline]] inline BitsOf<Pack<T, N>> bits(const Pack<T, N>& x) {
  return std::bit_cast<BitsOf<Pack<T, N>>>(x);
}
template <std::size_t N>
[[gnu::always_inline]] inline Pack<float, N> unbits(const Pack<std::uint32_t, N>& x) {
  return std::bit_cast<Pack<float, N>>(x);
}
template <std::size_t N>
[[gnu::always_inline]] inline Pack<double, N> unbits(const Pack<std::uint64_t, N>& x) {
  return std::bit_cast<Pack<double, N>>(x);
}

template <class T, std::size_t N>
[[gnu::always_inline]] inline Pack<T, N> sqrt(const Pack<T, N>& x) {
  return Pack<T, N>::of([&](auto i) {
    typename Pack<T, N>::Vector root;
    for (std::size_t k = 0; k < Pack<T, N>::kWidth; ++k) root[k] = sqrt(x.v[i][k]);
    return root;
  });
}

/// Lane `i`: 0 <= i < N.
template <class T, std::size_t N>
[[gnu::always_inline]] inline T lane(const Pack<T, N>& x, int i) {
  T value;
  std::memcpy(&value, reinterpret_cast<const char*>(&x) + static_cast<std::size_t>(i) * sizeof(T),
              sizeof value);
  return value;
}
template <std::size_t Bytes, std::size_t N>
[[gnu::always_inline]] inline bool lane(const Mask<Bytes, N>& mask, int i) {
  typename Mask<Bytes, N>::Lane value;
  std::memcpy(&value, reinterpret_cast<const char*>(&mask) + static_cast<std::size_t>(i) * Bytes,
              sizeof value);
  return value != 0;
}
template <class T, std::size_t N>
[[gnu::always_inline]] inline void set_lane(Pack<T, N>& x, int i, std::type_identity_t<T> value) {
  std::memcpy(reinterpret_cast<char*>(&x) + static_cast<std::size_t>(i) * sizeof(T), &value,
              sizeof value);
}
template <std::size_t Bytes, std::size_t N>
[[gnu::always_inline]] inline void set_lane(Mask<Bytes, N>& mask, int i, bool value) {
  using Lane = typename Mask<Bytes, N>::Lane;
  const auto all = static_cast<Lane>(-static_cast<int>(value));
  std::memcpy(reinterpret_cast<char*>(&mask) + static_cast<std::size_t>(i) * Bytes, &all,
              sizeof all);
}

}  // namespace eagerx
