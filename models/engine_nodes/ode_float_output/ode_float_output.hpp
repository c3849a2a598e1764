// One element of the state of an object simulated by OdeEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [] := element `idx` of the simulator's state at the time of the tick,
/// rounded to the scalar of the message.
template <class Io>
class OdeFloatOutput {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    constexpr auto kIndex = static_cast<std::size_t>(Io::Config::idx);
    static_assert(kIndex < Simulator::Model::kStates,
                  "OdeFloatOutput: `idx` is beyond the end of the object's state");
    element(out.observation, 0) = static_cast<ScalarOf<Message>>(simulator.state[kIndex]);
  }
};

}  // namespace eagerx::models
