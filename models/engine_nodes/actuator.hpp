// Shared parts of simulated actuators.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>

namespace eagerx::models {

/// Every tick: Derived::apply(simulator, last action [n]), which is also the output. The engine
/// step that begins at the time of the tick is the first to use it. At a reset, and before the
/// first action (skipped connections): `Default` [n].
template <class Io, class Derived, const auto& Default = Io::Config::default_action>
class Actuator {
 public:
  using Simulator = typename Io::Simulator;

  void reset(const typename Io::States& /*states*/, Simulator& simulator) {
    Derived::apply(simulator, kDefault);
  }

  void callback(const Tick& /*tick*/, const typename Io::Inputs& in, typename Io::Outputs& out,
                Simulator& simulator) {
    const Message action = in.action.back_or(kDefault);
    Derived::apply(simulator, action);
    out.action_applied = action;
  }

 protected:
  using Message = typename decltype(Io::Inputs::action)::value_type;
  static constexpr std::size_t kSize = size_of<Message>;

 private:
  static_assert(Default.size() == kSize,
                "`default_action` must have as many elements as the action");

  static constexpr Message default_message() {
    Message message{};
    for (std::size_t i = 0; i < kSize; ++i)
      element(message, i) = static_cast<ScalarOf<Message>>(Default[i]);
    return message;
  }
  static constexpr Message kDefault = default_message();
};

}  // namespace eagerx::models
