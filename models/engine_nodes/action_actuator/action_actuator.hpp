// Sets the action of an environment on GymEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace eagerx::models {

/// Every tick: action of the next steps := last action [n], which is also the output. At a reset,
/// and as long as no action has come (skipped connections): `zero_action`.
template <class Io>
class ActionActuator {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) { set(simulator, kZero); }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    const Message action = in.action.empty() ? kZero : in.action.back();
    set(simulator, action);
    out.action_applied = action;
  }

 private:
  using Message = typename decltype(Io::Inputs::action)::value_type;
  using Scalar = ScalarOf<Message>;
  static constexpr std::size_t kSize = size_of<Message>;
  static_assert(kSize == Simulator::Model::kActions,
                "ActionActuator: the action must have as many elements as the object's model");
  static_assert(Io::Config::zero_action.size() == kSize,
                "ActionActuator: `zero_action` must have as many elements as the action");

  static constexpr Message zero_message() {
    Message message{};
    for (std::size_t i = 0; i < kSize; ++i) {
      element(message, i) = static_cast<Scalar>(Io::Config::zero_action[i]);
    }
    return message;
  }
  static constexpr Message kZero = zero_message();

  static void set(Simulator& simulator, const Message& action) {
    for (std::size_t i = 0; i < kSize; ++i) {
      simulator.next_action[i] = static_cast<typename Simulator::Real>(element(action, i));
    }
  }
};

}  // namespace eagerx::models
