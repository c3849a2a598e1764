// Panels on machines without lanes.
#pragma once

#include <cstddef>
#include <eagerx/policy/scalar_kernel.hpp>

namespace eagerx::policy {

template <std::size_t In, std::size_t Panels>
inline void full_panels(const float* w, const float* b, const float* x, float* y) {
  for (std::size_t k = 0; k < Panels * kPanel; k += kPanel) {
    tail_panel<In, kPanel>(w + k * In, b + k, x, y + k);
  }
}

}  // namespace eagerx::policy
