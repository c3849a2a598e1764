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
    const auto now = seconds_at<typename Io::Rate, Real>(tick);
    const Real offset = offset_.or_constant(kOffset);
    const Real shaped = offset + amplitude_.or_constant(kAmplitude) * shape(now - Real(kStart));
    put(out.y, 0, select(now < Real(kStart), offset, shaped));
  }

 private:
  using Real = typename Io::Real;
  using Lane = LaneOf<Real>;
  using Config = typename Io::Config;
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

  Real shape(const Real& t) const {
    [[maybe_unused]] const Real frequency = frequency_.or_constant(kFrequency);
    if constexpr (Config::shape == ReferenceShape::step) {
      return Real(Lane(1));
    } else if constexpr (Config::shape == ReferenceShape::ramp) {
      return eagerx::min(t / Real(kDuration), Real(Lane(1)));
    } else if constexpr (Config::shape == ReferenceShape::sine) {
      return wave(frequency * t);
    } else if constexpr (Config::shape == ReferenceShape::table) {
      Real y(Lane(0));
      for (int k = 0; k < lanes<Real>; ++k) set_lane(y, k, between_points(lane(t, k)));
      return y;
    } else {
      const Real sweep = eagerx::min(t, Real(kDuration));
      const Real rise =
          (Real(kEndFrequency) - frequency) * (sweep / Real(Lane(2) * kDuration)) * sweep;
      return wave(frequency * sweep + rise + Real(kEndFrequency) * (t - sweep));
    }
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
  static Real wave(const Real& turns) {
    const Real phase = turns + Real(constant<Real>(Config::phase));
    return eagerx::sin(Real(Lane(2) * std::numbers::pi_v<Lane>) * (phase - eagerx::floor(phase)));
  }

  using States = typename Io::States;
  [[no_unique_address]] Tunable < Real, requires(States s) { s.amplitude; }
  , 0 > amplitude_;
  [[no_unique_address]] Tunable < Real, requires(States s) { s.offset; }
  , 1 > offset_;
  [[no_unique_address]] Tunable < Real, requires(States s) { s.frequency; }
  , 2 > frequency_;
};

}  // namespace eagerx::models
