// Layers of trained networks over SIMD vectors: one lane is one environment, with the bits of
// eagerx/policy.hpp. A lane's sums go in that order; lanes do not mix.
#pragma once

#include <cstddef>
#include <eagerx/policy.hpp>
#include <eagerx/policy/lane_sums.hpp>
#include <eagerx/simd.hpp>
#include <type_traits>

namespace eagerx {
namespace policy {

template <std::size_t In, std::size_t Width>
using PanelWeights =
    LaneWeights<std::integral_constant<std::size_t, In>, std::integral_constant<std::size_t, Width>,
                std::integral_constant<std::size_t, 1>>;

/// Numbers of all lanes of a SIMD vector, in memory.
template <class Real>
const float* numbers_of(const Real* x) {
  return reinterpret_cast<const float*>(x);  // NOLINT: for memcpy only
}
template <class Real>
float* numbers_of(Real* x) {
  return reinterpret_cast<float*>(x);  // NOLINT: for memcpy only
}

/// Some outputs of one panel. w: the first one's weights, [In][Width].
template <std::size_t In, std::size_t Width, std::size_t Outputs, class Real>
void lane_outputs(const float* w, const float* b, const Real* x, Real* y) {
  LaneOutputs<Outputs, Real>::run(PanelWeights<In, Width>{w, {}, {}, {}}, b, numbers_of(x),
                                  numbers_of(y));
}

template <std::size_t In, std::size_t Width, std::size_t Outputs, class Real>
void lane_panel(const float* w, const float* b, const Real* x, Real* y) {
  if constexpr (Width == 1) {
    y[0] = LaneOutputAlone<Real>::run(std::integral_constant<std::size_t, In>(), w, b[0],
                                      numbers_of(x));
  } else {
    constexpr std::size_t kRest = Outputs % kOutputsAtATime;
    constexpr std::size_t kDone = Outputs - kRest;
    for (std::size_t k = 0; k < kDone; k += kOutputsAtATime)
      lane_outputs<In, Width, kOutputsAtATime>(w + k, b + k, x, y + k);
    if constexpr (kRest > 0) lane_outputs<In, Width, kRest>(w + kDone, b + kDone, x, y + kDone);
  }
}

}  // namespace policy

/// y = A(y).
template <Activation A, class T, std::size_t Lanes, std::size_t N>
inline void activate(Simd<T, Lanes> (&y)[N], float slope = 0.0F) {
  if constexpr (A != Activation::identity) {
    for (Simd<T, Lanes>& x : y) x = policy::activated<A>(x, slope);
  }
}

/// y = A(W x + b); `x` and `y` must not overlap.
template <Activation A, std::size_t In, std::size_t Out, std::size_t Lanes>
inline void dense(const DenseWeights<In, Out>& layer, const Simd<float, Lanes> (&x)[In],
                  Simd<float, Lanes> (&y)[Out], float slope = 0.0F) {
  using Weights = DenseWeights<In, Out>;
  constexpr std::size_t kFull = Weights::kFullPanels * Weights::kPanel;
  for (std::size_t k = 0; k < kFull; k += Weights::kPanel)
    policy::lane_panel<In, Weights::kPanel, Weights::kPanel>(layer.w + k * In, layer.b + k, x,
                                                             y + k);
  if constexpr (Weights::kTail > 0)
    policy::lane_panel<In, Weights::kTail, Out - kFull>(layer.w + kFull * In, layer.b + kFull, x,
                                                        y + kFull);
  activate<A>(y, slope);
}

/// As normalize() of plain numbers, in double precision.
template <std::size_t N, std::size_t Lanes>
inline void normalize(const ObservationStatistics<N>& statistics, Simd<float, Lanes> (&x)[N]) {
  using Wide = Simd<double, Lanes>;
  for (std::size_t i = 0; i < N; ++i) {
    const Wide value = (Wide(x[i]) - Wide(statistics.mean[i])) / Wide(statistics.deviation[i]);
    x[i] = Simd<float, Lanes>(clamp(value, Wide(-statistics.clip), Wide(statistics.clip)));
  }
}

namespace policy {

/// y = A(x): an activation that follows no layer.
template <Activation A, std::size_t Lanes, std::size_t N>
inline void apply(const Simd<float, Lanes> (&x)[N], Simd<float, Lanes> (&y)[N],
                  float slope = 0.0F) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i];
  activate<A>(y, slope);
}

/// Calls evaluate(x, y) of plain numbers lane by lane, for layers that cannot be vectorized.
template <std::size_t Lanes, std::size_t In, std::size_t Out, class Evaluate>
inline void lane_by_lane(const Simd<float, Lanes> (&x)[In], Simd<float, Lanes> (&y)[Out],
                         Evaluate&& evaluate) {
  for (int k = 0; k < static_cast<int>(Lanes); ++k) {
    float one[In];
    float answer[Out];
    for (std::size_t i = 0; i < In; ++i) one[i] = lane(x[i], k);
    evaluate(one, answer);
    for (std::size_t i = 0; i < Out; ++i) set_lane(y[i], k, answer[i]);
  }
}

}  // namespace policy
}  // namespace eagerx
