// An open-loop trot.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/time.hpp>

namespace trot {

/// Hip and knee angles [8] of a trot at `speed` [1] m/s; see the manifest.
template <class Io>
class Trot {
 public:
  void reset(const typename Io::States& /*states*/) {}

  void callback(const eagerx::Tick& tick, const typename Io::Inputs& in,
                typename Io::Outputs& out) {
    constexpr auto kPeriod = static_cast<Real>(Io::Config::period);
    constexpr auto kTurn = Real(6.283185307179586);
    constexpr auto kFrequency = eagerx::exact_frequency<Real>(1.0 / Io::Config::period);
    const auto time = eagerx::exact_time<typename Io::Rate, Real>(tick.n);
    const Real speed = in.speed.empty() ? Real(0) : static_cast<Real>(in.speed.back()[0]);
    const Real growth = eagerx::min(eagerx::seconds_of(time) / (Real(2) * kPeriod), Real(1));
    const Real stroke = growth * speed * kPeriod * Real(0.5);
    const Real phase = kTurn * eagerx::turns_of(kFrequency, time);
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const bool first_pair = leg == 0 || leg == 3;  // front left, rear right
      step(first_pair ? phase : phase + Real(0.5) * kTurn, stroke, out.position[2 * leg],
           out.position[2 * leg + 1]);
    }
  }

 private:
  using Real = typename Io::Real;

  static void step(Real phase, Real stroke, float& hip, float& knee) {
    constexpr auto kLink = static_cast<Real>(Io::Config::link);
    const Real lift = eagerx::max(eagerx::sin(phase), Real(0));
    const Real x = Real(-0.5) * stroke * eagerx::cos(phase);
    const Real z =
        static_cast<Real>(-Io::Config::height) + static_cast<Real>(Io::Config::lift) * lift;
    const Real length = eagerx::min(eagerx::sqrt(x * x + z * z), Real(1.999) * kLink);
    // Both links are equal: half the leg over a link is the cosine of the angle to the leg.
    const Real cosine = Real(0.5) * length / kLink;
    const Real bend = eagerx::atan2(eagerx::sqrt(Real(1) - cosine * cosine), cosine);
    // A leg turned by a positive angle points to -x.
    const Real direction = eagerx::atan2(-x, -z);
    hip = static_cast<float>(direction - bend);
    knee = static_cast<float>(Real(2) * bend);
  }
};

}  // namespace trot
