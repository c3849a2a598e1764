// The sums of a layer over lanes, one of which is one environment or one sample of a training: the
// order of eagerx/policy.hpp, written down once for both. Lanes do not mix. Sizes are constants of
// programs (eagerx/policy/packs.hpp) and numbers of the trainer (targets/environments/train).
#pragma once

#include <algorithm>
#include <cstddef>
#include <eagerx/pack.hpp>
#include <eagerx/policy/float_lanes.hpp>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::policy {

#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr bool kManyRegisters = true;  // 32
#else
inline constexpr bool kManyRegisters = false;  // 16
#endif

/// Outputs and registers of lanes at a time: what is summed of a group stays in registers, with the
/// input. Of 16 registers none is left for the sums, which stay in memory. Measured with g++ 12.
inline constexpr std::size_t kOutputsAtATime = kManyRegisters ? 8 : 4;
inline constexpr std::size_t kLaneRegisters = kManyRegisters ? 1 : 2;

/// Where weights are: that of input j for output k is w[j * step + k * output_step]. Each size is a
/// std::size_t or a std::integral_constant.
template <class Inputs, class Step, class OutputStep>
struct LaneWeights {
  const float* w;
  [[no_unique_address]] Inputs inputs;
  [[no_unique_address]] Step step;
  [[no_unique_address]] OutputStep output_step;

  static constexpr bool kIsConstant = requires { Inputs::value; };
  /// If so.
  static constexpr std::size_t kInputs = [] {
    if constexpr (kIsConstant) return std::size_t{Inputs::value};
    return std::size_t{0};
  }();
};

/// Some outputs of one layer, none of which is alone in its panel. Inputs are numbers of all lanes,
/// one after the other in memory.
template <std::size_t Outputs, class Real>
class LaneOutputs {
  using Vector = typename Real::Vector;
  static constexpr std::size_t kAtATime = std::min(kLaneRegisters, Real::kCount);
  static constexpr std::size_t kLength = Real::kCount * Real::kWidth;  // of an input

 public:
  /// y [Outputs] = W x + b, of x [inputs][lanes].
  template <class Weights>
  static void run(const Weights weights, const float* b, const float* x, Real* y) {
    for (std::size_t k = 0; k < Outputs; ++k) y[k] = Real(b[k]);
    for (std::size_t first = 0; first < Real::kCount; first += kAtATime) {
      const auto in_memory = [&](auto k, auto i) -> Vector& { return y[k].v[first + i]; };
      Vector sums[Outputs][kAtATime];
      const auto sum = [&](auto k, auto i) -> Vector& {
        if constexpr (kManyRegisters) return sums[k][i];
        if constexpr (!kManyRegisters) return in_memory(k, i);
      };
      if constexpr (kManyRegisters) each([&](auto k, auto i) { sum(k, i) = in_memory(k, i); });
      add_all(weights, x + first * Real::kWidth, sum);
      if constexpr (kManyRegisters) each([&](auto k, auto i) { in_memory(k, i) = sum(k, i); });
    }
  }

 private:
  using Parts = Vector[Outputs][kAtATime];

  template <class F>
  [[gnu::always_inline]] static void each(F&& f) {
    detail::unrolled<Outputs>([&](auto k) __attribute__((always_inline)) {
      detail::unrolled<kAtATime>([&](auto i) __attribute__((always_inline)) { f(k, i); });
    });
  }
  /// Adds the products of all inputs to `sum`, in the registers from x on.
  template <class Weights, class Sum>
  [[gnu::always_inline]] static void add_all(const Weights& weights, const float* x,
                                             const Sum& sum) {
    std::size_t j = 0;
    for (; j + kGroup <= weights.inputs; j += kGroup)
      add<kGroup>(weights, weights.w + j * weights.step, x + j * kLength, sum);
    const float* const w = weights.w + j * weights.step;
    if constexpr (Weights::kIsConstant) {
      constexpr std::size_t kRest = Weights::kInputs % kGroup;
      if constexpr (kRest > 0) add<kRest>(weights, w, x + j * kLength, sum);
    } else if (j < weights.inputs) {
      add_rest(weights, w, x + j * kLength, weights.inputs - j, sum);
    }
  }
  template <std::size_t Rows, class Weights, class Sum>
  [[gnu::always_inline]] static void add(const Weights& weights, const float* w, const float* x,
                                         const Sum& sum) {
    Parts part;
    detail::unrolled<Rows>([&](auto row) {
      add_row<row == 0>(weights, w + row * weights.step, x + row * kLength, part);
    });
    each([&](auto k, auto i) { sum(k, i) = sum(k, i) + part[k][i]; });
  }
  /// Of the last inputs, fewer than a group.
  template <class Weights, class Sum>
  [[gnu::always_inline]] static void add_rest(const Weights& weights, const float* w,
                                              const float* x, std::size_t rows, const Sum& sum) {
    Parts part;
    add_row<true>(weights, w, x, part);
    for (std::size_t row = 1; row < rows; ++row)
      add_row<false>(weights, w + row * weights.step, x + row * kLength, part);
    each([&](auto k, auto i) { sum(k, i) = sum(k, i) + part[k][i]; });
  }
  template <bool IsFirst, class Weights>
  [[gnu::always_inline]] static void add_row(const Weights& weights, const float* w, const float* x,
                                             Parts& part) {
    Vector input[kAtATime];
    detail::unrolled<kAtATime>([&](auto i) {
      input[i] = load<Vector>(x + i * Real::kWidth);
      in_order(input[i]);
    });
    detail::unrolled<Outputs>([&](auto k) {
      const Vector weight = w[k * weights.output_step] - Vector{};
      detail::unrolled<kAtATime>([&](auto i) {
        const Vector product = weight * input[i];
        part[k][i] = IsFirst ? product : part[k][i] + product;
        in_order(part[k][i]);
      });
    });
  }
};

/// The output that is alone in its panel: what is left of its kChains sums once they are added in
/// halves until `Left` of them are there. Depth first, so that few are there at a time.
template <class Real>
class LaneOutputAlone {
 public:
  /// `inputs`: as of LaneWeights. x [inputs][lanes].
  template <class Inputs>
  static Real run(const Inputs inputs, const float* w, float b, const float* x) {
    return Real(b) + left<1>(inputs, w, x, 0);
  }

 private:
  static constexpr std::size_t kLength = Real::kCount * Real::kWidth;

  template <std::size_t Left, class Inputs>
  static Real left(const Inputs inputs, const float* w, const float* x, std::size_t k) {
    if constexpr (Left == kChains) {
      return chain(inputs, w, x, k);
    } else {
      return left<2 * Left>(inputs, w, x, k) + left<2 * Left>(inputs, w, x, k + Left);
    }
  }
  template <class Inputs>
  static Real chain(const Inputs inputs, const float* w, const float* x, std::size_t k) {
    Real sum(0.0F);
    if (k < inputs) sum = Real(w[k]) * Real::load(x + k * kLength);
    for (std::size_t j = k + kChains; j < inputs; j += kChains)
      sum = sum + Real(w[j]) * Real::load(x + j * kLength);
    // A last group of fewer numbers is full of zeros.
    const std::size_t rest = inputs % kChains;
    if (inputs > kChains && rest > 0 && k >= rest) sum = sum + Real(0.0F);
    return sum;
  }
};

}  // namespace eagerx::policy
