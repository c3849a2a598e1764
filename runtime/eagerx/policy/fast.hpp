// Profile fast: layers whose bits differ from machine to machine, for the sake of speed.
//
// On x86 with AVX and FMA products and sums are fused, an output is one chain (1, 2, 4 or 8 if few
// outputs are side by side, as in layers beyond the first cache), and tanh is fused as well;
// outputs that do not fill a panel are those of the exact profile. Errors stay those of float32,
// but a long chain rounds more than groups: with 8 inputs they are 0.9 times those of the exact
// profile, with 64 1.7 times, with 128 2.1 times, beyond the first cache 1.3 times (root mean
// square, normal numbers). On other machines these are the exact layers.
#pragma once

#include <bit>
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
template <std::size_t N>
[[gnu::always_inline]] inline Simd<float, N, 8> fused(const Simd<float, N, 8>& a,
                                                      const Simd<float, N, 8>& b,
                                                      const Simd<float, N, 8>& c) {
  return Simd<float, N, 8>::of([&](auto i) { return fused(a.v[i], b.v[i], c.v[i]); });
}

/// As eagerx::tanh, but fused. Largest error 3 ulp.
template <std::size_t N>
[[gnu::always_inline]] inline Simd<float, N, 8> fused_tanh(const Simd<float, N, 8>& x) {
  using Lanes = Simd<float, N, 8>;
  using Exponential = detail::ExponentialConstants<float>;
  const Lanes rounder(detail::kPowerRounder);
  const Lanes a = min(eagerx::abs(x), Lanes(detail::HyperbolicConstants<float>::kTanhIsOne));
  const Lanes shifted = fused(a, Lanes(2.0F * Exponential::kLog2E), rounder);
  const Lanes n = shifted - rounder;
  const Lanes s = fused(n, Lanes(-detail::kHalfLn2), a);
  const Lanes power = unbits(bits(shifted) << FloatFormat<float>::kMantissaBits);  // 2^n
  const Lanes square = s * s;
  const auto& c = detail::kTanhNearZero;
  const Lanes t = fused(square * s, fused(square, Lanes(c[1]), Lanes(c[0])), s);
  const Lanes less = power - Lanes(1.0F);
  const Lanes more = power + Lanes(1.0F);
  return eagerx::copysign(fused(more, t, less) / fused(less, t, more), x);
}

/// A(x) for activations without a slope.
template <Activation A, std::size_t N>
[[gnu::always_inline]] inline Simd<float, N, 8> fast_activated(const Simd<float, N, 8>& x) {
  if constexpr (A == Activation::tanh) {
    return fused_tanh(x);
  } else {
    return activated<A>(x, 0.0F);
  }
}

/// Number of chains for each output, so that `panels` panels together hide the latency of the
/// additions. Chain c takes the inputs c, c + chains, …; few inputs are one chain.
constexpr std::size_t chains_of_panel(std::size_t inputs, std::size_t panels) {
  constexpr std::size_t kFew = 32;
  return inputs < kFew ? 1 : std::bit_floor(kRegistersAtATime / panels);
}

/// Adds the products of input `j`.
template <std::size_t In, std::size_t N>
[[gnu::always_inline]] inline void add_input(const float* w, const float* x, std::size_t j,
                                             Simd<float, N, kPanel>& sum) {
  using Vector = FloatVector<kPanel>;
  const Vector input = x[j] - Vector{};
#pragma GCC unroll 8
  for (std::size_t v = 0; v < N / kPanel; ++v) {
    sum.v[v] = fused(load<Vector>(w + (v * In + j) * kPanel), input, sum.v[v]);
  }
}

