// Domain randomization: a state's value at a reset. (Uniform: Space::sample.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/random.hpp>

namespace eagerx {

/// Normally distributed, element by element. The caller clips it to the state's space.
template <class Message>
Message sample_normal(Random& random, const Message& mean, const Message& std) {
  Message result{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    element(result, i) = random.normal(element(mean, i), element(std, i));
  }
  return result;
}

/// Uniform in the logarithm between low and high, element by element; 0 < low <= high.
template <class Message>
Message sample_log_uniform(Random& random, const Message& low, const Message& high) {
  Message result{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    element(result, i) = random.log_uniform(element(low, i), element(high, i));
  }
  return result;
}

/// One of the values, with equal probability.
template <class Message, std::size_t N>
Message sample_choice(Random& random, const Message (&values)[N]) {
  return values[random.below(static_cast<std::uint32_t>(N))];
}

}  // namespace eagerx
