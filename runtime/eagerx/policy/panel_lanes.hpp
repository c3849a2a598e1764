// Panels on SIMD machines: one output a lane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <eagerx/policy/activation.hpp>
#include <eagerx/policy/float_lanes.hpp>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::policy {

/// Registers of sums at a time: as many as hide the latency of the additions. They need not fit
/// into the machine's registers together with the sums of a group, which are used more often.
inline constexpr std::size_t kRegistersAtATime = 8;

/// Keeps operations on `v` in the order of the source: compilers would finish one sum before they
/// begin the next, and wait for each addition.
template <class Vector>
[[gnu::always_inline]] inline void in_order([[maybe_unused]] Vector& v) {
#if defined(__AVX512VL__)
  asm volatile("" : "+v"(v));
#elif defined(__SSE2__)
  asm volatile("" : "+x"(v));
#elif defined(__aarch64__)
  asm volatile("" : "+w"(v));
#endif
}

/// `Panels` panels of `Width` outputs at a time.
template <std::size_t In, std::size_t Width, std::size_t Panels>
class PanelBlock {
 public:
  /// y = sums, or relu of them.
  template <Activation A>
  static void run(const float* w, const float* b, const float* x, float* y) {
    Vector sum[kVectors];
#pragma GCC unroll 8
    for (std::size_t v = 0; v < kVectors; ++v) sum[v] = load<Vector>(b + v * kWidth);
    for (std::size_t j = 0; j + kGroup <= In; j += kGroup) add_group<kGroup>(w, x, j, sum);
    if constexpr (In % kGroup > 0) add_group<In % kGroup>(w, x, In - In % kGroup, sum);
#pragma GCC unroll 8
    for (std::size_t v = 0; v < kVectors; ++v) {
      if constexpr (A == Activation::relu) sum[v] = larger(Vector{}, sum[v]);
      std::memcpy(y + v * kWidth, &sum[v], sizeof sum[v]);
    }
  }

 private:
  static constexpr std::size_t kWidth = std::min(Width, kLanes);
  static constexpr std::size_t kPerPanel = Width / kWidth;
  static constexpr std::size_t kVectors = Panels * kPerPanel;
  using Vector = FloatVector<kWidth>;

  /// Weights of input `j` in vector `v`.
  [[gnu::always_inline]] static Vector row(const float* w, std::size_t j, std::size_t v) {
    return load<Vector>(w + ((v / kPerPanel) * In + j) * Width + (v % kPerPanel) * kWidth);
  }

  /// Adds the products of the inputs `first`, …, `first + Rows - 1` to `sum`.
  template <std::size_t Rows>
  [[gnu::always_inline]] static void add_group(const float* w, const float* x, std::size_t first,
                                               Vector (&sum)[kVectors]) {
    Vector part[kVectors];
#pragma GCC unroll 4
    for (std::size_t j = 0; j + 2 <= Rows; j += 2) {
      const Vector input = x[first + j] - Vector{};
      const Vector next = x[first + j + 1] - Vector{};
#pragma GCC unroll 8
      for (std::size_t v = 0; v < kVectors; ++v) {
        const Vector product = row(w, first + j, v) * input;
        part[v] = j == 0 ? product : part[v] + product;
        in_order(part[v]);
        part[v] = part[v] + row(w, first + j + 1, v) * next;
        in_order(part[v]);
      }
    }
    if constexpr (Rows % 2 == 1) {
      const Vector input = x[first + Rows - 1] - Vector{};
#pragma GCC unroll 8
      for (std::size_t v = 0; v < kVectors; ++v) {
        const Vector product = row(w, first + Rows - 1, v) * input;
        part[v] = Rows == 1 ? product : part[v] + product;
        in_order(part[v]);
      }
    }
#pragma GCC unroll 8
    for (std::size_t v = 0; v < kVectors; ++v) {
      sum[v] = sum[v] + part[v];
      in_order(sum[v]);
    }
  }
};

