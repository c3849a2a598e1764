// Layers of trained networks over packs: one lane is one environment, with the bits of
// eagerx/policy.hpp. A lane's sums go in that order; lanes do not mix.
#pragma once

#include <algorithm>
#include <cstddef>
#include <eagerx/pack.hpp>
#include <eagerx/policy.hpp>
#include <eagerx/policy/float_lanes.hpp>
#include <utility>

namespace eagerx {
namespace policy {

#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr bool kManyRegisters = true;  // 32
#else
inline constexpr bool kManyRegisters = false;  // 16
#endif

/// Outputs and registers of lanes at a time: what is summed of a group stays in registers, with the
/// input. Of 16 registers none is left for the sums, which stay in memory. Measured with g++ 12.
inline constexpr std::size_t kOutputsAtATime = kManyRegisters ? 8 : 4;
inline constexpr std::size_t kLaneRegisters = kManyRegisters ? 1 : 2;

/// Some outputs of one panel. w: the first one's weights, [In][Width].
template <std::size_t In, std::size_t Width, std::size_t Outputs, class Real>
class LaneOutputs {
  using Vector = typename Real::Vector;
  static constexpr std::size_t kAtATime = std::min(kLaneRegisters, Real::kCount);

 public:
  static void run(const float* w, const float* b, const Real* x, Real* y) {
    for (std::size_t k = 0; k < Outputs; ++k) y[k] = Real(b[k]);
    constexpr std::size_t kRest = In % kGroup;
    constexpr std::size_t kWhole = In - kRest;
    for (std::size_t first = 0; first < Real::kCount; first += kAtATime) {
      const auto in_memory = [&](auto k, auto i) -> Vector& { return y[k].v[first + i]; };
      Vector sums[Outputs][kAtATime];
      const auto sum = [&](auto k, auto i) -> Vector& {
        if constexpr (kManyRegisters) return sums[k][i];
        if constexpr (!kManyRegisters) return in_memory(k, i);
      };
      if constexpr (kManyRegisters) each([&](auto k, auto i) { sum(k, i) = in_memory(k, i); });
      for (std::size_t j = 0; j < kWhole; j += kGroup)
        add<kGroup>(w + j * Width, x + j, first, sum);
      if constexpr (kRest > 0) add<kRest>(w + kWhole * Width, x + kWhole, first, sum);
      if constexpr (kManyRegisters) each([&](auto k, auto i) { in_memory(k, i) = sum(k, i); });
    }
  }

 private:
  template <class F>
  [[gnu::always_inline]] static void each(F&& f) {
    detail::unrolled<Outputs>([&](auto k) __attribute__((always_inline)) {
      detail::unrolled<kAtATime>([&](auto i) __attribute__((always_inline)) { f(k, i); });
    });
  }
  /// Adds the products of `Rows` inputs to `sum`, in the registers from `first` on.
  template <std::size_t Rows, class Sum>
  [[gnu::always_inline]] static void add(const float* w, const Real* x, std::size_t first,
                                         const Sum& sum) {
    Vector part[Outputs][kAtATime];
    detail::unrolled<Rows>([&](auto row) {
      Vector input[kAtATime];
      detail::unrolled<kAtATime>([&](auto i) {
        input[i] = x[row].v[first + i];
        in_order(input[i]);
      });
      detail::unrolled<Outputs>([&](auto k) {
        const Vector weight = w[row * Width + k] - Vector{};
        detail::unrolled<kAtATime>([&](auto i) {
          const Vector product = weight * input[i];
          part[k][i] = row == 0 ? product : part[k][i] + product;
          in_order(part[k][i]);
        });
      });
    });
    each([&](auto k, auto i) { sum(k, i) = sum(k, i) + part[k][i]; });
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
