// Test signals: step, ramp, sine, chirp, and recorded ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <models/nodes/block.hpp>
#include <models/nodes/lookup_table/lookup_table.hpp>
#include <numbers>

namespace eagerx::models {

enum class ReferenceShape : std::uint8_t { step, ramp, sine, chirp, table };

/// y = offset before `start`; then, with t the seconds since `start`:
///   step   offset + amplitude
///   ramp   offset + amplitude·min(t/duration, 1)
///   sine   offset + amplitude·sin(2π·(f·t + phase))
///   chirp  the same with f·t + (f1 − f)·t²/(2·duration), and after `duration` with f1
///   table  offset + amplitude·f(t), f between the points (times[k], values[k]) as `interpolation`
///          says, and beyond the ends the value there
/// Linear chirp: scipy.signal.chirp(method="linear", phi=-90).
template <class Io>
class Reference {
 public:
  void reset(const typename Io::States& states) {
    if constexpr (requires { states.frequency; }) frequency_.reset(states.frequency, kFrequency);
    tune(states);
  }
  void tune([[maybe_unused]] const typename Io::States& states) {
    if constexpr (requires { states.amplitude; }) amplitude_.reset(states.amplitude, kAmplitude);
    if constexpr (requires { states.offset; }) offset_.reset(states.offset, kOffset);
  }

  template <class AnyTick = Tick>
  void callback(const AnyTick& tick, const typename Io::Inputs& /*in*/, typename Io::Outputs& out) {
    const Real offset = offset_.or_constant(kOffset);
    Real y(Lane(0));
    for (int k = 0; k < lanes<Real>; ++k) {
      const ExactTime<Lane> t = since_start(tick.in_lane(k));
      const Lane middle = lane(offset, k);
      const Lane scaled = lane(amplitude_.or_constant(kAmplitude), k) * shape(t, k);
      set_lane(y, k, t.whole_s < 0 ? middle : middle + scaled);
    }
    put(out.y, 0, y);
  }

 private:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;
  using Config = typename Io::Config;
  using States = typename Io::States;
  static constexpr auto kStart = constant<Real>(Config::start);
  static constexpr auto kOffset = constant<Real>(Config::offset);
  static constexpr auto kAmplitude = constant<Real>(Config::amplitude);
  static constexpr auto kDuration = constant<Real>(Config::duration);
  static constexpr auto kFrequency = constant<Real>(Config::frequency);
  static constexpr auto kEndFrequency = constant<Real>(Config::end_frequency);
  static_assert(Config::duration > 0.0, "Reference: `duration` is above 0");

  static_assert(Config::times.size() == Config::values.size(),
                "Reference: `times` and `values` have the same number of values");
  static_assert(Config::shape != ReferenceShape::table || increases(Config::times),
                "Reference: there are at least two `times`, each after the one before");

  /// Before `start` whole_s is below 0.
  static ExactTime<Lane> since_start(Seq n) {
    constexpr auto kExactStart = exact_seconds<Lane>(Config::start);
    ExactTime<Lane> t = exact_time<typename Io::Rate, Lane>(n);
    t.whole_s -= kExactStart.whole_s;
    t.rest_s -= kExactStart.rest_s;
    if (t.rest_s < Lane(0)) return {t.whole_s - 1, t.rest_s + Lane(1)};
    return t;
  }

  Lane shape(const ExactTime<Lane>& t, [[maybe_unused]] int k) const {
    [[maybe_unused]] const Lane seconds = seconds_of(t);
    if constexpr (Config::shape == ReferenceShape::step) {
      return Lane(1);
    } else if constexpr (Config::shape == ReferenceShape::ramp) {
      return eagerx::min(seconds / kDuration, Lane(1));
    } else if constexpr (Config::shape == ReferenceShape::sine) {
      return wave(turns_of(frequency(k), t));
    } else if constexpr (Config::shape == ReferenceShape::table) {
      return between_points(t);
    } else {
      return wave(chirp(t, seconds, k));
    }
  }

  /// Of lane `k`; exact where no reset sets it.
  [[nodiscard]] ExactFrequency<Lane> frequency([[maybe_unused]] int k) const {
    if constexpr (requires(States s) { s.frequency; }) {
      return exact_frequency<Lane>(lane(frequency_.or_constant(kFrequency), k));
    } else {
      constexpr auto kExact = exact_frequency<Lane>(Config::frequency);
      return kExact;
    }
  }

