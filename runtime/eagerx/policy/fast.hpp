// Profile fast: layers whose bits differ from machine to machine, for the sake of speed.
//
// On x86 with AVX and FMA products and sums are fused, each output is one chain (a single output:
// lanes of them), and tanh is fused as well. Errors stay those of float32: they are no larger than
// in the exact profile, but not the same. On other machines these are the exact layers.
#pragma once

#include <cstddef>
#include <eagerx/policy.hpp>

#if defined(__AVX__) && defined(__FMA__)

#include <cstring>
#include <eagerx/policy/panel_lanes.hpp>

namespace eagerx::policy {

/// a b + c, rounded once.
[[gnu::always_inline]] inline FloatVector<8> fused(FloatVector<8> a, FloatVector<8> b,
                                                   FloatVector<8> c) {
  return __builtin_ia32_vfmaddps256(a, b, c);
}
[[gnu::always_inline]] inline FloatVector<8> all_lanes(float x) {
  return x - FloatVector<8>{};
}

/// tanh of eight numbers; 3 ulp. As eagerx::tanh, but fused.
[[gnu::always_inline]] inline FloatVector<8> fused_tanh(FloatVector<8> x) {
  using Vector = FloatVector<8>;
  using Bits = typename VectorOf<std::uint32_t, 8>::type;
  using Exponential = detail::ExponentialConstants<float>;
  constexpr std::uint32_t kSign = 0x80000000U;
  const Vector rounder = all_lanes(FloatFormat<float>::kRounder);
  const auto magnitude = std::bit_cast<Vector>(std::bit_cast<Bits>(x) & ~kSign);
  // As minps has it: NaN stays NaN.
  const Vector most = all_lanes(detail::HyperbolicConstants<float>::kTanhIsOne);
  const Vector a = __builtin_ia32_minps256(most, magnitude);
  const Vector twice = a + a;
  const Vector shifted = fused(twice, all_lanes(Exponential::kLog2E), rounder);
  const Vector n = shifted - rounder;
  Vector r = fused(n, all_lanes(-Exponential::kLn2High), twice);
  r = fused(n, all_lanes(-Exponential::kLn2Low), r);
  Vector sum = all_lanes(Exponential::kExpm1[0]);
#pragma GCC unroll 8
  for (std::size_t k = 1; k < Exponential::kExpm1.size(); ++k) {
    sum = fused(sum, r, all_lanes(Exponential::kExpm1[k]));
  }
  const Vector expm1 = fused(r * r, sum, r);
  const auto scale = std::bit_cast<Vector>((std::bit_cast<Bits>(shifted) + 127U) << 23U);
  const Vector e = fused(scale, expm1, scale - 1.0F);
  const Vector result = e / (e + 2.0F);
  return std::bit_cast<Vector>(std::bit_cast<Bits>(result) | (std::bit_cast<Bits>(x) & kSign));
}

/// y = A(y) in place.
template <Activation A, std::size_t Out>
inline void fast_activate(float* y, float slope) {
  if constexpr (A == Activation::tanh) {
    constexpr std::size_t kWhole = Out - Out % 8;
    for (std::size_t k = 0; k < kWhole; k += 8) {
      const FloatVector<8> result = fused_tanh(load<FloatVector<8>>(y + k));
      std::memcpy(y + k, &result, sizeof result);
    }
    if constexpr (kWhole < Out) {
      FloatVector<8> rest = {};
#pragma GCC unroll 8
      for (std::size_t k = kWhole; k < Out; ++k) rest[k - kWhole] = y[k];
      rest = fused_tanh(rest);
#pragma GCC unroll 8
      for (std::size_t k = kWhole; k < Out; ++k) y[k] = rest[k - kWhole];
    }
  } else {
    activate_all<A, Out>(y, slope);
  }
}

/// `Panels` panels eight wide at a time: w [Panels][In][8].
template <std::size_t In, std::size_t Panels>
[[gnu::always_inline]] inline void fused_panels(const float* w, const float* b, const float* x,
                                                float* y) {
  using Vector = FloatVector<kPanel>;
  Vector sum[Panels];
#pragma GCC unroll 8
  for (std::size_t v = 0; v < Panels; ++v) sum[v] = load<Vector>(b + v * kPanel);
#pragma GCC unroll 4
  for (std::size_t j = 0; j < In; ++j) {
    const Vector input = all_lanes(x[j]);
#pragma GCC unroll 8
    for (std::size_t v = 0; v < Panels; ++v) {
      sum[v] = fused(load<Vector>(w + (v * In + j) * kPanel), input, sum[v]);
    }
  }
#pragma GCC unroll 8
  for (std::size_t v = 0; v < Panels; ++v) std::memcpy(y + v * kPanel, &sum[v], sizeof sum[v]);
}

/// The one output of a layer: four times eight sums.
template <std::size_t In>
[[gnu::always_inline]] inline float fused_output(const float* w, const float* x, float b) {
  using Vector = FloatVector<8>;
  Vector sum[4] = {};
  std::size_t j = 0;
  for (; j + 32 <= In; j += 32) {
#pragma GCC unroll 4
    for (std::size_t k = 0; k < 4; ++k) {
      sum[k] = fused(load<Vector>(w + j + 8 * k), load<Vector>(x + j + 8 * k), sum[k]);
    }
  }
  for (; j + 8 <= In; j += 8) sum[0] = fused(load<Vector>(w + j), load<Vector>(x + j), sum[0]);
  const Vector all = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  const float first = (all[0] + all[4]) + (all[1] + all[5]);
  float result = (first + ((all[2] + all[6]) + (all[3] + all[7]))) + b;
  for (; j < In; ++j) result += w[j] * x[j];
  return result;
}

}  // namespace eagerx::policy

