// Times that stay exact in programs that run for years: whole seconds, and phases modulo a turn.
#pragma once

#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/rate.hpp>

namespace eagerx {

/// A time since the reset: whole seconds, and the rest in [0, 1) s.
template <class Lane>
struct ExactTime {
  std::int64_t whole_s;
  Lane rest_s;
};

/// The time of tick `n` of `Rate`; the rest is rounded once, for any `n`.
template <class Rate, class Lane>
constexpr ExactTime<Lane> exact_time(Seq n) {
  constexpr Seq kNum = Rate::num;
  const Seq parts = n * Rate::den;  // of 1/kNum s
  return {static_cast<std::int64_t>(parts / kNum),
          static_cast<Lane>(parts % kNum) / static_cast<Lane>(kNum)};
}

/// Converts a time of a configuration, which is not negative.
template <class Lane>
constexpr ExactTime<Lane> exact_seconds(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  return {whole, static_cast<Lane>(seconds - static_cast<double>(whole))};
}

/// The time as one number, with the precision of its type: to compare and multiply, not for phases.
template <class Lane>
constexpr Lane seconds_of(const ExactTime<Lane>& t) {
  return static_cast<Lane>(t.whole_s) + t.rest_s;
}

/// `t` − `from` in seconds, without rounding the common part.
template <class Lane>
constexpr Lane seconds_between(const ExactTime<Lane>& from, const ExactTime<Lane>& t) {
  return static_cast<Lane>(t.whole_s - from.whole_s) + (t.rest_s - from.rest_s);
}

/// A frequency, with the turns of a second in units of 2^-64, where whole turns drop out.
template <class Lane>
struct ExactFrequency {
  Lane hz;
  std::uint64_t turns_per_second;
};
/// The fraction of `turns`, in units of 2^-64.
template <class Number>
constexpr std::uint64_t fixed_turns(Number turns) {
  constexpr auto kScale = static_cast<Number>(18446744073709551616.0);  // 2^64
  const Number fraction = turns - eagerx::floor(turns);
  // That of a tiny negative number is 1 when it is rounded.
  return fraction < Number(1) ? static_cast<std::uint64_t>(fraction * kScale) : std::uint64_t{0};
}
template <class Lane, class Number>
constexpr ExactFrequency<Lane> exact_frequency(Number hz) {
  return {static_cast<Lane>(hz), fixed_turns(hz)};
}

/// A number of units of 2^-64 as a fraction in [0, 1), rounded down.
template <class Lane>
constexpr Lane fraction_of(std::uint64_t fixed) {
  constexpr int kDigits = sizeof(Lane) == 4 ? 24 : 53;
  return static_cast<Lane>(fixed >> (64 - kDigits)) /
         static_cast<Lane>(std::uint64_t{1} << kDigits);
}

/// The fraction of frequency·t in [0, 1]: exact for whole seconds, and with the rounding errors of
/// frequency·(one second) for the rest, for any `t`.
template <class Lane>
constexpr Lane turns_of(const ExactFrequency<Lane>& frequency, const ExactTime<Lane>& t) {
  const std::uint64_t turned = frequency.turns_per_second * static_cast<std::uint64_t>(t.whole_s);
  const Lane sum = fraction_of<Lane>(turned) + frequency.hz * t.rest_s;
  return sum - eagerx::floor(sum);
}

}  // namespace eagerx
