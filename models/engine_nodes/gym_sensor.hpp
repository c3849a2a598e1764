// Shared parts of sensors on GymEngine.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: Derived::message(outputs) [] := Derived::number(simulator).
template <class Io, class Derived>
class GymSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    simulator.begin_episode();
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    auto& message = Derived::message(out);
    using Message = std::remove_cvref_t<decltype(message)>;
    element(message, 0) = static_cast<ScalarOf<Message>>(Derived::number(simulator));
  }
};

}  // namespace eagerx::models
