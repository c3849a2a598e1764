// Layers of trained networks over packs: one lane is one environment, with the bits of
// eagerx/policy.hpp. A lane's sums go in that order; lanes do not mix.
#pragma once

#include <cstddef>
#include <eagerx/pack.hpp>
#include <eagerx/policy.hpp>
#include <utility>

namespace eagerx {
namespace policy {

/// Outputs at a time: their sums of a group, and an input, stay in registers.
#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr std::size_t kOutputsAtATime = 4;
#else
inline constexpr std::size_t kOutputsAtATime = 2;
#endif

/// Some outputs of one panel. w: the first one's weights, [In][Width].
template <std::size_t In, std::size_t Width, std::size_t Outputs, class Real>
class LaneOutputs {
 public:
  static void run(const float* w, const float* b, const Real* x, Real* y) {
    Real sum[Outputs];
    detail::unrolled<Outputs>([&](auto k) { sum[k] = Real(b[k]); });
    constexpr std::size_t kRest = In % kGroup;
    for (std::size_t j = 0; j + kGroup <= In; j += kGroup) add<kGroup>(w + j * Width, x + j, sum);
    if constexpr (kRest > 0) add<kRest>(w + (In - kRest) * Width, x + (In - kRest), sum);
    detail::unrolled<Outputs>([&](auto k) { y[k] = sum[k]; });
  }

 private:
  /// Adds the products of `Rows` inputs to `sum`.
  template <std::size_t Rows>
  [[gnu::always_inline]] static void add(const float* w, const Real* x, Real (&sum)[Outputs]) {
    Real part[Outputs];
    detail::unrolled<Outputs>([&](auto k) { part[k] = Real(w[k]) * x[0]; });
    detail::unrolled<Rows - 1>([&](auto before) {
      constexpr std::size_t kRow = before + 1;
      const Real input = x[kRow];
      detail::unrolled<Outputs>(
          [&](auto k) { part[k] = part[k] + Real(w[kRow * Width + k]) * input; });
    });
    detail::unrolled<Outputs>([&](auto k) { sum[k] = sum[k] + part[k]; });
  }
};

/// The output that is alone in its panel: what is left of its kChains sums once they are added in
/// halves until `Left` of them are there. Depth first, so that few are there at a time.
template <std::size_t In, class Real>
class LaneOutputAlone {
 public:
  static Real run(const float* w, float b, const Real* x) { return Real(b) + left<1>(w, x, 0); }

 private:
  template <std::size_t Left>
  static Real left(const float* w, const Real* x, std::size_t k) {
    if constexpr (Left == kChains) {
      return chain(w, x, k);
    } else {
      return left<2 * Left>(w, x, k) + left<2 * Left>(w, x, k + Left);
    }
  }
  static Real chain(const float* w, const Real* x, std::size_t k) {
    Real sum = k < In ? Real(w[k]) * x[k] : Real(0.0F);
    for (std::size_t j = k + kChains; j < In; j += kChains) sum = sum + Real(w[j]) * x[j];
    // A last group of fewer numbers is full of zeros.
    constexpr std::size_t kRest = In % kChains;
    if (In > kChains && kRest > 0 && k >= kRest) sum = sum + Real(0.0F);
    return sum;
  }
};

template <std::size_t In, std::size_t Width, std::size_t Outputs, class Real>
void lane_panel(const float* w, const float* b, const Real* x, Real* y) {
  if constexpr (Width == 1) {
    y[0] = LaneOutputAlone<In, Real>::run(w, b[0], x);
  } else {
    constexpr std::size_t kRest = Outputs % kOutputsAtATime;
    constexpr std::size_t kDone = Outputs - kRest;
    for (std::size_t k = 0; k < kDone; k += kOutputsAtATime)
      LaneOutputs<In, Width, kOutputsAtATime, Real>::run(w + k, b + k, x, y + k);
    if constexpr (kRest > 0)
      LaneOutputs<In, Width, kRest, Real>::run(w + kDone, b + kDone, x, y + kDone);
  }
}

}  // namespace policy

/// y = A(y).
template <Activation A, class T, std::size_t Lanes, std::size_t N>
inline void activate(Pack<T, Lanes> (&y)[N], float slope = 0.0F) {
  if constexpr (A != Activation::identity) {
    for (Pack<T, Lanes>& x : y) x = policy::activated<A>(x, slope);
  }
}

/// y = A(W x + b); `x` and `y` must not overlap.
template <Activation A, std::size_t In, std::size_t Out, std::size_t Lanes>
inline void dense(const DenseWeights<In, Out>& layer, const Pack<float, Lanes> (&x)[In],
                  Pack<float, Lanes> (&y)[Out], float slope = 0.0F) {
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
inline void normalize(const ObservationStatistics<N>& statistics, Pack<float, Lanes> (&x)[N]) {
  using Wide = Pack<double, Lanes>;
  for (std::size_t i = 0; i < N; ++i) {
    const Wide value = (Wide(x[i]) - Wide(statistics.mean[i])) / Wide(statistics.deviation[i]);
    x[i] = Pack<float, Lanes>(clamp(value, Wide(-statistics.clip), Wide(statistics.clip)));
  }
}

namespace policy {

/// y = A(x): an activation that follows no layer.
template <Activation A, std::size_t Lanes, std::size_t N>
inline void apply(const Pack<float, Lanes> (&x)[N], Pack<float, Lanes> (&y)[N],
                  float slope = 0.0F) {
  for (std::size_t i = 0; i < N; ++i) y[i] = x[i];
  activate<A>(y, slope);
}

/// evaluate(x, y) of plain numbers, one lane after the other: layers that have no other way.
template <std::size_t Lanes, std::size_t In, std::size_t Out, class Evaluate>
inline void lane_by_lane(const Pack<float, Lanes> (&x)[In], Pack<float, Lanes> (&y)[Out],
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