namespace eagerx {

/// y = A(W x + b); `x` [In] and `y` [Out] must not overlap.
template <Activation A, std::size_t In, std::size_t Out>
inline void fast_dense(const DenseWeights<In, Out>& layer, const float (&x)[In], float (&y)[Out],
                       float slope = 0.0F) {
  using Weights = DenseWeights<In, Out>;
  constexpr std::size_t kPanel = Weights::kPanel;
  constexpr std::size_t kAtATime = policy::kRegistersAtATime;
  constexpr std::size_t kRest = Weights::kFullPanels % kAtATime;
  constexpr std::size_t kFull = Weights::kFullPanels * kPanel;
  for (std::size_t k = 0; k < kFull - kRest * kPanel; k += kAtATime * kPanel) {
    policy::fused_panels<In, kAtATime>(layer.w + k * In, layer.b + k, x, y + k);
  }
  if constexpr (kRest > 0) {
    constexpr std::size_t k = kFull - kRest * kPanel;
    policy::fused_panels<In, kRest>(layer.w + k * In, layer.b + k, x, y + k);
  }
  if constexpr (Weights::kTail == 1) {
    y[kFull] = policy::fused_output<In>(layer.w + kFull * In, x, layer.b[kFull]);
  } else if constexpr (Weights::kTail > 0) {
    float tail[Weights::kTail];
    policy::tail_panel<In, Weights::kTail>(layer.w + kFull * In, layer.b + kFull, x, tail);
    for (std::size_t k = kFull; k < Out; ++k) y[k] = tail[k - kFull];
  }
  policy::fast_activate<A, Out>(y, slope);
}

}  // namespace eagerx

#else

namespace eagerx {

/// y = A(W x + b), as eagerx::dense().
template <Activation A, std::size_t In, std::size_t Out>
inline void fast_dense(const DenseWeights<In, Out>& layer, const float (&x)[In], float (&y)[Out],
                       float slope = 0.0F) {
  dense<A>(layer, x, y, slope);
}

}  // namespace eagerx

#endif
