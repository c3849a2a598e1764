// The engine of articulated robots that are known at compile time.
#pragma once

#include <cstddef>
#include <eagerx/rate.hpp>
#include <models/engines/multibody_engine/contact.hpp>
#include <models/engines/multibody_engine/multibody_simulator.hpp>

namespace eagerx::models {

/// Advances every object by one period of the engine in `substeps` equal steps. Objects do not
/// touch each other.
template <class Io>
class MultibodyEngine {
 public:
  template <class... Simulators>
  void start(Simulators&... simulators) {
    static_assert(Config::gravity.size() == 3, "MultibodyEngine: `gravity` has three values");
    constexpr Vector3 kGravity{{Config::gravity[0], Config::gravity[1], Config::gravity[2]}};
    (simulators.start(kGravity), ...);
  }

  /// Gravity belongs to the whole world: the state of one object sets it for all.
  template <class... Simulators>
  void reset(const typename Io::States& /*states*/, Simulators&... simulators) {
    const auto share = [&](const auto& gravity) { (simulators.share_gravity(gravity), ...); };
    (simulators.take_gravity(share), ...);
    (simulators.begin_episode(), ...);
  }

  template <class... Simulators>
  void callback(const Tick& /*tick*/, Simulators&... simulators) {
    (advance(simulators), ...);
  }

 private:
  using Config = typename Io::Config;
  static_assert(Config::substeps >= 1, "MultibodyEngine: `substeps` must be at least 1");

  template <class Lane>
  static constexpr multibody::ContactSettings<Lane> settings() {
    return {.stiffness = static_cast<Lane>(Config::contact_stiffness),
            .damping = static_cast<Lane>(Config::contact_damping),
            .slip_speed = static_cast<Lane>(Config::slip_speed),
            .correction = static_cast<Lane>(Config::contact_correction),
            .dt = static_cast<Lane>(Io::Rate::period_s / Config::substeps)};
  }

  template <class Simulator>
  static void advance(Simulator& simulator) {
    using Lane = LaneOf<typename Simulator::Real>;
    constexpr auto kSettings = settings<Lane>();
    simulator.begin_tick(static_cast<Lane>(1.0 / Io::Rate::period_s));
#pragma GCC unroll 1
    for (int i = 0; i < Config::substeps; ++i) {
      simulator.actuate();
      simulator.step(kSettings, Config::sweeps);
    }
    simulator.end_tick();
  }
};

}  // namespace eagerx::models
