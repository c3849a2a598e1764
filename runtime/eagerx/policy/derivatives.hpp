// Layers of trained networks over numbers with derivatives, for `eagerx-gen linearize`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/agent.hpp>
#include <eagerx/math.hpp>
#include <eagerx/number.hpp>
#include <eagerx/policy.hpp>
#include <eagerx/space.hpp>
#include <type_traits>

namespace eagerx {

namespace policy {

/// log(1 + e^x).
inline Number softplus_with_derivative(const Number& x) {
  constexpr double kIsX = 30.0;
  const double value = x.value > kIsX ? x.value : eagerx::log(1.0 + eagerx::exp(x.value));
  return eagerx::detail::chain(x, value, eagerx::sigmoid(x.value));
}

/// x·(1 + erf(x/√2))/2, with erf in float32 as in the program.
inline Number gelu_with_derivative(const Number& x) {
  constexpr double kSqrtHalf = 0.70710678118654752, kInverseSqrtTwoPi = 0.39894228040143268;
  const double share =
      0.5 * (1.0 + static_cast<double>(erf(static_cast<float>(x.value * kSqrtHalf))));
  const double density = kInverseSqrtTwoPi * eagerx::exp(-0.5 * x.value * x.value);
  return eagerx::detail::chain(x, x.value * share, share + x.value * density);
}

template <Activation A>
Number activated_with_derivative(const Number& x, [[maybe_unused]] double slope) {
  if constexpr (A == Activation::relu) {
    return x.value > 0.0 ? x : Number(0.0);
  } else if constexpr (A == Activation::tanh) {
    return eagerx::tanh(x);
  } else if constexpr (A == Activation::elu) {
    return x.value < 0.0 ? Number(slope) * (eagerx::exp(x) - Number(1.0)) : x;
  } else if constexpr (A == Activation::leaky_relu) {
    return x.value < 0.0 ? Number(slope) * x : x;
  } else if constexpr (A == Activation::silu) {
    return x * eagerx::sigmoid(x);
  } else if constexpr (A == Activation::gelu) {
    return gelu_with_derivative(x);
  } else if constexpr (A == Activation::gelu_tanh) {
    constexpr double kSqrtTwoOverPi = 0.79788456080286536, kCubic = 0.044715;
    const Number inner = Number(kSqrtTwoOverPi) * (x + Number(kCubic) * x * x * x);
    return x * eagerx::sigmoid(inner + inner);
  } else if constexpr (A == Activation::softplus) {
    return softplus_with_derivative(x);
  } else if constexpr (A == Activation::sigmoid) {
    return eagerx::sigmoid(x);
  } else {
    return x;
  }
}

}  // namespace policy

template <Activation A, std::size_t N>
void activate(Number (&y)[N], float slope = 0.0F) {
  for (Number& each : y)
    each = policy::activated_with_derivative<A>(each, static_cast<double>(slope));
}

template <Activation A, std::size_t In, std::size_t Out>
void dense(const DenseWeights<In, Out>& layer, const Number (&x)[In], Number (&y)[Out],
           float slope = 0.0F) {
  for (std::size_t k = 0; k < Out; ++k) {
    // The bias of an output is at its place in the panels, too.
    Number sum(static_cast<double>(layer.b[k]));
    for (std::size_t i = 0; i < In; ++i) {
      const auto weight = static_cast<double>(layer.w[DenseWeights<In, Out>::index(k, i)]);
      sum.value += weight * x[i].value;
      for (std::size_t d = 0; d < linearize::kSeeds; ++d)
        sum.derivative[d] += weight * x[i].derivative[d];
    }
    y[k] = sum;
  }
  activate<A>(y, slope);
}
/// Profile fast, which is the same here.
template <Activation A, std::size_t In, std::size_t Out>
void fast_dense(const DenseWeights<In, Out>& layer, const Number (&x)[In], Number (&y)[Out],
                float slope = 0.0F) {
  dense<A>(layer, x, y, slope);
}

template <std::size_t N>
void normalize(const ObservationStatistics<N>& statistics, Number (&x)[N]) {
  for (std::size_t i = 0; i < N; ++i) {
    const Number value = (x[i] - Number(statistics.mean[i])) / Number(statistics.deviation[i]);
    const double clip = statistics.clip;
    x[i] = value.value < -clip ? Number(-clip) : clip < value.value ? Number(clip) : value;
  }
}

template <class Input, std::size_t N>
void flatten_padded(const Input& window, Number (&input)[N], std::size_t& position) {
  using Message = typename Input::value_type;
  const std::uint32_t missing = Input::kMaxSize - window.size();
  for (std::uint32_t w = 0; w < Input::kMaxSize; ++w) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      input[position++] =
          window.empty() ? Number(0.0) : Number(element(window[w < missing ? 0 : w - missing], i));
    }
  }
}

template <class Message, std::size_t N>
Message unflatten(const Number (&output)[N], std::size_t& position) {
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) element(action, i) = output[position++];
  return action;
}

/// A message of numbers with derivatives.
template <class Message>
concept HasDerivatives = std::is_same_v<ScalarOf<Message>, Number>;

/// Clipped to the bounds of the space; at a bound, derivatives are zero.
template <HasDerivatives Message>
Message clipped(Message action, const Space<Message>& space) {
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    Number& x = element(action, i);
    const Number low = element(space.low, i), high = element(space.high, i);
    if (x < low) x = low;
    if (high < x) x = high;
  }
  return action;
}

}  // namespace eagerx
