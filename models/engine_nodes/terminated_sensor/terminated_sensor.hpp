// Whether an environment on GymEngine was terminated.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: terminated [] := 1 if any step since the reset said so, else 0.
template <class Io>
class TerminatedSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    simulator.begin_episode();
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.terminated)>;
    element(out.terminated, 0) = static_cast<ScalarOf<Message>>(simulator.terminated);
  }
};

}  // namespace eagerx::models
