// The sums of a layer over lanes, one of which is one environment or one sample of a training: the
// order of eagerx/policy.hpp, written down once for both. Lanes do not mix. Sizes are constants of
// programs (eagerx/policy/simd.hpp) and numbers of the trainer (targets/environments/train).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <eagerx/policy/float_lanes.hpp>
#include <eagerx/policy/panel_size.hpp>
#include <eagerx/simd.hpp>

namespace eagerx::policy {

/// Outputs and registers of lanes at a time. The partial sums of a group and the input stay in
/// registers; with 16 registers, some sums are spilled. Measured with g++ 12.
#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr std::size_t kOutputsAtATime = 8;  // 32 registers
inline constexpr std::size_t kLaneRegisters = 1;
#else
inline constexpr std::size_t kOutputsAtATime = 4;  // 16 registers
inline constexpr std::size_t kLaneRegisters = 2;
#endif

/// Layout of the weights: that of input j for output k is w[j * step + k * output_step]. Each size
/// is a std::size_t or a std::integral_constant.
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
  /// y [Outputs][lanes] = W x + b, of x [inputs][lanes].
  template <class Weights>
  static void run(const Weights weights, const float* b, const float* x, float* y) {
    for (std::size_t first = 0; first < Real::kCount; first += kAtATime) {
      Block sum;
      each([&](auto k, auto i) { sum[k][i] = b[k] - Vector{}; });
      add_all(weights, x + first * Real::kWidth, sum);
      each([&](auto k, auto i) {
        std::memcpy(y + k * kLength + (first + i) * Real::kWidth, &sum[k][i], sizeof(Vector));
      });
    }
  }

 private:
  using Block = Vector[Outputs][kAtATime];

  template <class F>
  [[gnu::always_inline]] static void each(F&& f) {
    detail::unrolled<Outputs>([&](auto k) __attribute__((always_inline)) {
      detail::unrolled<kAtATime>([&](auto i) __attribute__((always_inline)) { f(k, i); });
    });
  }

  /// Adds the products of all inputs to `sum`, in the registers from x on.
  template <class Weights>
  [[gnu::always_inline]] static void add_all(const Weights& weights, const float* x, Block& sum) {
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
  template <std::size_t Rows, class Weights>
  [[gnu::always_inline]] static void add(const Weights& weights, const float* w, const float* x,
                                         Block& sum) {
    Block part;
    detail::unrolled<Rows>([&](auto row) {
      add_row<row == 0>(weights, w + row * weights.step, x + row * kLength, part);
    });
    each([&](auto k, auto i) { sum[k][i] = sum[k][i] + part[k][i]; });
  }
  /// The last inputs, fewer than a group.
  template <class Weights>
  [[gnu::always_inline]] static void add_rest(const Weights& weights, const float* w,
                                              const float* x, std::size_t rows, Block& sum) {
    Block part;
    add_row<true>(weights, w, x, part);
    for (std::size_t row = 1; row < rows; ++row)
      add_row<false>(weights, w + row * weights.step, x + row * kLength, part);
    each([&](auto k, auto i) { sum[k][i] = sum[k][i] + part[k][i]; });
  }
  template <bool IsFirst, class Weights>
  [[gnu::always_inline]] static void add_row(const Weights& weights, const float* w, const float* x,
                                             Block& part) {
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

/// The output that is alone in its panel: adds its kChains sums in halves until `Left` of them
/// remain. Depth first, so that few are live at a time.
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
    // The last group is padded with zeros.
    const std::size_t rest = inputs % kChains;
    if (inputs > kChains && rest > 0 && k >= rest) sum = sum + Real(0.0F);
    return sum;
  }
};

}  // namespace eagerx::policy
