// The action that was applied before this tick, as a sensor.
#pragma once

#include <eagerx/rate.hpp>
#include <type_traits>

namespace eagerx::models {

/// Every tick: output := last action_applied [n]; zeros before the first message, as at tick 0 of
/// the usual, skipped connection.
template <class Io>
class ActionApplied {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& /*simulator*/) {}

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& /*simulator*/) {
    using Message = std::remove_cvref_t<decltype(out.action_applied)>;
    out.action_applied = in.action_applied.back_or(Message{});
  }
};

}  // namespace eagerx::models
