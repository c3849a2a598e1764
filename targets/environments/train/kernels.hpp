// The time-critical loops, compiled for several instruction sets. All give the same bits: this file
// fixes the order of sums, and no operations are fused.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "targets/environments/train/simd.hpp"

namespace eagerx::train {

/// A layer of a network: y [outputs] = W x + b.
struct DenseSizes {
  std::size_t inputs, outputs;
};

/// Adam's constants for one step.
struct AdamStep {
  float step_size;
  float gradient_scale;     // what the gradient is multiplied by first
  float mean_correction;    // 1 - 0.9^steps
  float square_correction;  // 1 - 0.999^steps
};

struct Kernels {
  const char* name;

  /// y [outputs] = W x + b of one tile. W [outputs][inputs]; sums as in eagerx/policy.hpp.
  void (*dense)(DenseSizes sizes, const float* weights, const float* bias, const Simd* x, Simd* y);

  /// dx [inputs] = Wᵀ dy, outputs in order.
  void (*dense_transposed)(DenseSizes sizes, const float* weights, const Simd* dy, Simd* dx);

  /// dW += Σ dy xᵀ over the samples in order; db += Σ dy, first over the tiles, then over the lanes
  /// (halves onto halves). x and dy of the next tile are `stride` SIMD vectors
  /// further on. `scratch` [tiles * kLanes].
  void (*dense_gradient)(DenseSizes sizes, const Simd* x, const Simd* dy, std::size_t tiles,
                         std::size_t stride, Simd* scratch, float* dw, float* db);

  /// x = tanh(x).
  void (*tanh)(Simd* x, std::size_t count);

  /// dx *= 1 - y², the derivative of y = tanh(x).
  void (*tanh_slope)(const Simd* y, Simd* dx, std::size_t count);

  /// x = max(x, 0).
  void (*relu)(Simd* x, std::size_t count);

  /// dx = 0 where y = relu(x) is not above 0.
  void (*relu_slope)(const Simd* y, Simd* dx, std::size_t count);

  /// One step of a memory of `units` units. `gates` and `products` have what comes of the inputs
  /// and of h, with their biases; `before` and `after` are h, and c of an LSTM. What
  /// slopes need takes the place of `gates` and `products`.
  void (*gru)(std::size_t units, Simd* gates, Simd* products, const Simd* before, Simd* after);
  void (*lstm)(std::size_t units, Simd* gates, Simd* products, const Simd* before, Simd* after);

  /// `dafter` to the derivatives by gates and products; what of it goes to the state before without
  /// them takes its place.
  void (*gru_slopes)(std::size_t units, const Simd* gates, const Simd* products, const Simd* before,
                     Simd* dafter, Simd* dgates, Simd* dproducts);
  void (*lstm_slopes)(std::size_t units, const Simd* gates, const Simd* products,
                      const Simd* before, Simd* dafter, Simd* dgates, Simd* dproducts);

  /// to += continues * (x + y).
  void (*carry)(const Simd& continues, const Simd* x, const Simd* y, Simd* to, std::size_t count);

  /// to += x.
  void (*add)(const float* x, float* to, std::size_t count);

  /// to += share * (x - to).
  void (*approach)(float share, const float* x, float* to, std::size_t count);

  /// One step of Adam (Kingma and Ba 2015, β 0.9 and 0.999) for `count` weights.
  void (*adam)(float* weights, const float* gradient, float* mean, float* square, std::size_t count,
               AdamStep step);
};

/// Those that this machine can run, the slowest first.
std::span<const Kernels* const> kernels_here();

/// The fastest of them, or the one with this name; null if it is not here.
const Kernels* find_kernels(std::string_view name);

}  // namespace eagerx::train
