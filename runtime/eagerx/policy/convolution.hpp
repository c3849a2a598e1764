// Convolutions and pools of trained networks, over [channels][height][width] in float32. One
// dimension is a height of one.
//
// Every place of the result is a dense layer (eagerx/policy.hpp) of the values under the kernel, in
// the order channel, row, column, zeros where the kernel lies over the border: the same order of
// additions and the same bits on every machine.
#pragma once

#include <cstddef>
#include <eagerx/policy.hpp>

namespace eagerx {

/// A kernel that moves over an image, in torch's terms. The padding is that before the first row
/// and column; the padding after the last ones follows from the size of the result.
struct Kernel {
  std::size_t channels = 1, height = 1, width = 1;  // of what is read
  std::size_t rows = 1, columns = 1;                // of the kernel
  std::size_t stride_down = 1, stride_right = 1;
  std::size_t pad_top = 0, pad_left = 0;
  std::size_t dilation_down = 1, dilation_right = 1;
  std::size_t out_height = 1, out_width = 1;

  constexpr std::size_t inputs() const { return channels * height * width; }
  constexpr std::size_t places() const { return out_height * out_width; }
};

namespace policy {

/// Index into the image of kernel element (row, column) at place (down, right), -1 in the padding.
template <Kernel K>
constexpr std::ptrdiff_t under(std::size_t down, std::size_t right, std::size_t row,
                               std::size_t column) {
  // Unsigned: indexes before the border wrap to very large numbers.
  const std::size_t y = down * K.stride_down + row * K.dilation_down - K.pad_top;
  const std::size_t x = right * K.stride_right + column * K.dilation_right - K.pad_left;
  if (y >= K.height || x >= K.width) return -1;
  return static_cast<std::ptrdiff_t>(y * K.width + x);
}

/// The values of `Channels` channels under the kernel, zeros in the padding.
template <Kernel K, std::size_t Channels>
inline void gather(const float* x, std::size_t down, std::size_t right,
                   float (&patch)[Channels * K.rows * K.columns]) {
  for (std::size_t row = 0; row < K.rows; ++row) {
    for (std::size_t column = 0; column < K.columns; ++column) {
      const std::ptrdiff_t at = under<K>(down, right, row, column);
      for (std::size_t c = 0; c < Channels; ++c) {
        const std::size_t to = (c * K.rows + row) * K.columns + column;
        patch[to] = at < 0 ? 0.0F : x[c * K.height * K.width + static_cast<std::size_t>(at)];
      }
    }
  }
}

}  // namespace policy

/// Weights of a convolution with `Out` channels: one dense layer for each of `Groups` groups;
/// `Layer` is DenseWeights or, with weights of eight bits, Int8Weights (eagerx/policy/int8.hpp).
template <Kernel K, std::size_t Out, std::size_t Groups = 1,
          template <std::size_t, std::size_t> class Layer = DenseWeights>
struct ConvolutionWeights {
  static_assert(K.channels % Groups == 0 && Out % Groups == 0, "groups divide the channels");
  static constexpr std::size_t kChannels = K.channels / Groups;  // that a group reads
  static constexpr std::size_t kOut = Out / Groups;
  static constexpr std::size_t kPatch = kChannels * K.rows * K.columns;
  Layer<kPatch, kOut> group[Groups];
};

/// y = A(x * w + b): cross-correlation, as torch has it. y [Out][out_height][out_width]; `x` and
/// `y` must not overlap.
template <Activation A, Kernel K, std::size_t Out, std::size_t Groups,
          template <std::size_t, std::size_t> class Layer>
inline void convolve(const ConvolutionWeights<K, Out, Groups, Layer>& layer,
                     const float (&x)[K.inputs()], float (&y)[Out * K.places()],
                     float slope = 0.0F) {
  using Weights = ConvolutionWeights<K, Out, Groups, Layer>;
  for (std::size_t g = 0; g < Groups; ++g) {
    const float* channels = x + g * Weights::kChannels * K.height * K.width;
    float* out = y + g * Weights::kOut * K.places();
    for (std::size_t place = 0; place < K.places(); ++place) {
      float patch[Weights::kPatch];
      float values[Weights::kOut];
      policy::gather<K, Weights::kChannels>(channels, place / K.out_width, place % K.out_width,
                                            patch);
      dense<Activation::identity>(layer.group[g], patch, values);
      for (std::size_t k = 0; k < Weights::kOut; ++k) out[k * K.places() + place] = values[k];
    }
  }
  activate<A>(y, slope);
}

/// The largest value under the kernel, channel by channel; NaN stays NaN.
template <Kernel K>
inline void max_pool(const float (&x)[K.inputs()], float (&y)[K.channels * K.places()]) {
  for (std::size_t i = 0; i < K.channels * K.places(); ++i) {
    const float* channel = x + i / K.places() * K.height * K.width;
    const std::size_t place = i % K.places();
    bool found = false;
    float best = 0.0F;
    for (std::size_t k = 0; k < K.rows * K.columns; ++k) {
      const std::ptrdiff_t at =
          policy::under<K>(place / K.out_width, place % K.out_width, k / K.columns, k % K.columns);
      if (at < 0) continue;
      const float value = channel[at];
      if (!found || best < value || value != value) best = value;
      found = true;
    }
    y[i] = best;
  }
}

/// The mean of the values under the kernel, channel by channel: a sum in groups of eight, zeros in
/// the padding, divided by all values of the kernel or, without `CountPadding`, by those inside.
template <Kernel K, bool CountPadding>
inline void average_pool(const float (&x)[K.inputs()], float (&y)[K.channels * K.places()]) {
  for (std::size_t i = 0; i < K.channels * K.places(); ++i) {
    const float* channel = x + i / K.places() * K.height * K.width;
    const std::size_t place = i % K.places();
    float patch[K.rows * K.columns];
    std::size_t count = 0;
    for (std::size_t k = 0; k < K.rows * K.columns; ++k) {
      const std::ptrdiff_t at =
          policy::under<K>(place / K.out_width, place % K.out_width, k / K.columns, k % K.columns);
      patch[k] = at < 0 ? 0.0F : channel[at];
      count += CountPadding || at >= 0 ? 1U : 0U;
    }
    y[i] = policy::grouped_sum(patch) / static_cast<float>(count);
  }
}

}  // namespace eagerx
