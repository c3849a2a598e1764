// The kernels of memories over registers of `Width` floats; see train/kernels_of.hpp.
#pragma once

#include <cstddef>
#include <eagerx/math/hyperbolic.hpp>
#include <eagerx/policy/float_lanes.hpp>

#include "targets/environments/train/simd.hpp"

namespace eagerx::train {

template <std::size_t Width>
struct MemoryKernelsOf {
  using Vector = policy::FloatLanes<Width, kLanes / Width>;

  [[gnu::always_inline]] static Vector load(const Simd& x) { return Vector::load(x.lane); }
  [[gnu::always_inline]] static void store(const Vector& x, Simd& to) { x.store(to.lane); }
  /// dx of y = sigmoid(x).
  [[gnu::always_inline]] static Vector sigmoid_slope(const Vector& y, const Vector& dy) {
    return dy * (y * (Vector(1.0F) - y));
  }
  [[gnu::always_inline]] static Vector tanh_slope(const Vector& y, const Vector& dy) {
    return dy * (Vector(1.0F) - y * y);
  }

  [[gnu::flatten]] static void gru(std::size_t units, Simd* gates, Simd* products,
                                   const Simd* before, Simd* after) {
    for (std::size_t k = 0; k < units; ++k) {
      const std::size_t u = units + k, c = 2 * units + k;
      const Vector reset = sigmoid(load(gates[k]) + load(products[k]));
      const Vector update = sigmoid(load(gates[u]) + load(products[u]));
      const Vector candidate = detail::tanh_inlined(load(gates[c]) + reset * load(products[c]));
      store(reset, gates[k]);
      store(update, gates[u]);
      store(candidate, gates[c]);
      store(candidate + update * (load(before[k]) - candidate), after[k]);
    }
  }

  [[gnu::flatten]] static void gru_slopes(std::size_t units, const Simd* gates,
                                          const Simd* products, const Simd* before, Simd* dafter,
                                          Simd* dgates, Simd* dproducts) {
    for (std::size_t k = 0; k < units; ++k) {
      const std::size_t u = units + k, c = 2 * units + k;
      const Vector reset = load(gates[k]), update = load(gates[u]), candidate = load(gates[c]);
      const Vector dh = load(dafter[k]);
      const Vector dcandidate = tanh_slope(candidate, dh * (Vector(1.0F) - update));
      const Vector dupdate = sigmoid_slope(update, dh * (load(before[k]) - candidate));
      const Vector dreset = sigmoid_slope(reset, dcandidate * load(products[c]));
      store(dreset, dgates[k]);
      store(dupdate, dgates[u]);
      store(dcandidate, dgates[c]);
      store(dreset, dproducts[k]);
      store(dupdate, dproducts[u]);
      store(dcandidate * reset, dproducts[c]);
      store(dh * update, dafter[k]);
    }
  }

  /// tanh(c) is kept in the first products.
  [[gnu::flatten]] static void lstm(std::size_t units, Simd* gates, Simd* products,
                                    const Simd* before, Simd* after) {
    for (std::size_t k = 0; k < units; ++k) {
      const std::size_t f = units + k, g = 2 * units + k, o = 3 * units + k;
      const Vector input = sigmoid(load(gates[k]) + load(products[k]));
      const Vector forget = sigmoid(load(gates[f]) + load(products[f]));
      const Vector candidate = detail::tanh_inlined(load(gates[g]) + load(products[g]));
      const Vector output = sigmoid(load(gates[o]) + load(products[o]));
      const Vector cell = forget * load(before[f]) + input * candidate;
      const Vector bounded = detail::tanh_inlined(cell);
      store(input, gates[k]);
      store(forget, gates[f]);
      store(candidate, gates[g]);
      store(output, gates[o]);
      store(bounded, products[k]);
      store(output * bounded, after[k]);
      store(cell, after[f]);
    }
  }

  [[gnu::flatten]] static void lstm_slopes(std::size_t units, const Simd* gates,
                                           const Simd* products, const Simd* before, Simd* dafter,
                                           Simd* dgates, Simd* dproducts) {
    for (std::size_t k = 0; k < units; ++k) {
      const std::size_t f = units + k, g = 2 * units + k, o = 3 * units + k;
      const Vector input = load(gates[k]), forget = load(gates[f]);
      const Vector candidate = load(gates[g]), output = load(gates[o]);
      const Vector bounded = load(products[k]), dh = load(dafter[k]);
      const Vector dcell = load(dafter[f]) + tanh_slope(bounded, dh * output);
      const Vector slopes[] = {
          sigmoid_slope(input, dcell * candidate), sigmoid_slope(forget, dcell * load(before[f])),
          tanh_slope(candidate, dcell * input), sigmoid_slope(output, dh * bounded)};
      for (std::size_t j = 0; j < 4; ++j) {
        store(slopes[j], dgates[j * units + k]);
        store(slopes[j], dproducts[j * units + k]);
      }
      store(Vector(0.0F), dafter[k]);
      store(dcell * forget, dafter[f]);
    }
  }

  static void carry(const Simd& continues, const Simd* x, const Simd* y, Simd* to,
                    std::size_t count) {
    const Vector share = load(continues);
    for (std::size_t k = 0; k < count; ++k)
      store(load(to[k]) + share * (load(x[k]) + load(y[k])), to[k]);
  }
};

}  // namespace eagerx::train
