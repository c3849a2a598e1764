// The kernels over registers of `Width` floats. Each instruction set compiles them in its own file.
// Everything here depends on Width, so that the linker cannot merge functions of different files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/policy/activation.hpp>
#include <eagerx/policy/float_lanes.hpp>
#include <eagerx/policy/lane_sums.hpp>
#include <type_traits>

#include "targets/environments/train/kernels.hpp"
#include "targets/environments/train/recurrent/kernels_of.hpp"

namespace eagerx::train {

template <std::size_t Width>
struct KernelsOf {
  static constexpr std::size_t kRegisters = kLanes / Width;  // a SIMD vector
  using Vector = policy::FloatLanes<Width, kRegisters>;
  static constexpr std::size_t kRows = 8 / kRegisters;  // sums at a time: eight registers

  [[gnu::always_inline]] static Vector load(const Simd& x) { return Vector::load(x.lane); }
  [[gnu::always_inline]] static void store(const Vector& x, Simd& to) { x.store(to.lane); }

  /// Outputs j … j + Outputs - 1, none of which is alone in its panel.
  template <std::size_t Outputs>
  static void dense_outputs(DenseSizes sizes, const float* weights, const float* bias,
                            const Simd* x, Simd* y, std::size_t j) {
    using One = std::integral_constant<std::size_t, 1>;
    const policy::LaneWeights<std::size_t, One, std::size_t> part{
        weights + j * sizes.inputs, sizes.inputs, {}, sizes.inputs};
    policy::LaneOutputs<Outputs, Vector>::run(part, bias + j, x->lane, y[j].lane);
  }
  /// Uses the sums of programs (eagerx/policy/lane_sums.hpp), so that the trained network is the
  /// deployed one.
  static void dense(DenseSizes sizes, const float* weights, const float* bias, const Simd* x,
                    Simd* y) {
    constexpr std::size_t kOutputs = policy::kOutputsAtATime;
    const bool one_is_alone = policy::alone_in_panel(sizes.outputs - 1, sizes.outputs);
    const std::size_t in_panels = sizes.outputs - (one_is_alone ? 1 : 0);
    std::size_t j = 0;
    for (; j + kOutputs <= in_panels; j += kOutputs)
      dense_outputs<kOutputs>(sizes, weights, bias, x, y, j);
    for (; j < in_panels; ++j) dense_outputs<1>(sizes, weights, bias, x, y, j);
    if (one_is_alone)
      store(policy::LaneOutputAlone<Vector>::run(sizes.inputs, weights + j * sizes.inputs, bias[j],
                                                 x->lane),
            y[j]);
  }

  template <std::size_t Rows>
  [[gnu::always_inline]] static void transposed_rows(DenseSizes sizes, const float* weights,
                                                     const Simd* dy, Simd* dx) {
    Vector sum[Rows];
    for (std::size_t r = 0; r < Rows; ++r) sum[r] = Vector(0.0F);
    for (std::size_t j = 0; j < sizes.outputs; ++j) {
      const Vector dyj = load(dy[j]);
      for (std::size_t r = 0; r < Rows; ++r) {
        sum[r] = sum[r] + Vector(weights[j * sizes.inputs + r]) * dyj;
      }
    }
    for (std::size_t r = 0; r < Rows; ++r) store(sum[r], dx[r]);
  }
  static void dense_transposed(DenseSizes sizes, const float* weights, const Simd* dy, Simd* dx) {
    std::size_t i = 0;
    for (; i + kRows <= sizes.inputs; i += kRows) {
      transposed_rows<kRows>(sizes, weights + i, dy, dx + i);
    }
    for (; i < sizes.inputs; ++i) transposed_rows<1>(sizes, weights + i, dy, dx + i);
  }

  /// Rows for columns, by shuffles of whole registers where a SIMD vector is one.
  static void transpose(Simd (&x)[kLanes]) {
    if constexpr (Width == kLanes && kHasShuffles) {
      using Whole [[gnu::vector_size(sizeof(Simd))]] = float;
      Whole row[kLanes];
      for (std::size_t i = 0; i < kLanes; ++i) std::memcpy(&row[i], &x[i], sizeof(Simd));
      detail::unrolled<kStages>([&](auto stage) {
        constexpr std::size_t kApart = kLanes >> (stage + 1);
        for (std::size_t i = 0; i < kLanes; ++i) {
          if ((i & kApart) != 0) continue;
          const Whole upper = row[i], lower = row[i + kApart];
          row[i] = __builtin_shuffle(upper, lower, kept<kApart>(false));
          row[i + kApart] = __builtin_shuffle(upper, lower, kept<kApart>(true));
        }
      });
      for (std::size_t i = 0; i < kLanes; ++i) std::memcpy(&x[i], &row[i], sizeof(Simd));
    } else {
      for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t l = 0; l < i; ++l) {
          const float other = x[i].lane[l];
          x[i].lane[l] = x[l].lane[i];
          x[l].lane[i] = other;
        }
      }
    }
  }
#ifdef __clang__  // which builds the fuzzers, and knows no __builtin_shuffle
  static constexpr bool kHasShuffles = false;
#else
  static constexpr bool kHasShuffles = true;
