// Trained networks as constants: fixed-size fully connected layers in float32.
//
// Exact profile. Every output is
//   ((bias + (w[0] x[0] + w[1] x[1] + … + w[7] x[7])) + (w[8] x[8] + … + w[15] x[15])) + …
// with every product and every sum rounded once, in this order. Groups of eight inputs keep the
// error at or below that of a BLAS (one long chain has several times as much) and cost nothing.
// An output that is alone in its panel (the last of 1, 9, 17, …) is bias + s, where s are sixteen
// sums s[k] = (w[k] x[k] + w[k+16] x[k+16]) + …, added in halves: s[k] + s[k+8] for k below 8, then
// 4, 2, 1. Products beyond the last input count as 0.
// Outputs do not mix, so lanes, panels and loop nests differ from machine to machine and the bits
// do not (-ffp-contract=off provided).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/policy/activation.hpp>
#include <eagerx/policy/panel.hpp>

namespace eagerx {

/// Weights of y = activation(W x + b), laid out for sequential reads: outputs in panels of eight,
/// in each panel one row of eight weights for each input. The remaining outputs form a narrower
/// panel (1, 2, 4 or 8 wide), padded with zeros. The same layout on every target.
template <std::size_t In, std::size_t Out>
struct DenseWeights {
  static_assert(In > 0 && Out > 0, "a layer has at least one input and one output");
  static constexpr std::size_t kPanel = policy::kPanel;
  static constexpr std::size_t kFullPanels = Out / kPanel;
  static constexpr std::size_t kTail = Out % kPanel == 0 ? 0 : std::bit_ceil(Out % kPanel);
  static constexpr std::size_t kPadded = kFullPanels * kPanel + kTail;

  alignas(32) float w[In * kPadded];  // [panel][In][width of the panel]
  alignas(32) float b[kPadded];

  /// Index in `w` of the weight from input `in` to output `out`.
  static constexpr std::size_t index(std::size_t out, std::size_t in) {
    const std::size_t panel = out / kPanel;
    const std::size_t width = panel < kFullPanels ? kPanel : kTail;
    return panel * kPanel * In + in * width + out % kPanel;
  }
};

/// y = A(y). `slope` is the factor of elu and leaky relu.
template <Activation A, std::size_t N>
inline void activate(float (&y)[N], float slope = 0.0F) {
  if constexpr (A != Activation::identity) policy::activate_all<A, N>(y, slope);
}

/// y = A(W x + b); `x` [In] and `y` [Out] must not overlap. No heap.
template <Activation A, std::size_t In, std::size_t Out>
[[gnu::always_inline]] inline void dense(const DenseWeights<In, Out>& layer, const float (&x)[In],
                                         float (&y)[Out], float slope = 0.0F) {
  using Weights = DenseWeights<In, Out>;
  constexpr std::size_t kFull = Weights::kFullPanels * Weights::kPanel;
  policy::full_panels<A, In, Weights::kFullPanels>(layer.w, layer.b, x, y, slope);
  if constexpr (Weights::kTail > 0) {
    float tail[Weights::kTail];
    policy::tail_panel<In, Weights::kTail>(layer.w + kFull * In, layer.b + kFull, x, tail);
    if constexpr (A != Activation::identity) policy::activate_all<A, Out - kFull>(tail, slope);
    for (std::size_t k = kFull; k < Out; ++k) y[k] = tail[k - kFull];
  }
}

/// Parameters of a LayerNorm.
template <std::size_t N>
struct NormWeights {
  float gamma[N];
  float beta[N];
  float epsilon;
};

/// y = gamma (y - mean(y)) / sqrt(var(y) + epsilon) + beta; sums in groups of eight, as above.
template <class R, std::size_t N>
inline void layer_norm(const NormWeights<N>& norm, R (&y)[N]) {
  const R mean = policy::grouped_sum(y) / R(static_cast<float>(N));
  R squares[N];
  for (std::size_t k = 0; k < N; ++k) y[k] = y[k] - mean;
  for (std::size_t k = 0; k < N; ++k) squares[k] = y[k] * y[k];
  const R variance = policy::grouped_sum(squares) / R(static_cast<float>(N));
  const R scale = R(1.0F) / eagerx::sqrt(variance + R(norm.epsilon));
  for (std::size_t k = 0; k < N; ++k) y[k] = (y[k] * scale) * R(norm.gamma[k]) + R(norm.beta[k]);
}

/// Statistics of observations: `deviation` is sqrt(variance + epsilon).
template <std::size_t N>
struct ObservationStatistics {
  double mean[N];
  double deviation[N];
  double clip;
};

/// x = clip((x - mean) / deviation, -clip, clip) in double precision, as VecNormalize has it: the
/// same bits. NaN stays NaN.
template <std::size_t N>
inline void normalize(const ObservationStatistics<N>& statistics, float (&x)[N]) {
  for (std::size_t i = 0; i < N; ++i) {
    const double value = (static_cast<double>(x[i]) - statistics.mean[i]) / statistics.deviation[i];
    x[i] = static_cast<float>(clamp(value, -statistics.clip, statistics.clip));
  }
}

/// An observation and a network's answer, without NaN.
template <std::size_t In, std::size_t Out>
struct KnownAnswers {
  float observation[In];
  float answer[Out];
};

/// True if `evaluate(observation, answer)` reproduces every known answer bit for bit or, with a
/// tolerance, within the tolerance times the answer (or times one for small answers).
template <class Evaluate, std::size_t In, std::size_t Out, std::size_t Rows>
inline bool answers(Evaluate&& evaluate, const KnownAnswers<In, Out> (&rows)[Rows],
                    float tolerance = 0.0F) {
  bool same = true;
  for (const KnownAnswers<In, Out>& row : rows) {
    float answer[Out];
    evaluate(row.observation, answer);
    for (std::size_t k = 0; k < Out; ++k) {
      const float known = row.answer[k];
      const bool equal =
          std::bit_cast<std::uint32_t>(answer[k]) == std::bit_cast<std::uint32_t>(known);
      const float most = tolerance * max(abs(known), 1.0F);
      same = same && (equal || (tolerance > 0.0F && abs(answer[k] - known) <= most));
    }
  }
  return same;
}

/// The index of the largest number, the first of equal ones: the choice of a DQN.
template <std::size_t N>
constexpr std::size_t argmax(const float (&y)[N]) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < N; ++k) {
    if (y[best] < y[k]) best = k;
  }
  return best;
}

}  // namespace eagerx
