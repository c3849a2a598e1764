// Panels on SIMD machines: one output a lane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <eagerx/policy/activation.hpp>
#include <eagerx/policy/float_lanes.hpp>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::policy {

/// Registers of sums at a time: enough to hide the latency of the additions. They need not fit into
/// the machine's registers together with the sums of a group, which are used more often.
inline constexpr std::size_t kRegistersAtATime = 8;
/// The same for layers larger than the first cache: each panel is a separate stream from memory,
/// and the second cache delivers few streams fastest. Narrower registers wait for the sums instead.
#if defined(__AVX__)
inline constexpr std::size_t kRegistersBeyondCache = 2;
#else
inline constexpr std::size_t kRegistersBeyondCache = 6;
#endif
inline constexpr std::size_t kFirstCache = 32768;  // bytes

/// True if the weights of `Panels` panels stay in the first cache from one inference to the next.
template <std::size_t In, std::size_t Panels>
inline constexpr bool kFitsCache = In* Panels* kPanel * sizeof(float) <= kFirstCache;

/// Registers that an activation is applied to at a time: all of its numbers should be in registers.
#if defined(__AVX512VL__) || defined(__aarch64__)
inline constexpr std::size_t kActivatedAtATime = 8;
#else
inline constexpr std::size_t kActivatedAtATime = 4;
#endif

/// `Panels` panels of `Width` outputs at a time.
template <std::size_t In, std::size_t Width, std::size_t Panels>
class PanelBlock {
  static constexpr std::size_t kWidth = std::min(Width, kLanes);
  static constexpr std::size_t kPerPanel = Width / kWidth;
  static constexpr std::size_t kVectors = Panels * kPerPanel;
  using Vector = FloatVector<kWidth>;

 public:
  /// y = A(sums), for activations without a slope.
  template <Activation A>
  [[gnu::always_inline]] static void run(const float* w, const float* b, const float* x, float* y) {
    Vector sum[kVectors];
#pragma GCC unroll 8
    for (std::size_t v = 0; v < kVectors; ++v) sum[v] = load<Vector>(b + v * kWidth);
    for (std::size_t j = 0; j + kGroup <= In; j += kGroup) add_group<kGroup>(w, x, j, sum);
    if constexpr (In % kGroup > 0) add_group<In % kGroup>(w, x, In - In % kGroup, sum);
    constexpr std::size_t kAtATime = std::min(kVectors, kActivatedAtATime);
    constexpr std::size_t kRest = kVectors % kAtATime;
#pragma GCC unroll 2
    for (std::size_t v = 0; v + kAtATime <= kVectors; v += kAtATime) {
      finish<A, kAtATime>(sum + v, y + v * kWidth);
    }
    constexpr std::size_t kDone = kVectors - kRest;
    if constexpr (kRest > 0) finish<A, kRest>(sum + kDone, y + kDone * kWidth);
  }

 private:
  /// y = A(sum).
  template <Activation A, std::size_t Count>
  [[gnu::always_inline]] static void finish(const Vector* sum, float* y) {
    using Lanes = FloatLanes<kWidth, Count>;
    const auto sums = Lanes::of([&](auto v) { return sum[v]; });
    activated<A>(sums, 0.0F).store(y);
  }

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

/// The first `Count` numbers at `from`, at most a register, then zeros.
template <std::size_t Count>
[[gnu::always_inline]] inline FloatVector<kLanes> load_first([[maybe_unused]] const float* from) {
  using Vector = FloatVector<kLanes>;
  if constexpr (Count >= kLanes) {
    return load<Vector>(from);
  } else {
    Vector v = {};
#pragma GCC unroll 8
    for (std::size_t k = 0; k < Count; ++k) v[k] = from[k];
    return v;
  }
}

/// The sums of an output that is alone in its panel.
using Chains = FloatLanes<kLanes, kChains / kLanes>;

/// `Count` products, then zeros.
template <std::size_t Count, std::size_t... V>
[[gnu::always_inline]] inline Chains products(const float* w, const float* x,
                                              std::index_sequence<V...> /*registers*/) {
  constexpr auto kLeft = [](std::size_t v) { return Count - std::min(Count, v * kLanes); };
  Chains result;
  ((result.v[V] = load_first<kLeft(V)>(w + V * kLanes) * load_first<kLeft(V)>(x + V * kLanes)),
   ...);
  return result;
}

/// Adds the numbers of `v` in halves.
template <class Vector>
[[gnu::always_inline]] inline float sum_of_halves(Vector v) {
  if constexpr (sizeof(Vector) > 4 * sizeof(float)) {
    return sum_of_halves(__builtin_shufflevector(v, v, 0, 1, 2, 3) +
                         __builtin_shufflevector(v, v, 4, 5, 6, 7));
  } else {
    const Vector two = v + __builtin_shufflevector(v, v, 2, 3, 2, 3);
    return two[0] + two[1];
  }
}

template <std::size_t In>
[[gnu::always_inline]] inline float output_alone(const float* w, float b, const float* x) {
  constexpr std::make_index_sequence<kChains / kLanes> kRegisters;
  constexpr std::size_t kRest = In % kChains;
  Chains sum = products<std::min(In, kChains)>(w, x, kRegisters);
#pragma GCC unroll 4
  for (std::size_t j = kChains; j + kChains <= In; j += kChains) {
    sum = sum + products<kChains>(w + j, x + j, kRegisters);
  }
  if constexpr (In > kChains && kRest > 0) {
    sum = sum + products<kRest>(w + (In - kRest), x + (In - kRest), kRegisters);
  }
#pragma GCC unroll 4
  for (std::size_t half = kChains / kLanes / 2; half > 0; half /= 2) {
#pragma GCC unroll 4
    for (std::size_t v = 0; v < half; ++v) sum.v[v] = sum.v[v] + sum.v[v + half];
  }
  return b + sum_of_halves(sum.v[0]);
}

template <std::size_t In, std::size_t Width>
inline void tail_panel(const float* w, const float* b, const float* x, float* y) {
  if constexpr (Width == 1) {
    y[0] = output_alone<In>(w, b[0], x);
  } else {
    PanelBlock<In, Width, 1>::template run<Activation::identity>(w, b, x, y);
  }
}

template <std::size_t In, std::size_t Panels, Activation A>
[[gnu::always_inline]] inline void panels_of_layer(const float* w, const float* b, const float* x,
                                                   float* y) {
  constexpr std::size_t kRegisters =
      kFitsCache<In, Panels> ? kRegistersAtATime : kRegistersBeyondCache;
  constexpr std::size_t kAtATime = kRegisters * kLanes / kPanel;
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

// A function that is not inlined, and inlines everything it calls, so that numbers stay in
// registers.
#if defined(__clang__)
#define EAGERX_POLICY_ALONE gnu::noinline, gnu::flatten
#else
#define EAGERX_POLICY_ALONE gnu::noipa, gnu::flatten
#endif

/// y = A(y), for whole registers. Layers of one size share it.
template <Activation A, std::size_t Out>
[[EAGERX_POLICY_ALONE]] void activate_numbers(float* y, float slope) {
  constexpr std::size_t kAtATime = kActivatedAtATime;
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
[[gnu::always_inline]] inline void full_panels(const float* w, const float* b, const float* x,
                                               float* y, float slope) {
  if constexpr (A == Activation::relu || A == Activation::tanh) {
    panels_of_layer<In, Panels, A>(w, b, x, y);
  } else if constexpr (Panels > 0) {
    panels_of_layer<In, Panels, Activation::identity>(w, b, x, y);
    activate_all<A, Panels * kPanel>(y, slope);
  }
}

}  // namespace eagerx::policy
