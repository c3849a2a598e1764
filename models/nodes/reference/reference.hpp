// Test signals: step, ramp, sine, chirp, and recorded ones.
#pragma once

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
    constexpr auto kWholeStart = static_cast<std::int64_t>(Config::start);
    constexpr auto kRestStart = static_cast<Lane>(Config::start - static_cast<double>(kWholeStart));
    ExactTime<Lane> t = exact_time<typename Io::Rate, Lane>(n);
    t.whole_s -= kWholeStart;
    t.rest_s -= kRestStart;
    if (t.rest_s < Lane(0)) return {t.whole_s - 1, t.rest_s + Lane(1)};
    return t;
  }

  Lane shape(const ExactTime<Lane>& t, [[maybe_unused]] int k) const {
    [[maybe_unused]] const Lane seconds = static_cast<Lane>(t.whole_s) + t.rest_s;
    if constexpr (Config::shape == ReferenceShape::step) {
      return Lane(1);
    } else if constexpr (Config::shape == ReferenceShape::ramp) {
      return eagerx::min(seconds / kDuration, Lane(1));
    } else if constexpr (Config::shape == ReferenceShape::sine) {
      return wave(turns_of(frequency(k), t));
    } else if constexpr (Config::shape == ReferenceShape::table) {
      return between_points(seconds);
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
    const Lane f = exact.hz;
    const auto risen = [&](Lane sweep) {
      return (kEndFrequency - f) * (sweep / (Lane(2) * kDuration)) * sweep;
    };
    if (seconds < kDuration) return turns_of(exact, t) + risen(seconds);
    // f·D + (f1 − f)·D/2 − f1·D = (f − f1)·D/2
    const Lane behind = (f - kEndFrequency) * (kDuration / Lane(2));
    constexpr auto kEnd = exact_frequency<Lane>(Config::end_frequency);
    return turns_of(kEnd, t) + (behind - eagerx::floor(behind));
  }

  static constexpr std::size_t kPoints = Config::times.size();
  static constexpr auto kTimes = constants<Real>(Config::times);
  static constexpr auto kValues = constants<Real>(Config::values);

  static Lane between_points(Lane t) {
    if (t < kTimes[0]) return kValues[0];
    std::size_t before = 0;
    std::size_t after = kPoints;
    while (after - before > 1) {  // the logarithm of kPoints times
      const std::size_t middle = before + (after - before) / 2;
      (t < kTimes[middle] ? after : before) = middle;
    }
    if (Config::interpolation == Interpolation::previous || after == kPoints)
      return kValues[before];
    const Lane share = (t - kTimes[before]) / (kTimes[after] - kTimes[before]);
    return kValues[before] + share * (kValues[after] - kValues[before]);
  }
  /// `turns` without whole ones first: the sine of a large number is the less exact.
  static Lane wave(Lane turns) {
    const Lane phase = turns + constant<Real>(Config::phase);
    return eagerx::sin(Lane(2) * std::numbers::pi_v<Lane> * (phase - eagerx::floor(phase)));
  }

  [[no_unique_address]] Tunable < Real, requires(States s) { s.amplitude; }
  , 0 > amplitude_;
  [[no_unique_address]] Tunable < Real, requires(States s) { s.offset; }
  , 1 > offset_;
  [[no_unique_address]] Tunable < Real, requires(States s) { s.frequency; }
  , 2 > frequency_;
};

}  // namespace eagerx::models