/// y = A(sums): `Panels` panels eight wide at a time, w [Panels][In][8].
template <Activation A, std::size_t In, std::size_t Panels>
[[gnu::always_inline]] inline void fused_panels(const float* w, const float* b, const float* x,
                                                float* y) {
  constexpr std::size_t kChains = chains_of_panel(In, Panels);
  constexpr std::size_t kWhole = In - In % kChains;
  using Sums = FloatLanes<kPanel, Panels>;
  Sums chain[kChains];
  chain[0] = Sums::load(b);
#pragma GCC unroll 8
  for (std::size_t c = 1; c < kChains; ++c) chain[c] = Sums(0.0F);
#pragma GCC unroll 4
  for (std::size_t j = 0; j < kWhole; j += kChains) {
#pragma GCC unroll 8
    for (std::size_t c = 0; c < kChains; ++c) add_input<In>(w, x, j + c, chain[c]);
  }
#pragma GCC unroll 8
  for (std::size_t j = kWhole; j < In; ++j) add_input<In>(w, x, j, chain[j - kWhole]);
#pragma GCC unroll 4
  for (std::size_t half = kChains / 2; half > 0; half /= 2) {
#pragma GCC unroll 4
    for (std::size_t c = 0; c < half; ++c) chain[c] = chain[c] + chain[c + half];
  }
  const Sums& sum = chain[0];
  constexpr std::size_t kAtATime = std::min(Panels, kActivatedAtATime);
  detail::unrolled<Panels / kAtATime>([&](auto batch) {
    const std::size_t first = batch * kAtATime;
    using Batch = FloatLanes<kPanel, kAtATime>;
    fast_activated<A>(Batch::of([&](auto v) {
      return sum.v[first + v];
    })).store(y + first * kPanel);
  });
  constexpr std::size_t kRest = Panels % kAtATime;
  if constexpr (kRest > 0) {
    constexpr std::size_t kFirst = Panels - kRest;
    using Batch = FloatLanes<kPanel, kRest>;
    fast_activated<A>(Batch::of([&](auto v) {
      return sum.v[kFirst + v];
    })).store(y + kFirst * kPanel);
  }
}

/// All whole panels of a layer.
template <Activation A, std::size_t In, std::size_t Panels>
[[gnu::always_inline]] inline void fused_panels_of_layer(const float* w, const float* b,
                                                         const float* x, float* y) {
  constexpr std::size_t kAtATime =
      kFitsCache<In, Panels> ? kRegistersAtATime : kRegistersBeyondCache;
  constexpr std::size_t kRest = Panels % kAtATime;
  constexpr std::size_t kDone = (Panels - kRest) * kPanel;
  for (std::size_t k = 0; k < kDone; k += kAtATime * kPanel) {
    fused_panels<A, In, kAtATime>(w + k * In, b + k, x, y + k);
  }
  if constexpr (kRest > 0) {
    fused_panels<A, In, kRest>(w + kDone * In, b + kDone, x, y + kDone);
  }
}

/// y = A(y) for less than a panel.
template <Activation A, std::size_t Out>
inline void fast_activate_tail(float* y, float slope) {
  if constexpr (A == Activation::tanh) {
    FloatLanes<8, 1> rest = {};
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Out; ++k) rest.v[0][k] = y[k];
    rest = fused_tanh(rest);
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Out; ++k) y[k] = rest.v[0][k];
  } else if constexpr (A != Activation::identity) {
    activate_all<A, Out>(y, slope);
  }
}

}  // namespace eagerx::policy

namespace eagerx {

/// y = A(W x + b); `x` [In] and `y` [Out] must not overlap.
template <Activation A, std::size_t In, std::size_t Out>
[[gnu::always_inline]] inline void fast_dense(const DenseWeights<In, Out>& layer,
                                              const float (&x)[In], float (&y)[Out],
                                              float slope = 0.0F) {
  using Weights = DenseWeights<In, Out>;
  constexpr std::size_t kFull = Weights::kFullPanels * Weights::kPanel;
  if constexpr (A == Activation::relu || A == Activation::tanh) {
    policy::fused_panels_of_layer<A, In, Weights::kFullPanels>(layer.w, layer.b, x, y);
  } else {
    constexpr Activation kNone = Activation::identity;
    policy::fused_panels_of_layer<kNone, In, Weights::kFullPanels>(layer.w, layer.b, x, y);
    if constexpr (kFull > 0) policy::activate_all<A, kFull>(y, slope);
  }
  if constexpr (Weights::kTail > 0) {
    float tail[Weights::kTail];
    policy::tail_panel<In, Weights::kTail>(layer.w + kFull * In, layer.b + kFull, x, tail);
    policy::fast_activate_tail<A, Out - kFull>(tail, slope);
    for (std::size_t k = kFull; k < Out; ++k) y[k] = tail[k - kFull];
  }
}

}  // namespace eagerx

#else

namespace eagerx {

/// y = A(W x + b), as eagerx::dense().
template <Activation A, std::size_t In, std::size_t Out>
[[gnu::always_inline]] inline void fast_dense(const DenseWeights<In, Out>& layer,
                                              const float (&x)[In], float (&y)[Out],
                                              float slope = 0.0F) {
  dense<A>(layer, x, y, slope);
}

}  // namespace eagerx

#endif
