// Adaptive steps over SIMD vectors: each lane takes its own steps, as if it were integrated alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/simd.hpp>
#include <limits>
#include <models/engines/ode_engine/adaptive.hpp>
#include <type_traits>

namespace eagerx::models {

/// The variables of integrate(), for each lane.
template <class Real, std::size_t N>
struct LaneSteps {
  Array<Real, N> x;
  Real step_s;       // to try next
  Real remaining_s;  // of the span
  Real most_growth;
  Real next_step_s;  // to continue with after the span

  LaneSteps() = default;
  LaneSteps(const Array<Real, N>& begin, LaneOf<Real> span_s, const Real& first_step_s,
            const SettingsFor<Real>& settings)
      : x(begin), remaining_s(span_s), next_step_s(first_step_s) {
    using Lane = LaneOf<Real>;
    const Real step(select(first_step_s > Real(Lane(0)), first_step_s, Real(span_s * Lane(0.01))));
    step_s = limited(step, shortest(span_s, settings), settings);
    most_growth = Real(std::numeric_limits<Lane>::max());
  }

  static Real shortest(LaneOf<Real> span_s, const SettingsFor<Real>& settings) {
    const auto resolution_s = span_s * std::numeric_limits<LaneOf<Real>>::epsilon();
    return Real(eagerx::max(settings.shortest_s, resolution_s));
  }
  static Real limited(const Real& step_s, const Real& shortest_s,
                      const SettingsFor<Real>& settings) {
    return eagerx::min(eagerx::max(step_s, shortest_s), Real(settings.longest_s));
  }
};

/// Progress of the lanes after the same number of tries.
template <class Real>
struct LaneProgress {
  TruthOf<Real> continues = true;
  TruthOf<Real> failed = false;  // whose outcome is not `done`
  std::uint32_t tries = 0;
};

/// Number of lanes in which the mask holds.
template <std::size_t Bytes, std::size_t N>
[[gnu::always_inline]] inline std::size_t count(const Mask<Bytes, N>& mask) {
  typename Mask<Bytes, N>::Vector sum = mask.v[0];
  for (std::size_t i = 1; i < Mask<Bytes, N>::kCount; ++i) sum += mask.v[i];
  typename Mask<Bytes, N>::Lane total = 0;
  for (std::size_t i = 0; i < Mask<Bytes, N>::kWidth; ++i) total -= sum[i];
  return static_cast<std::size_t>(total);
}

/// integrate() for SIMD vectors, line by line; lanes that are done wait. Ends when no more than
/// `few_lanes` continue: a narrower SIMD vector is then the faster one. A method has besides
///   void go_on(step, x, taken);         // the step was taken in these lanes: now they are at x
template <class Method, class Real, std::size_t N>
[[gnu::always_inline]] inline void take_steps(Method& method, LaneSteps<Real, N>& at,
                                              LaneProgress<Real>& progress, LaneOf<Real> span_s,
                                              const SettingsFor<Real>& settings,
                                              std::size_t few_lanes) {
  using Lane = LaneOf<Real>;
  using Steps = LaneSteps<Real, N>;
  const Real stretch(Lane(1.01));
  const Real one(Lane(1));
  const Real any_growth(std::numeric_limits<Lane>::max());
  const Real shortest_s = Steps::shortest(span_s, settings);
  method.begin(at.x);
  while (progress.tries < settings.max_tries) {
    const auto last = at.remaining_s <= eagerx::min(at.step_s * stretch, Real(settings.longest_s));
    const Real tried_s = select(last, at.remaining_s, at.step_s);
    const auto step = method.step(at.x, tried_s);
    const Real error = error_squared(step.error, at.x, step.end, settings);
    const Real factor = step_factor(error, Method::kErrorOrder);
    const Real proposed_s = tried_s * eagerx::min(factor, at.most_growth);
    const auto good = error <= one;
    const auto taken = progress.continues && good;
    for (std::size_t i = 0; i < N; ++i) at.x[i] = select(taken, step.end[i], at.x[i]);
    at.remaining_s = select(taken, at.remaining_s - tried_s, at.remaining_s);
    at.most_growth = select(good, any_growth, one);
    const auto arrived = taken && last;
    const auto stuck = progress.continues && !good && tried_s <= shortest_s;
    const Real after_s = Steps::limited(eagerx::max(at.step_s, proposed_s), shortest_s, settings);
    at.next_step_s = select(arrived, after_s, select(stuck, Real(Lane(0)), at.next_step_s));
    at.step_s = Steps::limited(proposed_s, shortest_s, settings);
    progress.failed = progress.failed || stuck;
    progress.continues = progress.continues && !arrived && !stuck;
    ++progress.tries;
    if (count(progress.continues) <= few_lanes) return;
    method.go_on(step, at.x, taken);
  }
  at.next_step_s = select(progress.continues, at.step_s, at.next_step_s);
  progress.failed = progress.failed || progress.continues;
  progress.continues = false;
}

/// Copies some lanes of a SIMD vector to a narrower one, and back. Both consist of the same number
/// of SIMD vectors only.
template <std::size_t N, std::size_t Width, class Wide, class Narrow>
inline void gather(const Wide& wide, const std::size_t (&lanes)[Width], Narrow& narrow) {
  static_assert(sizeof(Wide) * Width == sizeof(Narrow) * N);
  constexpr std::size_t kWords = sizeof(Narrow) / (4 * Width);
  const auto* const from = reinterpret_cast<const unsigned char*>(&wide);
  std::uint32_t words[kWords][Width];
  for (std::size_t i = 0; i < kWords; ++i) {
    for (std::size_t k = 0; k < Width; ++k)
      std::memcpy(&words[i][k], from + 4 * (i * N + lanes[k]), 4);
  }
  std::memcpy(static_cast<void*>(&narrow), words, sizeof words);
}
template <std::size_t N, std::size_t Width, class Wide, class Narrow>
inline void scatter(const Narrow& narrow, const std::size_t (&lanes)[Width], Wide& wide) {
  constexpr std::size_t kWords = sizeof(Narrow) / (4 * Width);
  auto* const to = reinterpret_cast<unsigned char*>(&wide);
  std::uint32_t words[kWords][Width];
  std::memcpy(words, &narrow, sizeof words);
  for (std::size_t i = 0; i < kWords; ++i) {
    for (std::size_t k = 0; k < Width; ++k)
      std::memcpy(to + 4 * (i * N + lanes[k]), &words[i][k], 4);
  }
}

/// The lanes that continue, one register of them after the other. f(lanes, narrow) makes the steps
/// of `narrow`, which has the lanes `lanes` of the SIMD vector, and returns those that failed.
template <class Narrow, class Real, std::size_t N, class F>
inline void finish_few(LaneSteps<Real, N>& at, LaneProgress<Real>& progress, const F& f) {
  constexpr auto kWide = static_cast<std::size_t>(lanes<Real>);
  constexpr auto kWidth = static_cast<std::size_t>(lanes<Narrow>);
  std::size_t waiting[kWide + kWidth];
  std::size_t count = 0;
  for (std::size_t k = 0; k < kWide; ++k) {
    waiting[count] = k;
    count += lane(progress.continues, static_cast<int>(k)) ? 1U : 0U;
  }
  for (std::size_t k = 0; k < kWidth && count > 0; ++k) waiting[count + k] = waiting[count - 1];
  for (std::size_t first = 0; first < count; first += kWidth) {
    std::size_t chosen[kWidth];  // the last one again where there are no more
    std::memcpy(chosen, waiting + first, sizeof chosen);
    LaneSteps<Narrow, N> narrow;
    gather<kWide>(at, chosen, narrow);
    const TruthOf<Narrow> failed = f(chosen, narrow);
    scatter<kWide>(narrow, chosen, at);
    for (std::size_t k = 0; k < kWidth; ++k)
      set_lane(progress.failed, static_cast<int>(chosen[k]), lane(failed, static_cast<int>(k)));
  }
  progress.continues = false;
}

}  // namespace eagerx::models
