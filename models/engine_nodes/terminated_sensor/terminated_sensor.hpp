// Whether an environment on GymEngine was terminated.
#pragma once

#include <models/engine_nodes/gym_sensor.hpp>

namespace eagerx::models {

/// Every tick: terminated [] := 1 if any step since the reset terminated, else 0.
template <class Io>
class TerminatedSensor : public GymSensor<Io, TerminatedSensor<Io>> {
 public:
  static auto& message(typename Io::Outputs& out) { return out.terminated; }
  static auto number(typename Io::Simulator& simulator) { return simulator.terminated; }
};

}  // namespace eagerx::models
