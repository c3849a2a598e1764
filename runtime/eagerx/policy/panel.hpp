// Panels of outputs: sums that run over the inputs side by side. Three ways to the same bits:
// vector lanes where the machine has exact ones, Cortex-M registers, plain loops. Each provides,
// for w [Panels][In][width], b and y [Panels * width] and x [In]:
//   full_panels<A, In, Panels>(w, b, x, y, slope)    y = A(panels), eight wide
//   tail_panel<In, Width>(w, b, x, y)                one panel 1, 2, 4 or 8 wide
//   activate_all<A, Out>(y, slope)                   y = A(y)
#pragma once

// 32-bit NEON flushes denormals to zero, so it does not count as exact.
#if defined(__SSE2__) || defined(__aarch64__) || defined(__wasm_simd128__)
#include <eagerx/policy/panel_lanes.hpp>
#elif defined(__thumb2__) && defined(__ARM_FP) && __ARM_ARCH_PROFILE == 'M' && defined(__GNUC__)
#include <eagerx/policy/panel_cortex_m.hpp>
#else
#include <eagerx/policy/panel_scalar.hpp>
#endif

namespace eagerx::policy {

/// The sum of `y` in groups of kGroup, each summed from its first number.
template <class R, std::size_t N>
constexpr R grouped_sum(const R (&y)[N]) {
  R sum(0.0F);
  for (std::size_t first = 0; first < N; first += kGroup) {
    R part = y[first];
    for (std::size_t k = first + 1; k < N && k < first + kGroup; ++k) part = part + y[k];
    sum = sum + part;
  }
  return sum;
}

}  // namespace eagerx::policy
