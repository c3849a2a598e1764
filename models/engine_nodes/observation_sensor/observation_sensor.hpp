// The observation of an environment on GymEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: observation [size] := the model's observation of its current state, rounded to the
/// scalar of the message.
template <class Io>
class ObservationSensor {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& /*in*/, typename Io::Outputs& out,
                Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.observation)>;
    using Model = typename Simulator::Model;
    static_assert(
        size_of<Message> == Model::kObservations,
        "ObservationSensor: `size` must be the number of observations of the object's model");
    const auto observation = Model::observe(simulator.state);
    for (std::size_t i = 0; i < Model::kObservations; ++i) {
      element(out.observation, i) = static_cast<ScalarOf<Message>>(observation[i]);
    }
  }
};

}  // namespace eagerx::models
