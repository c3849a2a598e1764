// Contacts on OpenDynamicsEngine and MultibodyEngine.
#pragma once

#include <cstddef>
#include <eagerx/math.hpp>
#include <models/engine_nodes/rigid_nodes.hpp>

namespace eagerx::models {

/// Every tick: observation [size] := 1 for each of `geometries` that something touches, else 0.
template <class Io>
class ContactSensor : public RigidSensor<Io, ContactSensor<Io>> {
 public:
  using Base = RigidSensor<Io, ContactSensor<Io>>;
  using typename Base::Model, typename Base::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    for (const std::size_t geometry : kGeometries) simulator.watch_contact_force(geometry);
  }

  template <class Message>
  static void sense(const Simulator& simulator, Message& observation) {
    static_assert(kCount == size_of<Message>,
                  "ContactSensor: `size` must be how many geometries there are");
    const Number square =
        number_for<Simulator>(Io::Config::threshold) * number_for<Simulator>(Io::Config::threshold);
    const Number one = number_for<Simulator>(1.0), zero = number_for<Simulator>(0.0);
    for (std::size_t i = 0; i < kCount; ++i) {
      const auto f = simulator.contact_force(kGeometries[i]);
      const auto touches = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] > square;
      Base::put(observation, i, eagerx::select(touches, one, zero));
    }
  }

 private:
  using Number = typename Simulator::Number;
  static constexpr std::size_t kCount = scene::count_names(Io::Config::geometries);
  static constexpr auto kGeometries =
      scene::find_all<kCount>(Model::kGeometries, Io::Config::geometries);
  static_assert(scene::all_below(kGeometries, Model::kGeometries.size()),
                "ContactSensor: `geometries` must be geometries of the object's model");
};

}  // namespace eagerx::models
