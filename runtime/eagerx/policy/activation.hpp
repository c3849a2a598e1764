// Activation functions of layers, over float and over lanes of floats: the same bits.
#pragma once

#include <array>
#include <cstdint>
#include <eagerx/math.hpp>

namespace eagerx {

/// The function that a layer applies to each of its outputs. NaN stays NaN in all of them, so that
/// a broken observation shows in the action.
enum class Activation : std::uint8_t {
  identity,
  relu,        ///< x < 0 ? 0 : x
  tanh,        ///< eagerx::tanh
  elu,         ///< x < 0 ? slope (e^x - 1) : x
  leaky_relu,  ///< x < 0 ? slope x : x
  silu,        ///< x / (1 + e^-x)
  gelu,        ///< x (1 + erf(x / sqrt(2))) / 2
  gelu_tanh,   ///< gelu by tanh: x (1 + tanh(sqrt(2 / pi) (x + 0.044715 x^3))) / 2
  softplus,    ///< log(1 + e^x); x above 20, as torch has it
  sigmoid,     ///< eagerx::sigmoid
};

namespace policy {

/// Error function of a float. Largest measured error: 1.2 ulp.
template <class R>
constexpr R erf(R x) {
  // Interpolated at Chebyshev nodes: erf(x) / x - 1 in x², and -log(1 - erf(x)) / x in x.
  constexpr float kMiddle = 0.92F;
  constexpr float kIsOne = 4.0F;
  constexpr std::array<float, 7> kNear = {0x1.5c1a76p-14F, -0x1.aa0caap-11F, 0x1.54c30cp-8F,
                                          -0x1.b80e28p-6F, 0x1.ce2e06p-4F,   -0x1.812742p-2F,
                                          0x1.06eba8p-3F};
  constexpr std::array<float, 9> kFar = {-0x1.29f296p-22F, 0x1.2dfca4p-18F, -0x1.ad48e4p-17F,
                                         -0x1.21a9e8p-12F, 0x1.e0dd0ep-9F,  -0x1.898c74p-6F,
                                         0x1.b4ea94p-4F,   0x1.450992p-1F,  0x1.20f4bap+0F};
  const R a = min(eagerx::abs(x), R(kIsOne));
  const R near = a + a * detail::horner(a * a, kNear);
  const R far = R(1.0F) - eagerx::exp(R(0.0F) - a * detail::horner(a, kFar));
  return select(x == x, copysign(select(R(kMiddle) < a, far, near), x), x);
}

/// e^x - 1 for x below zero. Largest measured error: 2.5 ulp.
template <class R>
constexpr R expm1_below_zero(R x) {
  constexpr float kIsMinusOne = -20.0F;
  const auto parts = detail::exponential_parts(max(x, R(kIsMinusOne)), R(0.0F));
  const R scale = detail::power_of_two_lanes<R>(parts.n);
  return scale * parts.expm1 + (scale - R(1.0F));
}

/// log(1 + e^x).
template <class R>
constexpr R softplus(R x) {
  constexpr float kIsX = 20.0F;
  const R e = eagerx::exp(min(x, R(kIsX)));
  const R sum = R(1.0F) + e;
  const R lost = sum - R(1.0F);  // log(1 + e) is log(sum) corrected for what sum has lost of e
  const R result = select(lost == R(0.0F), e, eagerx::log(sum) * (e / lost));
  return select(R(kIsX) < x, x, select(x == x, result, x));
}

/// A(x), of a float or of lanes.
template <Activation A, class R>
[[gnu::always_inline]] constexpr R activated(R x, [[maybe_unused]] float slope) {
  const R zero = R(0.0F);
  if constexpr (A == Activation::relu) {
    return max(x, zero);
  } else if constexpr (A == Activation::tanh && lanes<R> > 1) {
    return detail::tanh_inlined(x);
  } else if constexpr (A == Activation::tanh) {
    return eagerx::tanh(x);
  } else if constexpr (A == Activation::elu) {
    return select(x < zero, R(slope) * expm1_below_zero(x), x);
  } else if constexpr (A == Activation::leaky_relu) {
    return select(x < zero, R(slope) * x, x);
  } else if constexpr (A == Activation::silu) {
    return x / (R(1.0F) + eagerx::exp(zero - x));
  } else if constexpr (A == Activation::gelu) {
    constexpr float kSqrtHalf = 0x1.6a09e6p-1F;
    return (R(0.5F) * x) * (R(1.0F) + erf(x * R(kSqrtHalf)));
  } else if constexpr (A == Activation::gelu_tanh) {
    constexpr float kSqrtTwoOverPi = 0x1.988454p-1F;
    constexpr float kCubic = 0.044715F;
    const R inner = R(kSqrtTwoOverPi) * (x + R(kCubic) * ((x * x) * x));
    return x * eagerx::sigmoid(inner + inner);  // (1 + tanh(y)) / 2 without its cancellation
  } else if constexpr (A == Activation::softplus) {
    return softplus(x);
  } else if constexpr (A == Activation::sigmoid) {
    return eagerx::sigmoid(x);
  } else {
    return x;
  }
}

}  // namespace policy
}  // namespace eagerx
