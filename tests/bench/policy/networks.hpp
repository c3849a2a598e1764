// The networks that are measured: weights sampled by a fixed rule, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/policy.hpp>
#include <eagerx/policy/branches.hpp>
#include <eagerx/policy/fast.hpp>
#include <eagerx/policy/int8.hpp>

#include "sampler.hpp"

namespace bench {

template <std::size_t In, std::size_t Out>
constexpr eagerx::DenseWeights<In, Out> sampled(Sampler& sampler) {
  eagerx::DenseWeights<In, Out> layer{};
  for (std::size_t out = 0; out < Out; ++out) {
    layer.b[out] = sampler.next();
    for (std::size_t in = 0; in < In; ++in) layer.w[layer.index(out, in)] = sampler.next();
  }
  return layer;
}

/// The same with weights of eight bits.
template <std::size_t In, std::size_t Out>
constexpr eagerx::Int8Weights<In, Out> sampled_int8(Sampler& sampler) {
  eagerx::Int8Weights<In, Out> layer{};
  for (std::size_t out = 0; out < Out; ++out) {
    layer.b[out] = sampler.next();
    layer.scale[out] = 0x1p-9F;
    for (std::size_t in = 0; in < In; ++in) {
      layer.w[layer.index(out, in)] = static_cast<std::int8_t>(sampler.next() * 508.0F);
    }
  }
  return layer;
}

/// 3 -> A -> B -> 1 with activation F.
template <std::size_t A, std::size_t B, eagerx::Activation F>
struct Mlp {
  struct Weights {
    eagerx::DenseWeights<3, A> first;
    eagerx::DenseWeights<A, B> second;
    eagerx::DenseWeights<B, 1> third;
  };
  static constexpr Weights make() {
    Sampler sampler;
    return {sampled<3, A>(sampler), sampled<A, B>(sampler), sampled<B, 1>(sampler)};
  }

  [[gnu::noipa]] static void run(const Weights& weights, const float (&x)[3], float (&y)[1]) {
    float hidden1[A];
    float hidden2[B];
    eagerx::dense<F>(weights.first, x, hidden1);
    eagerx::dense<F>(weights.second, hidden1, hidden2);
    eagerx::dense<eagerx::Activation::tanh>(weights.third, hidden2, y);
  }

  [[gnu::noipa]] static void run_fast(const Weights& weights, const float (&x)[3], float (&y)[1]) {
    float hidden1[A];
    float hidden2[B];
    eagerx::fast_dense<F>(weights.first, x, hidden1);
    eagerx::fast_dense<F>(weights.second, hidden1, hidden2);
    eagerx::fast_dense<eagerx::Activation::tanh>(weights.third, hidden2, y);
  }

  struct Int8 {
    eagerx::Int8Weights<3, A> first;
    eagerx::Int8Weights<A, B> second;
    eagerx::Int8Weights<B, 1> third;
  };
  static constexpr Int8 make_int8() {
    Sampler sampler;
    return {sampled_int8<3, A>(sampler), sampled_int8<A, B>(sampler), sampled_int8<B, 1>(sampler)};
  }
  [[gnu::noipa]] static void run_int8(const Int8& weights, const float (&x)[3], float (&y)[1]) {
    float hidden1[A];
    float hidden2[B];
    eagerx::dense<F>(weights.first, x, hidden1);
    eagerx::dense<F>(weights.second, hidden1, hidden2);
    eagerx::dense<eagerx::Activation::tanh>(weights.third, hidden2, y);
  }

  /// Rows of weights, as everybody writes them first.
  template <std::size_t In, std::size_t Out>
  static void plain_layer(const eagerx::DenseWeights<In, Out>& layer, const float (&x)[In],
                          float (&y)[Out]) {
    for (std::size_t out = 0; out < Out; ++out) {
      float sum = layer.b[out];
      for (std::size_t in = 0; in < In; ++in) sum = sum + layer.w[out * In + in] * x[in];
      y[out] =
          F == eagerx::Activation::tanh || Out == 1 ? eagerx::tanh(sum) : (sum < 0.0F ? 0.0F : sum);
    }
  }
  [[gnu::noipa]] static void plain(const Weights& weights, const float (&x)[3], float (&y)[1]) {
    float hidden1[A];
    float hidden2[B];
    plain_layer(weights.first, x, hidden1);
    plain_layer(weights.second, hidden1, hidden2);
    plain_layer(weights.third, hidden2, y);
  }
};

using Relu64 = Mlp<64, 64, eagerx::Activation::relu>;
using Tanh64 = Mlp<64, 64, eagerx::Activation::tanh>;
using Relu256 = Mlp<256, 256, eagerx::Activation::relu>;
using Relu400 = Mlp<400, 300, eagerx::Activation::relu>;

/// A policy of a legged robot: 5 observations of 45 numbers through an encoder 225 -> 128 -> 16,
/// and the newest one together with its answer through 256-128-64 to 12 actions, as the generator
/// writes it.
struct Branches {
  static constexpr std::size_t kObservation = 45, kHistory = 5 * kObservation, kLatent = 16;
  static constexpr std::size_t kJoined = kObservation + kLatent, kActions = 12;
  static constexpr std::size_t kProducts =
      kHistory * 128 + 128 * kLatent + kJoined * 256 + 256 * 128 + 128 * 64 + 64 * kActions;
  struct Weights {
    eagerx::DenseWeights<kHistory, 128> encoder1;
    eagerx::DenseWeights<128, kLatent> encoder2;
    eagerx::DenseWeights<kJoined, 256> first;
    eagerx::DenseWeights<256, 128> second;
    eagerx::DenseWeights<128, 64> third;
    eagerx::DenseWeights<64, kActions> fourth;
  };
  static constexpr Weights make() {
    Sampler sampler;
    return {sampled<kHistory, 128>(sampler), sampled<128, kLatent>(sampler),
            sampled<kJoined, 256>(sampler),  sampled<256, 128>(sampler),
            sampled<128, 64>(sampler),       sampled<64, kActions>(sampler)};
  }

  [[gnu::noipa]] static void run(const Weights& weights, const float (&x)[kHistory],
                                 float (&y)[kActions]) {
    using enum eagerx::Activation;
    using eagerx::policy::front;
    float buffer1[256];
    float buffer2[128];
    float(&hidden1)[128] = front<128>(buffer1);
    float(&latent)[kLatent] = front<kLatent>(buffer2);
    eagerx::dense<relu>(weights.encoder1, x, hidden1);
    eagerx::dense<identity>(weights.encoder2, hidden1, latent);
    const float(&newest)[kObservation] =
        eagerx::policy::slice<kHistory - kObservation, kObservation>(x);
    float joined[kJoined];
    eagerx::policy::join(joined, newest, latent);
    eagerx::dense<relu>(weights.first, joined, buffer1);
    eagerx::dense<relu>(weights.second, buffer1, buffer2);
    float(&hidden3)[64] = front<64>(buffer1);
    eagerx::dense<relu>(weights.third, buffer2, hidden3);
    eagerx::dense<tanh>(weights.fourth, hidden3, y);
  }
};

}  // namespace bench
