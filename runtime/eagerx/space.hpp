// Spaces: the valid values of a message. Bounds are inclusive, as in Gymnasium's Box.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>

namespace eagerx {

/// A Box with one low and one high for each element; generated code has one constant for each
/// space.
template <class Message>
struct Space {
  Message low;
  Message high;

  /// True if every element is a number within its bounds.
  constexpr bool contains(const Message& message) const {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      const auto& x = element(message, i);
      if (!(x >= element(low, i) && x <= element(high, i))) return false;
    }
    return true;
  }

  /// `message` with every element moved into its bounds; NaN becomes the lower bound.
  constexpr Message clipped(Message message) const {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      auto& x = element(message, i);
      if (!(x >= element(low, i))) x = element(low, i);
      if (x > element(high, i)) x = element(high, i);
    }
    return message;
  }

  /// Uniform in [low, high], element by element, from `random`. Bounds must be finite.
  Message sample(Random& random) const {
    Message message{};
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      element(message, i) = random.uniform(element(low, i), element(high, i));
    }
    return message;
  }
};

}  // namespace eagerx
