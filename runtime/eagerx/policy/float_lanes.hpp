// As many floats as fit into a register, with the words that eagerx/math.hpp is written in (GCC and
// Clang vector extensions).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math.hpp>

namespace eagerx::policy {

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

/// A mask of lanes: all bits set where true.
struct MaskLanes {
  VectorOf<std::int32_t, kLanes>::type v;
};

/// kLanes unsigned integers.
struct BitLanes {
  using Vector = VectorOf<std::uint32_t, kLanes>::type;
  Vector v;
  BitLanes() = default;
  [[gnu::always_inline]] explicit BitLanes(Vector vector) : v(vector) {}
  [[gnu::always_inline]] explicit BitLanes(std::uint32_t x) : v(x - Vector{}) {}
  [[gnu::always_inline]] friend BitLanes operator+(BitLanes a, BitLanes b) {
    return BitLanes(a.v + b.v);
  }
  [[gnu::always_inline]] friend BitLanes operator-(BitLanes a, BitLanes b) {
    return BitLanes(a.v - b.v);
  }
  [[gnu::always_inline]] friend BitLanes operator&(BitLanes a, BitLanes b) {
    return BitLanes(a.v & b.v);
  }
  [[gnu::always_inline]] friend BitLanes operator|(BitLanes a, BitLanes b) {
    return BitLanes(a.v | b.v);
  }
  [[gnu::always_inline]] friend BitLanes operator<<(BitLanes a, int shift) {
    return BitLanes(a.v << static_cast<std::uint32_t>(shift));
  }
  [[gnu::always_inline]] friend BitLanes operator>>(BitLanes a, int shift) {
    return BitLanes(a.v >> static_cast<std::uint32_t>(shift));
  }
};

/// kLanes floats.
struct FloatLanes {
  using Vector = FloatVector<kLanes>;
  Vector v;
  FloatLanes() = default;
  [[gnu::always_inline]] explicit FloatLanes(Vector vector) : v(vector) {}
  // x - 0 is x for every x; x + 0 would lose the sign of -0.
  [[gnu::always_inline]] explicit FloatLanes(float x) : v(x - Vector{}) {}
  [[gnu::always_inline]] friend FloatLanes operator+(FloatLanes a, FloatLanes b) {
    return FloatLanes(a.v + b.v);
  }
  [[gnu::always_inline]] friend FloatLanes operator-(FloatLanes a, FloatLanes b) {
    return FloatLanes(a.v - b.v);
  }
  [[gnu::always_inline]] friend FloatLanes operator-(FloatLanes a) { return FloatLanes(-a.v); }
  [[gnu::always_inline]] friend FloatLanes operator*(FloatLanes a, FloatLanes b) {
    return FloatLanes(a.v * b.v);
  }
  [[gnu::always_inline]] friend FloatLanes operator/(FloatLanes a, FloatLanes b) {
    return FloatLanes(a.v / b.v);
  }
  [[gnu::always_inline]] friend MaskLanes operator<(FloatLanes a, FloatLanes b) {
    return {a.v < b.v};
  }
  [[gnu::always_inline]] friend MaskLanes operator>=(FloatLanes a, FloatLanes b) {
    return {a.v >= b.v};
  }
  [[gnu::always_inline]] friend MaskLanes operator==(FloatLanes a, FloatLanes b) {
    return {a.v == b.v};
  }
};

[[gnu::always_inline]] inline FloatLanes select(MaskLanes mask, FloatLanes when_true,
                                                FloatLanes when_false) {
  return FloatLanes(mask.v ? when_true.v : when_false.v);
}
[[gnu::always_inline]] inline BitLanes bits(FloatLanes x) {
  return BitLanes(std::bit_cast<BitLanes::Vector>(x.v));
}
[[gnu::always_inline]] inline FloatLanes unbits(BitLanes x) {
  return FloatLanes(std::bit_cast<FloatLanes::Vector>(x.v));
}

}  // namespace eagerx::policy

namespace eagerx {
template <>
struct LaneTraits<policy::FloatLanes> {
  using Lane = float;
  using Bits = policy::BitLanes;
  static constexpr int kLanes = static_cast<int>(policy::kLanes);
};
}  // namespace eagerx
