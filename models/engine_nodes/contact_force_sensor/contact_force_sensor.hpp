// Contact force on a geometry simulated by OpenDynamicsEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [3] := force of all contacts in the last step [N].
template <class Io>
class ContactForceSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    simulator.watch_contact_force(kGeometry);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    static_assert(size_of<Message> == 3);
    const auto force = simulator.contact_force(kGeometry);
    for (std::size_t i = 0; i < 3; ++i)
      element(out.observation, i) = static_cast<ScalarOf<Message>>(force[i]);
  }

 private:
  static constexpr std::size_t kGeometry =
      scene::find(Simulator::Model::kGeometries, Io::Config::geometry);
  static_assert(kGeometry < Simulator::Model::kGeometries.size(),
                "ContactForceSensor: `geometry` is not a geometry of the object's model");
};

}  // namespace eagerx::models
