// A sensor of an object on RealEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [] := element `index` of the last valid measurement.
template <class Io>
class RealSensor {
 public:
  using Simulator = typename Io::Simulator;
  using Real = typename Simulator::Real;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    simulator.limit_sensor(kIndex, static_cast<Real>(Io::Config::low),
                           static_cast<Real>(Io::Config::high));
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    element(out.observation, 0) = static_cast<ScalarOf<Message>>(simulator.value(kIndex));
  }

 private:
  static constexpr auto kIndex = static_cast<std::size_t>(Io::Config::index);
  static_assert(kIndex < Simulator::Model::kSensors,
                "RealSensor: `index` is beyond the sensors of the object's model");
};

}  // namespace eagerx::models
