// The registers for the policy of a single environment.
#pragma once

#include <cstddef>
#include <cstring>
#include <eagerx/simd.hpp>

namespace eagerx::policy {

/// Floats in a register.
#if defined(__AVX__)
inline constexpr std::size_t kLanes = 8;
#else
inline constexpr std::size_t kLanes = 4;
#endif

template <std::size_t Lanes>
using FloatVector = typename detail::VectorOf<float, Lanes>::type;
/// `Count` registers of `Width` floats each.
template <std::size_t Width, std::size_t Count>
using FloatLanes = Simd<float, Width * Count, Width>;

template <class Vector>
[[gnu::always_inline]] inline Vector load(const float* from) {
  Vector v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Keeps operations on `v` in the order of the source: otherwise compilers finish one sum before
/// they begin the next, and wait for each addition.
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

}  // namespace eagerx::policy
