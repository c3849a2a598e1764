// A panel as plain loops over a handful of sums.
#pragma once

#include <cstddef>
#include <eagerx/policy/activation.hpp>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::policy {

/// Adds the products of `Rows` inputs to `sum`. w [Rows][Width], x [Rows].
template <std::size_t Width, std::size_t Rows>
inline void add_group(const float* w, const float* x, float (&sum)[Width]) {
  float part[Width];
#pragma GCC unroll 8
  for (std::size_t k = 0; k < Width; ++k) part[k] = w[k] * x[0];
  for (std::size_t j = 1; j < Rows; ++j) {
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Width; ++k) part[k] = part[k] + w[j * Width + k] * x[j];
  }
#pragma GCC unroll 8
  for (std::size_t k = 0; k < Width; ++k) sum[k] = sum[k] + part[k];
}

/// One panel: w [In][Width], b and y [Width], x [In].
template <std::size_t In, std::size_t Width>
inline void plain_panel(const float* w, const float* b, const float* x, float* y) {
  constexpr std::size_t kRest = In % kGroup;
  float sum[Width];
  for (std::size_t k = 0; k < Width; ++k) sum[k] = b[k];
  for (std::size_t j = 0; j + kGroup <= In; j += kGroup) {
    add_group<Width, kGroup>(w + j * Width, x + j, sum);
  }
  if constexpr (kRest > 0) {
    add_group<Width, kRest>(w + (In - kRest) * Width, x + (In - kRest), sum);
  }
  for (std::size_t k = 0; k < Width; ++k) y[k] = sum[k];
}

}  // namespace eagerx::policy