/// The one output of a layer with `Groups` whole groups: products side by side, then the sums of
/// all groups side by side, which needs the products turned.
template <std::size_t Groups>
[[gnu::always_inline]] inline float groups_of_output(float sum, const float* w, const float* x) {
  using Vector = FloatVector<kGroup>;
  Vector row[kGroup];
#pragma GCC unroll 8
  for (std::size_t g = 0; g < kGroup; ++g) {
    row[g] = g < Groups ? load<Vector>(w + g * kGroup) * load<Vector>(x + g * kGroup) : Vector{};
  }
  Vector pairs[kGroup];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < kGroup; i += 2) {
    pairs[i] = __builtin_shufflevector(row[i], row[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    pairs[i + 1] = __builtin_shufflevector(row[i], row[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  Vector fours[kGroup];
#pragma GCC unroll 2
  for (std::size_t i = 0; i < kGroup; i += 4) {
#pragma GCC unroll 2
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector a = pairs[i + k];
      const Vector b = pairs[i + k + 2];
      fours[i + 2 * k] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
      fours[i + 2 * k + 1] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  Vector part = __builtin_shufflevector(fours[0], fours[4], 0, 1, 2, 3, 8, 9, 10, 11);
#pragma GCC unroll 4
  for (std::size_t j = 1; j < 4; ++j) {
    part = part + __builtin_shufflevector(fours[j], fours[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
  }
#pragma GCC unroll 4
  for (std::size_t j = 0; j < 4; ++j) {
    part = part + __builtin_shufflevector(fours[j], fours[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
#pragma GCC unroll 8
  for (std::size_t g = 0; g < Groups; ++g) sum = sum + part[g];
  return sum;
}

template <std::size_t In, std::size_t Width>
inline void tail_panel(const float* w, const float* b, const float* x, float* y) {
  if constexpr (Width == 1 && In >= kGroup && kLanes == kGroup) {
    constexpr std::size_t kAtATime = kGroup * kGroup;
    constexpr std::size_t kGroups = In % kAtATime / kGroup;
    constexpr std::size_t kRest = In % kGroup;
    float sum = b[0];
    for (std::size_t j = 0; j + kAtATime <= In; j += kAtATime) {
      sum = groups_of_output<kGroup>(sum, w + j, x + j);
    }
    constexpr std::size_t kDone = In - In % kAtATime;
    if constexpr (kGroups > 0) sum = groups_of_output<kGroups>(sum, w + kDone, x + kDone);
    if constexpr (kRest > 0) {
      float part = w[In - kRest] * x[In - kRest];
      for (std::size_t k = In - kRest + 1; k < In; ++k) part = part + w[k] * x[k];
      sum = sum + part;
    }
    y[0] = sum;
  } else {
    PanelBlock<In, Width, 1>::template run<Activation::identity>(w, b, x, y);
  }
}

template <std::size_t In, std::size_t Panels, Activation A>
inline void panels_of_layer(const float* w, const float* b, const float* x, float* y) {
  constexpr std::size_t kAtATime = kRegistersAtATime * kLanes / kPanel;
  constexpr std::size_t kRest = Panels % kAtATime;
  constexpr std::size_t kOutputs = kAtATime * kPanel;
  for (std::size_t block = 0; block < Panels / kAtATime; ++block) {
    const std::size_t k = block * kOutputs;
    PanelBlock<In, kPanel, kAtATime>::template run<A>(w + k * In, b + k, x, y + k);
  }
  constexpr std::size_t kDone = (Panels - kRest) * kPanel;
  if constexpr (kRest > 0) {
    PanelBlock<In, kPanel, kRest>::template run<A>(w + kDone * In, b + kDone, x, y + kDone);
  }
}

// A function that stays one and takes in all that it calls, so that numbers stay in registers.
#if defined(__clang__)
#define EAGERX_POLICY_ALONE gnu::noinline, gnu::flatten
#else
#define EAGERX_POLICY_ALONE gnu::noipa, gnu::flatten
#endif

/// y = A(y), for whole registers. Layers of one size share it.
template <Activation A, std::size_t Out>
[[EAGERX_POLICY_ALONE]] void activate_numbers(float* y, float slope) {
  constexpr std::size_t kAtATime = kRegistersAtATime;
  using Many = FloatLanes<kLanes, kAtATime>;
  using One = FloatLanes<kLanes, 1>;
  std::size_t k = 0;
  for (; k + kAtATime * kLanes <= Out; k += kAtATime * kLanes) {
    activated<A>(Many::load(y + k), slope).store(y + k);
  }
  for (; k + kLanes <= Out; k += kLanes) activated<A>(One::load(y + k), slope).store(y + k);
}

template <Activation A, std::size_t Out>
inline void activate_all(float* y, float slope) {
  if constexpr (A == Activation::identity) return;
  constexpr std::size_t kRest = Out % kLanes;
  if constexpr (Out >= kLanes) activate_numbers<A, Out - kRest>(y, slope);
  if constexpr (kRest > 0) {
    FloatLanes<kLanes, 1> rest(0.0F);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kRest; ++i) rest.v[0][i] = y[Out - kRest + i];
    rest = activated<A>(rest, slope);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kRest; ++i) y[Out - kRest + i] = rest.v[0][i];
  }
}

template <Activation A, std::size_t In, std::size_t Panels>
inline void full_panels(const float* w, const float* b, const float* x, float* y, float slope) {
  if constexpr (A == Activation::relu) {
    panels_of_layer<In, Panels, A>(w, b, x, y);
  } else if constexpr (Panels > 0) {
    panels_of_layer<In, Panels, Activation::identity>(w, b, x, y);
    activate_all<A, Panels * kPanel>(y, slope);
  }
}

}  // namespace eagerx::policy
