// The actuators of an object on RealEngine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace eagerx::models {

/// How an action out of the limits is handled.
enum class OutOfLimits : std::uint8_t { clip, safe };

/// Every tick: next action := last action [n] within its limits, which is also the output; the safe
/// action while RealEngine holds the actuators, and before the first action.
template <class Io>
class RealActuator {
 public:
  using Simulator = typename Io::Simulator;
  using Real = typename Simulator::Real;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    for (std::size_t i = 0; i < kSize; ++i) {
      simulator.declare_safe(i, static_cast<Real>(Io::Config::safe_action[i]));
    }
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    for (std::size_t i = 0; i < kSize; ++i) {
      const Real wanted = in.action.empty() ? static_cast<Real>(Io::Config::safe_action[i])
                                            : static_cast<Real>(element(in.action.back(), i));
      const Real applied = simulator.act(i, wanted, static_cast<Real>(Io::Config::low[i]),
                                         static_cast<Real>(Io::Config::high[i]), kClips);
      element(out.action_applied, i) = static_cast<ScalarOf<Message>>(applied);
    }
  }

 private:
  using Message = typename decltype(Io::Inputs::action)::value_type;
  static constexpr std::size_t kSize = size_of<Message>;
  static constexpr bool kClips = Io::Config::limits == OutOfLimits::clip;
  static_assert(kSize == Simulator::Model::kActuators,
                "RealActuator: the action must have as many elements as the model has actuators");
};

}  // namespace eagerx::models
