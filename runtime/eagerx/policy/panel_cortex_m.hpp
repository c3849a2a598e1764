// Panels on Cortex-M with a floating-point unit: eight sums and the eight sums of a group stay in
// registers, and one instruction loads the eight weights of an input. Products and sums are
// separate instructions: exact, and on a Cortex-M4 faster than `vmla`, which takes three cycles.
#pragma once

#include <cstddef>
#include <eagerx/policy/scalar_kernel.hpp>

namespace eagerx::policy {

/// Eight floats that the compiler keeps in registers.
struct Registers {
  float v0, v1, v2, v3, v4, v5, v6, v7;
};

[[gnu::always_inline]] inline Registers load(const float* from) {
  return {from[0], from[1], from[2], from[3], from[4], from[5], from[6], from[7]};
}

[[gnu::always_inline]] inline Registers operator+(const Registers& a, const Registers& b) {
  return {a.v0 + b.v0, a.v1 + b.v1, a.v2 + b.v2, a.v3 + b.v3,
          a.v4 + b.v4, a.v5 + b.v5, a.v6 + b.v6, a.v7 + b.v7};
}

/// Eight weights times `x`; moves `w` to the next eight.
[[gnu::always_inline]] inline Registers row_times(const float*& w, float x) {
  // `vldmia` fills registers that follow one another, which only fixed ones do.
  register float w0 asm("s16");
  register float w1 asm("s17");
  register float w2 asm("s18");
  register float w3 asm("s19");
  register float w4 asm("s20");
  register float w5 asm("s21");
  register float w6 asm("s22");
  register float w7 asm("s23");
  asm("vldmia.32 %0!, {s16-s23}"
      : "+r"(w), "=t"(w0), "=t"(w1), "=t"(w2), "=t"(w3), "=t"(w4), "=t"(w5), "=t"(w6), "=t"(w7)
      : "m"(*reinterpret_cast<const float(*)[kPanel]>(w)));
  return {w0 * x, w1 * x, w2 * x, w3 * x, w4 * x, w5 * x, w6 * x, w7 * x};
}

/// One panel. Not inlined, so that all layers of a program share its code.
[[gnu::noinline]] inline void full_panel(const float* w, const float* b, const float* x, float* y,
                                         std::size_t inputs) {
  Registers sum = load(b);
  const float* const end = x + inputs;
  while (end - x >= static_cast<std::ptrdiff_t>(kGroup)) {
    Registers part = row_times(w, *x++);
#pragma GCC unroll 7
    for (std::size_t j = 1; j < kGroup; ++j) part = part + row_times(w, *x++);
    sum = sum + part;
  }
  if (x != end) {
    Registers part = row_times(w, *x++);
    while (x != end) part = part + row_times(w, *x++);
    sum = sum + part;
  }
  y[0] = sum.v0, y[1] = sum.v1, y[2] = sum.v2, y[3] = sum.v3;
  y[4] = sum.v4, y[5] = sum.v5, y[6] = sum.v6, y[7] = sum.v7;
}

template <std::size_t In, std::size_t Panels>
inline void full_panels(const float* w, const float* b, const float* x, float* y) {
  for (std::size_t k = 0; k < Panels * kPanel; k += kPanel) {
    full_panel(w + k * In, b + k, x, y + k, In);
  }
}

}  // namespace eagerx::policy