  /// f·t + (f1 − f)·t²/(2·duration), and after `duration` what it is there and f1·(t − duration).
  [[nodiscard]] Lane chirp(const ExactTime<Lane>& t, Lane seconds, int k) const {
    const ExactFrequency<Lane> exact = frequency(k);
    constexpr auto kEnd = exact_frequency<Lane>(Config::end_frequency);
    if (seconds < kDuration) return turns_of(exact, t) + risen(growth(k), t);
    return turns_of(kEnd, t) + fraction_of<Lane>(behind(k));
  }
  /// c = (f1 − f)/(2·duration) in turns/s². In double: it is multiplied with the square of a time.
  [[nodiscard]] double growth([[maybe_unused]] int k) const {
    if constexpr (requires(States s) { s.frequency; }) {
      const auto f = static_cast<double>(lane(frequency_.or_constant(kFrequency), k));
      return (Config::end_frequency - f) * (0.5 / Config::duration);
    } else {
      return (Config::end_frequency - Config::frequency) * (0.5 / Config::duration);
    }
  }
  /// The fraction of f·D + (f1 − f)·D/2 − f1·D = (f − f1)·D/2, in units of 2^-64.
  [[nodiscard]] std::uint64_t behind(int k) const {
    if constexpr (requires(States s) { s.frequency; }) {
      return fixed_turns(-growth(k) * (Config::duration * Config::duration));
    } else {
      constexpr auto kBehind =
          fixed_turns((Config::frequency - Config::end_frequency) * (Config::duration / 2.0));
      return kBehind;
    }
  }
  /// c·(w + r)² = c·w² + (2·c·w + c·r)·r with w whole seconds: whole turns of c·w² drop out.
  static Lane risen(double c, const ExactTime<Lane>& t) {
    const auto whole_s = static_cast<std::uint64_t>(t.whole_s);
    const std::uint64_t of_whole = fixed_turns(c) * whole_s * whole_s;
    const auto slope = static_cast<Lane>(c);
    const Lane rest =
        (Lane(2) * slope * static_cast<Lane>(t.whole_s) + slope * t.rest_s) * t.rest_s;
    const Lane sum = fraction_of<Lane>(of_whole) + rest;
    return sum - eagerx::floor(sum);
  }

  static constexpr std::size_t kPoints = Config::times.size();
  static constexpr auto kTimes = [] {
    std::array<ExactTime<Lane>, kPoints> times{};
    for (std::size_t k = 0; k < kPoints; ++k) times[k] = exact_seconds<Lane>(Config::times[k]);
    return times;
  }();
  static constexpr auto kValues = constants<Real>(Config::values);

  static Lane between_points(const ExactTime<Lane>& t) {
    const auto is_before = [&](std::size_t k) { return seconds_between(kTimes[k], t) < Lane(0); };
    if (is_before(0)) return kValues[0];
    std::size_t before = 0;
    std::size_t after = kPoints;
    while (after - before > 1) {  // the logarithm of kPoints times
      const std::size_t middle = before + (after - before) / 2;
      (is_before(middle) ? after : before) = middle;
    }
    if (Config::interpolation == Interpolation::previous || after == kPoints)
      return kValues[before];
    const Lane share =
        seconds_between(kTimes[before], t) / seconds_between(kTimes[before], kTimes[after]);
    return kValues[before] + share * (kValues[after] - kValues[before]);
  }
  /// `turns` without whole ones first: the sine of a large number is the less exact.
  static Lane wave(Lane turns) {
    const Lane phase = turns + constant<Real>(Config::phase);
    return eagerx::sin(Lane(2) * std::numbers::pi_v<Lane> * (phase - eagerx::floor(phase)));
  }

  static constexpr bool kTunesAmplitude = requires(States s) { s.amplitude; };
  static constexpr bool kTunesOffset = requires(States s) { s.offset; };
  static constexpr bool kTunesFrequency = requires(States s) { s.frequency; };
  [[no_unique_address]] Tunable<Real, kTunesAmplitude, 0> amplitude_;
  [[no_unique_address]] Tunable<Real, kTunesOffset, 1> offset_;
  [[no_unique_address]] Tunable<Real, kTunesFrequency, 2> frequency_;
};

}  // namespace eagerx::models
