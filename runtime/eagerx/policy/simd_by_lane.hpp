// Layers over SIMD vectors that are computed lane by lane: weights of eight bits, convolutions,
// pools, profile fast.
#pragma once

#include <cstddef>
#include <eagerx/policy/convolution.hpp>
#include <eagerx/policy/fast.hpp>
#include <eagerx/policy/int8.hpp>
#include <eagerx/policy/simd.hpp>

namespace eagerx {

template <Activation A, std::size_t In, std::size_t Out, std::size_t Lanes>
inline void dense(const Int8Weights<In, Out>& layer, const Simd<float, Lanes> (&x)[In],
                  Simd<float, Lanes> (&y)[Out], float slope = 0.0F) {
  policy::lane_by_lane(
      x, y, [&](const auto& from, auto& to) { eagerx::dense<A>(layer, from, to, slope); });
}

template <Activation A, std::size_t In, std::size_t Out, std::size_t Lanes>
inline void fast_dense(const DenseWeights<In, Out>& layer, const Simd<float, Lanes> (&x)[In],
                       Simd<float, Lanes> (&y)[Out], float slope = 0.0F) {
  policy::lane_by_lane(
      x, y, [&](const auto& from, auto& to) { eagerx::fast_dense<A>(layer, from, to, slope); });
}

template <Activation A, Kernel K, std::size_t Out, std::size_t Groups,
          template <std::size_t, std::size_t> class Layer, std::size_t Lanes>
inline void convolve(const ConvolutionWeights<K, Out, Groups, Layer>& layer,
                     const Simd<float, Lanes> (&x)[K.inputs()],
                     Simd<float, Lanes> (&y)[Out * K.places()], float slope = 0.0F) {
  policy::lane_by_lane(
      x, y, [&](const auto& from, auto& to) { eagerx::convolve<A>(layer, from, to, slope); });
}

template <Kernel K, std::size_t Lanes>
inline void max_pool(const Simd<float, Lanes> (&x)[K.inputs()],
                     Simd<float, Lanes> (&y)[K.channels * K.places()]) {
  policy::lane_by_lane(x, y, [](const auto& from, auto& to) { eagerx::max_pool<K>(from, to); });
}

template <Kernel K, bool CountPadding, std::size_t Lanes>
inline void average_pool(const Simd<float, Lanes> (&x)[K.inputs()],
                         Simd<float, Lanes> (&y)[K.channels * K.places()]) {
  policy::lane_by_lane(
      x, y, [](const auto& from, auto& to) { eagerx::average_pool<K, CountPadding>(from, to); });
}

}  // namespace eagerx
