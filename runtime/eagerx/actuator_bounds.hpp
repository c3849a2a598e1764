// Bounds of an action that a processor changes on its way to an actuator.
#pragma once

#include <cstddef>
#include <eagerx/channel_counts.hpp>
#include <eagerx/message.hpp>
#include <eagerx/space.hpp>
#include <eagerx/verdict.hpp>

namespace eagerx {

/// Moves the action into the space of the actuator, and counts how often that was necessary. Part
/// of the guard or, if the agent is in another program, of the program with the actuators.
template <std::size_t Actions>
class ActuatorBounds : public ChannelCounts<Actions> {
 public:
  template <class Message>
  Message within(std::size_t action, const Space<Message>& space, const Message& message) {
    const bool finite = is_finite(message);
    if (finite && space.contains(message)) return message;
    this->add(action);
    return space.clipped(finite ? message : Message{});
  }

  /// f(name, count) for each action.
  template <class F, class Names>
  void for_each_count(F&& f, const Names& names) const {
    this->for_each(f, "safe: action beyond its actuator", names);
  }
};

}  // namespace eagerx
