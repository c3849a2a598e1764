// The engine of rigid bodies, by the Open Dynamics Engine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <models/engines/open_dynamics_engine/open_dynamics_simulator.hpp>
#include <models/engines/open_dynamics_engine/rigid_world.hpp>

namespace eagerx::models {

/// One world with the bodies of all objects. A tick is `substeps` equal steps, in each of which the
/// models' and joints' torques act, bodies touch, and the library integrates (semi-implicit Euler
/// with joints and contacts as constraints).
template <class Io>
class OpenDynamicsEngine {
 public:
  /// Gets all the memory there will be.
  template <class... Simulators>
  void start(Simulators&... simulators) {
    if (!world_.exists()) {
      world_.create(settings());
      (simulators.build(world_.id(), world_.space()), ...);
      (world_.add(simulators.shapes()), ...);
      (simulators.restart(), ...);
      world_.warm_up();
    }
    (simulators.restart(), ...);
  }

  template <class... Simulators>
  void reset(const typename Io::States& /*states*/, Simulators&... simulators) {
    world_.begin_episode();
    (simulators.place(), ...);
  }

  template <class... Simulators>
  void callback(const Tick& /*tick*/, Simulators&... simulators) {
    if constexpr (sizeof...(Simulators) > 0) {
      (simulators.begin_tick(Io::Rate::period_s, Config::substeps), ...);
      for (int i = 0; i < Config::substeps; ++i) {
        (simulators.before_step(), ...);
        world_.step();
        (simulators.after_step(), ...);
      }
    }
  }

  /// Contacts that were left out since the start of the program; saturates.
  std::uint32_t dropped_contacts() const { return world_.dropped_contacts(); }
  /// f(name, count) for each, for the summary of a run.
  template <class F>
  void for_each_count(F&& f) const {
    f("dropped contacts", dropped_contacts());
  }

 private:
  using Config = typename Io::Config;
  static_assert(Config::substeps >= 1, "OpenDynamicsEngine: `substeps` must be at least 1");
  static_assert(Config::gravity.size() == 3, "OpenDynamicsEngine: `gravity` has three values");

  static RigidWorldSettings settings() {
    return {.gravity = {{Config::gravity[0], Config::gravity[1], Config::gravity[2]}},
            .erp = Config::erp,
            .cfm = Config::cfm,
            .contact_erp = Config::contact_erp,
            .contact_cfm = Config::contact_cfm,
            .method = Config::method,
            .iterations = Config::iterations,
            .step_s = Io::Rate::period_s / Config::substeps};
  }

  RigidWorld<static_cast<std::size_t>(Config::max_contacts)> world_{};
};

}  // namespace eagerx::models
