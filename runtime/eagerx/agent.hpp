// Converts observations into a policy's inputs, and its outputs into actions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/space.hpp>

namespace eagerx {

/// Writes the messages of an observation, oldest first, each flat, to `input` from `position` on,
/// and moves `position` past them: the order of Gymnasium's flatten().
template <class Observed, std::size_t N>
void flatten(const Observed& window, float (&input)[N], std::size_t& position) {
  using Message = typename Observed::value_type;
  for (std::uint32_t w = 0; w < window.size(); ++w) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      input[position++] = static_cast<float>(element(window[w], i));
    }
  }
}

/// The same for a node's input, always with as many messages as its window can hold: missing ones
/// at the front are copies of the oldest, or zero before the first message.
template <class Input, std::size_t N>
void flatten_padded(const Input& window, float (&input)[N], std::size_t& position) {
  using Message = typename Input::value_type;
  const std::uint32_t missing = Input::kMaxSize - window.size();
  for (std::uint32_t w = 0; w < Input::kMaxSize; ++w) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      input[position++] =
          window.empty() ? 0.0F
                         : static_cast<float>(element(window[w < missing ? 0 : w - missing], i));
    }
  }
}

/// Reads the next elements of an action from `output`.
template <class Message, std::size_t N>
Message unflatten(const float (&output)[N], std::size_t& position) {
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    element(action, i) = static_cast<ScalarOf<Message>>(output[position++]);
  }
  return action;
}

/// From -1…1 to the action's bounds, as Stable-Baselines3 does for squashed policies (SAC, TD3):
/// low + 0.5 (x + 1) (high - low).
template <class Message>
Message unscaled(Message action, const Space<Message>& space) {
  using Scalar = ScalarOf<Message>;
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    const Scalar low = element(space.low, i);
    const Scalar high = element(space.high, i);
    Scalar& x = element(action, i);
    x = low + (Scalar(0.5) * (x + Scalar(1))) * (high - low);
  }
  return action;
}

/// The action of a policy that chooses a whole number: the lowest one plus `index`.
template <class Message>
Message choice(const Space<Message>& space, std::size_t index) {
  Message action{};
  element(action, 0) =
      static_cast<ScalarOf<Message>>(element(space.low, 0) + static_cast<ScalarOf<Message>>(index));
  return action;
}

/// The next choices of a policy, one for each number. Each number has as many outputs as values;
/// the choice is its lowest value plus the index of the largest output, the first of equal ones.
template <class Message, std::size_t N>
Message choices(const Space<Message>& space, const float (&output)[N], std::size_t& position) {
  using Scalar = ScalarOf<Message>;
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    const Scalar low = element(space.low, i);
    const std::size_t end = position + static_cast<std::size_t>(element(space.high, i) - low) + 1;
    std::size_t best = position;
    for (std::size_t k = position; k < end; ++k) {
      if (output[best] < output[k]) best = k;
    }
    element(action, i) = static_cast<Scalar>(low + static_cast<Scalar>(best - position));
    position = end;
  }
  return action;
}

/// The next elements of an action: 1 if the output is above zero, else 0.
template <class Message, std::size_t N>
Message bits(const float (&output)[N], std::size_t& position) {
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    element(action, i) = static_cast<ScalarOf<Message>>(output[position++] > 0.0F ? 1 : 0);
  }
  return action;
}

}  // namespace eagerx
