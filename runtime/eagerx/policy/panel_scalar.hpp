// Panels on machines without lanes.
#pragma once

#include <cstddef>
#include <eagerx/policy/scalar_kernel.hpp>

namespace eagerx::policy {

template <std::size_t In, std::size_t Width>
inline void tail_panel(const float* w, const float* b, const float* x, float* y) {
  if constexpr (Width == 1) {
    y[0] = plain_output<In>(w, b[0], x);
  } else {
    plain_panel<In, Width>(w, b, x, y);
  }
}

template <Activation A, std::size_t Out>
inline void activate_all(float* y, float slope) {
  for (std::size_t k = 0; k < Out; ++k) y[k] = activated<A>(y[k], slope);
}

template <Activation A, std::size_t In, std::size_t Panels>
inline void full_panels(const float* w, const float* b, const float* x, float* y, float slope) {
  for (std::size_t k = 0; k < Panels * kPanel; k += kPanel) {
    plain_panel<In, kPanel>(w + k * In, b + k, x, y + k);
  }
  if constexpr (Panels > 0) activate_all<A, Panels * kPanel>(y, slope);
}

}  // namespace eagerx::policy
