// Whether an environment on GymEngine was truncated.
#pragma once

#include <models/engine_nodes/gym_sensor.hpp>

namespace eagerx::models {

/// Every tick: truncated [] := 1 if any step since the reset truncated, else 0.
template <class Io>
class TruncatedSensor : public GymSensor<Io, TruncatedSensor<Io>> {
 public:
  static auto& message(typename Io::Outputs& out) { return out.truncated; }
  static auto number(typename Io::Simulator& simulator) { return simulator.truncated; }
};

}  // namespace eagerx::models
