// Trained networks as constants: fixed-size fully connected layers in float32.
//
// Exact profile. Every output is
//   ((bias + (w[0] x[0] + w[1] x[1] + … + w[7] x[7])) + (w[8] x[8] + … + w[15] x[15])) + …
// with every product and every sum rounded once, in this order. Groups of eight inputs keep the
// error at or below that of a BLAS (one long chain has several times as much) and cost nothing.
// Outputs do not mix, so lanes, panels and loop nests differ from machine to machine and the bits
// do not (-ffp-contract=off provided).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/policy/panel.hpp>

namespace eagerx {

/// What a layer applies to each of its outputs.
enum class Activation : std::uint8_t {
  identity,
  relu,  ///< x < 0 ? 0 : x; NaN stays NaN, so that a broken observation shows in the action
  tanh,  ///< eagerx::tanh
};

/// Weights of y = activation(W x + b), laid out for reading straight through: outputs in panels of
/// eight, in a panel one row of eight weights for each input. What does not fill a panel is one
/// narrower panel (1, 2, 4 or 8 wide), padded with zeros. The same layout on every target.
template <std::size_t In, std::size_t Out>
struct DenseWeights {
  static_assert(In > 0 && Out > 0, "a layer has at least one input and one output");
  static constexpr std::size_t kPanel = policy::kPanel;
  static constexpr std::size_t kFullPanels = Out / kPanel;
  static constexpr std::size_t kTail = Out % kPanel == 0 ? 0 : std::bit_ceil(Out % kPanel);
  static constexpr std::size_t kPadded = kFullPanels * kPanel + kTail;

  alignas(32) float w[In * kPadded];  // [panel][In][width of the panel]
  alignas(32) float b[kPadded];

  /// Where the weight from input `in` to output `out` lives in `w`.
  static constexpr std::size_t index(std::size_t out, std::size_t in) {
    const std::size_t panel = out / kPanel;
    const std::size_t width = panel < kFullPanels ? kPanel : kTail;
    return panel * kPanel * In + in * width + out % kPanel;
  }
};

/// y = A(W x + b); `x` [In] and `y` [Out] must not overlap. No heap.
template <Activation A, std::size_t In, std::size_t Out>
inline void dense(const DenseWeights<In, Out>& layer, const float (&x)[In], float (&y)[Out]) {
  using Weights = DenseWeights<In, Out>;
  constexpr std::size_t kFull = Weights::kFullPanels * Weights::kPanel;
  policy::full_panels<In, Weights::kFullPanels>(layer.w, layer.b, x, y);
  if constexpr (Weights::kTail > 0) {
    float tail[Weights::kTail];
    policy::tail_panel<In, Weights::kTail>(layer.w + kFull * In, layer.b + kFull, x, tail);
    for (std::size_t k = kFull; k < Out; ++k) y[k] = tail[k - kFull];
  }
  if constexpr (A == Activation::relu) {
    for (std::size_t k = 0; k < Out; ++k) y[k] = y[k] < 0.0F ? 0.0F : y[k];
  } else if constexpr (A == Activation::tanh) {
    policy::tanh_all<Out>(y);
  }
}

}  // namespace eagerx