#endif
  static constexpr std::size_t kStages = 4;
  using Places [[gnu::vector_size(sizeof(Simd))]] = std::int32_t;
  /// Of two rows so far apart, which lanes the first one has afterwards, or the second one.
  template <std::size_t Apart>
  static constexpr Places kept(bool second) {
    Places places{};
    for (std::size_t l = 0; l < kLanes; ++l) {
      const bool of_lower = (l & Apart) != 0;
      const std::size_t lane = of_lower == second ? l : second ? l + Apart : l - Apart;
      places[l] = static_cast<std::int32_t>(lane + (of_lower ? kLanes : 0));
    }
    return places;
  }

  /// Sixteen inputs of sixteen samples, from a SIMD vector for each input to one for each sample.
  /// Inputs that are not there are 0.
  static void by_samples(const Simd* x, std::size_t inputs, Simd* by_sample) {
    Simd simds[kLanes];
    for (std::size_t i = 0; i < kLanes; ++i)
      store(i < inputs ? load(x[i]) : Vector(0.0F), simds[i]);
    transpose(simds);
    for (std::size_t l = 0; l < kLanes; ++l) store(load(simds[l]), by_sample[l]);
  }

  /// db += Σ dy of up to sixteen outputs: of each the lanes, halves onto halves until one is left.
  static void bias_gradient(const Simd* dy, std::size_t outputs, std::size_t tiles,
                            std::size_t stride, float* db) {
    Simd sums[kLanes];
    for (std::size_t j = 0; j < kLanes; ++j) {
      Vector sum(0.0F);
      for (std::size_t t = 0; t < tiles && j < outputs; ++t) sum = sum + load(dy[t * stride + j]);
      store(sum, sums[j]);
    }
    transpose(sums);
    for (std::size_t half = kLanes / 2; half > 0; half /= 2) {
      for (std::size_t l = 0; l < half; ++l) store(load(sums[l]) + load(sums[l + half]), sums[l]);
    }
    for (std::size_t j = 0; j < outputs; ++j) db[j] += sums[0].lane[j];
  }

  /// Rows j… of dW, sixteen inputs wide. Lanes are inputs here, so that nothing is left to be
  /// summed over lanes.
  template <std::size_t Outputs>
  [[gnu::always_inline]] static void gradient_rows(std::size_t inputs, std::size_t width,
                                                   const Simd* by_sample, const Simd* dy,
                                                   std::size_t tiles, std::size_t stride,
                                                   float* dw) {
    Vector sum[Outputs];
    for (Vector& one : sum) one = Vector(0.0F);
    for (std::size_t t = 0; t < tiles; ++t) {
      for (std::size_t l = 0; l < kLanes; ++l) {
        const Vector x = load(by_sample[t * kLanes + l]);
        for (std::size_t j = 0; j < Outputs; ++j) {
          sum[j] = sum[j] + Vector(dy[t * stride + j].lane[l]) * x;
        }
      }
    }
    for (std::size_t j = 0; j < Outputs; ++j) {
      if (width == kLanes) {
        (Vector::load(dw + j * inputs) + sum[j]).store(dw + j * inputs);
        continue;
      }
      Simd row;
      store(sum[j], row);
      for (std::size_t i = 0; i < width; ++i) dw[j * inputs + i] += row.lane[i];
    }
  }
  static void dense_gradient(DenseSizes sizes, const Simd* x, const Simd* dy, std::size_t tiles,
                             std::size_t stride, Simd* scratch, float* dw, float* db) {
    for (std::size_t i = 0; i < sizes.inputs; i += kLanes) {
      const std::size_t width = sizes.inputs - i < kLanes ? sizes.inputs - i : kLanes;
      for (std::size_t t = 0; t < tiles; ++t) {
        by_samples(x + t * stride + i, width, scratch + t * kLanes);
      }
      std::size_t j = 0;
      for (; j + kRows <= sizes.outputs; j += kRows) {
        gradient_rows<kRows>(sizes.inputs, width, scratch, dy + j, tiles, stride,
                             dw + j * sizes.inputs + i);
      }
      for (; j < sizes.outputs; ++j) {
        gradient_rows<1>(sizes.inputs, width, scratch, dy + j, tiles, stride,
                         dw + j * sizes.inputs + i);
      }
    }
    for (std::size_t j = 0; j < sizes.outputs; j += kLanes) {
      const std::size_t count = sizes.outputs - j < kLanes ? sizes.outputs - j : kLanes;
      bias_gradient(dy + j, count, tiles, stride, db + j);
    }
  }

  template <Activation A>
  static void activate(Simd* x, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) store(policy::activated<A>(load(x[i]), 0.0F), x[i]);
  }
  static void tanh_slope(const Simd* y, Simd* dx, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vector yi = load(y[i]);
      store(load(dx[i]) * (Vector(1.0F) - yi * yi), dx[i]);
    }
  }

  static void relu_slope(const Simd* y, Simd* dx, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t l = 0; l < kLanes; ++l) {
        dx[i].lane[l] = y[i].lane[l] > 0.0F ? dx[i].lane[l] : 0.0F;
      }
    }
  }

  static void add(const float* x, float* to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to[i] += x[i];
  }
  static void approach(float share, const float* x, float* to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to[i] += share * (x[i] - to[i]);
  }

  static void adam(float* weights, const float* gradient, float* mean, float* square,
                   std::size_t count, AdamStep step) {
    for (std::size_t i = 0; i < count; ++i) {
      const float g = gradient[i] * step.gradient_scale;
      mean[i] = 0.9F * mean[i] + 0.1F * g;
      square[i] = 0.999F * square[i] + 0.001F * (g * g);
      const float root = __builtin_sqrtf(square[i] / step.square_correction);
      weights[i] -= step.step_size * (mean[i] / step.mean_correction) / (root + 1e-8F);
    }
  }

  static constexpr Kernels table(const char* name) {
    using OfMemory = MemoryKernelsOf<Width>;
    return {name,
            dense,
            dense_transposed,
            dense_gradient,
            activate<Activation::tanh>,
            tanh_slope,
            activate<Activation::relu>,
            relu_slope,
            OfMemory::gru,
            OfMemory::lstm,
            OfMemory::gru_slopes,
            OfMemory::lstm_slopes,
            OfMemory::carry,
            add,
            approach,
            adam};
  }
};

}  // namespace eagerx::train
