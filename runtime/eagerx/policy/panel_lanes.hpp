// Panels on SIMD machines: one output a lane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <eagerx/policy/activation.hpp>
#include <eagerx/policy/float_lanes.hpp>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::policy {

/// Registers of sums at a time. With the sums of a group they leave room for weights: in 16
/// registers four, in 32 eight, which hide the latency of the additions.
#if defined(__AVX512VL__) || defined(__aarch64__)
inline constexpr std::size_t kRegistersAtATime = 8;
#else
inline constexpr std::size_t kRegistersAtATime = 4;
#endif

/// `Panels` panels of `Width` outputs at a time.
template <std::size_t In, std::size_t Width, std::size_t Panels>
class PanelBlock {
 public:
  static void run(const float* w, const float* b, const float* x, float* y) {
    Vector sum[kVectors];
    std::memcpy(sum, b, sizeof sum);
    for (std::size_t j = 0; j + kGroup <= In; j += kGroup) add_group<kGroup>(w, x, j, sum);
    if constexpr (In % kGroup > 0) add_group<In % kGroup>(w, x, In - In % kGroup, sum);
    std::memcpy(y, sum, sizeof sum);
  }

 private:
  static constexpr std::size_t kWidth = std::min(Width, kLanes);
  static constexpr std::size_t kPerPanel = Width / kWidth;
  static constexpr std::size_t kVectors = Panels * kPerPanel;
  using Vector = FloatVector<kWidth>;

  /// Weights of input `j` in vector `v`.
  [[gnu::always_inline]] static Vector row(const float* w, std::size_t j, std::size_t v) {
    return load<Vector>(w + ((v / kPerPanel) * In + j) * Width + (v % kPerPanel) * kWidth);
  }

  /// Adds the products of the inputs `first`, …, `first + Rows - 1` to `sum`.
  template <std::size_t Rows>
  [[gnu::always_inline]] static void add_group(const float* w, const float* x, std::size_t first,
                                               Vector (&sum)[kVectors]) {
    Vector part[kVectors];
#pragma GCC unroll 8
    for (std::size_t v = 0; v < kVectors; ++v) part[v] = row(w, first, v) * x[first];
#pragma GCC unroll 8
    for (std::size_t j = 1; j < Rows; ++j) {
#pragma GCC unroll 8
      for (std::size_t v = 0; v < kVectors; ++v) {
        part[v] = part[v] + row(w, first + j, v) * x[first + j];
      }
    }
#pragma GCC unroll 8
    for (std::size_t v = 0; v < kVectors; ++v) sum[v] = sum[v] + part[v];
  }
};

template <std::size_t In, std::size_t Width>
inline void tail_panel(const float* w, const float* b, const float* x, float* y) {
  PanelBlock<In, Width, 1>::run(w, b, x, y);
}

template <std::size_t In, std::size_t Panels>
inline void full_panels(const float* w, const float* b, const float* x, float* y) {
  constexpr std::size_t kAtATime = kRegistersAtATime * kLanes / kPanel;
  constexpr std::size_t kRest = Panels % kAtATime;
  constexpr std::size_t kOutputs = kAtATime * kPanel;
  for (std::size_t block = 0; block < Panels / kAtATime; ++block) {
    const std::size_t k = block * kOutputs;
    PanelBlock<In, kPanel, kAtATime>::run(w + k * In, b + k, x, y + k);
  }
  constexpr std::size_t kDone = (Panels - kRest) * kPanel;
  if constexpr (kRest > 0) {
    PanelBlock<In, kPanel, kRest>::run(w + kDone * In, b + kDone, x, y + kDone);
  }
}

template <Activation A, std::size_t Out>
inline void activate_all(float (&y)[Out], float slope) {
  constexpr std::size_t kWhole = Out - Out % kLanes;
  for (std::size_t k = 0; k < kWhole; k += kLanes) {
    const FloatLanes x(load<FloatLanes::Vector>(y + k));
    const FloatLanes result = activated<A>(x, slope);
    std::memcpy(y + k, &result.v, sizeof result.v);
  }
  for (std::size_t k = kWhole; k < Out; ++k) y[k] = activated<A>(y[k], slope);
}

}  // namespace eagerx::policy
