// The current of a servo, which depends on its input.
#pragma once

#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <type_traits>

namespace tests {

template <class Io>
class ServoCurrent {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const eagerx::Tick& /*tick*/, const typename Io::Inputs& /*in*/,
                typename Io::Outputs& out, Simulator& simulator) {
    using Message = std::remove_cvref_t<decltype(out.y)>;
    const auto& p = simulator.parameters;
    eagerx::element(out.y, 0) = static_cast<eagerx::ScalarOf<Message>>(
        (simulator.input[0] - p[1] * simulator.state[1]) / p[0]);
  }
};

}  // namespace tests
