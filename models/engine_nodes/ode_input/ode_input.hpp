// Sets the input of an object simulated by OdeEngine.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace eagerx::models {

/// Every tick: simulator input := last action [n], which is also the output. The engine step that
/// begins at the time of the tick is the first to use it.
/// At a reset, and as long as no action has come (skipped connections): `default_action`.
template <class Io>
class OdeInput {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    set(simulator, kDefault);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    const Message action = in.action.empty() ? kDefault : in.action.back();
    set(simulator, action);
    out.action_applied = action;
  }

 private:
  using Message = typename decltype(Io::Inputs::action)::value_type;
  using Scalar = ScalarOf<Message>;
  static constexpr std::size_t kSize = size_of<Message>;
  static_assert(kSize == Simulator::Model::kInputs,
                "OdeInput: the action must have as many elements as the object's model has inputs");
  static_assert(Io::Config::default_action.size() == kSize,
                "OdeInput: `default_action` must have as many elements as the action");

  static constexpr Message default_message() {
    Message message{};
    for (std::size_t i = 0; i < kSize; ++i) {
      element(message, i) = static_cast<Scalar>(Io::Config::default_action[i]);
    }
    return message;
  }
  static constexpr Message kDefault = default_message();

  static void set(Simulator& simulator, const Message& action) {
    for (std::size_t i = 0; i < kSize; ++i) {
      simulator.input[i] = static_cast<typename Simulator::Real>(element(action, i));
    }
  }
};

}  // namespace eagerx::models
