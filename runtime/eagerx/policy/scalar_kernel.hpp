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

/// Adds `sums` in halves.
inline float sum_of_chains(float (&sums)[kChains]) {
  for (std::size_t half = kChains / 2; half > 0; half /= 2) {
    for (std::size_t k = 0; k < half; ++k) sums[k] = sums[k] + sums[k + half];
  }
  return sums[0];
}

/// The products of the last `In` % kChains inputs, then zeros.
template <std::size_t In>
inline void last_products(const float* w, const float* x, float (&products)[kChains]) {
  constexpr std::size_t kRest = In % kChains;
  for (std::size_t k = 0; k < kChains; ++k) {
    products[k] = k < kRest ? w[In - kRest + k] * x[In - kRest + k] : 0.0F;
  }
}

/// The one output of a panel.
template <std::size_t In>
inline float plain_output(const float* w, float b, const float* x) {
  float sums[kChains];
  if constexpr (In < kChains) {
    last_products<In>(w, x, sums);
  } else {
    for (std::size_t k = 0; k < kChains; ++k) sums[k] = w[k] * x[k];
    for (std::size_t j = kChains; j + kChains <= In; j += kChains) {
      for (std::size_t k = 0; k < kChains; ++k) sums[k] = sums[k] + w[j + k] * x[j + k];
    }
    if constexpr (In % kChains > 0) {
      float last[kChains];
      last_products<In>(w, x, last);
      for (std::size_t k = 0; k < kChains; ++k) sums[k] = sums[k] + last[k];
    }
  }
  return b + sum_of_chains(sums);
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
