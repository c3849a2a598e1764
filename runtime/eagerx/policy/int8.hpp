// Layers with weights of eight bits, a quarter of the flash of float32.
//
// Weights are whole numbers in -127…127 times one float for each output (symmetric). The inputs of
// a layer are rounded to whole numbers of 16 bits, as fractions of the largest one, so that all
// sums are exact in 32 bits; their order does not matter, and machines without a floating-point
// unit gain as well. Every output is
//   b + (scale * step) * (w[0] q[0] + w[1] q[1] + …)
// with four roundings: of the two products, of the whole number and of the sum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/policy/int8_rows.hpp>
#include <eagerx/policy/panel.hpp>

namespace eagerx {

/// Weights of y = activation(W x + b): four inputs of each of four outputs at a time, then row by
/// row; rows are padded with zeros to whole words. The same layout on every target.
template <std::size_t In, std::size_t Out>
struct Int8Weights {
  static_assert(In > 0 && Out > 0, "a layer has at least one input and one output");
  static constexpr std::size_t kRow = policy::int8_row(In);

  alignas(4) std::int8_t w[Out * kRow];
  float scale[Out];
  float b[Out];

  /// Index in `w` of the weight from input `in` to output `out`.
  static constexpr std::size_t index(std::size_t out, std::size_t in) {
    return policy::int8_index(In, Out, out, in);
  }
};

/// y = A(W x + b); `x` [In] and `y` [Out] must not overlap. If an input is not a finite number, all
/// outputs are NaN.
template <Activation A, std::size_t In, std::size_t Out>
inline void dense(const Int8Weights<In, Out>& layer, const float (&x)[In], float (&y)[Out],
                  float slope = 0.0F) {
  alignas(4) std::int16_t q[Int8Weights<In, Out>::kRow];
  const float step = policy::round_inputs(x, In, q);
  policy::int8_rows(layer.w, layer.scale, layer.b, q, step, y, In, Out);
  policy::activate_all<A, Out>(y, slope);
}

}  // namespace eagerx
