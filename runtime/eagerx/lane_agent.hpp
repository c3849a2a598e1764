// Conversions like those of eagerx/agent.hpp for SIMD vectors, with the same results in each lane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/agent.hpp>
#include <eagerx/lanes.hpp>
#include <eagerx/message.hpp>
#include <eagerx/simd.hpp>
#include <eagerx/space.hpp>

namespace eagerx {
namespace detail {

/// Converts the numbers of a SIMD vector to another type, like static_cast lane by lane.
template <class To, class T, std::size_t N>
To lanes_as(const Simd<T, N>& x) {
  if constexpr (std::is_same_v<To, Simd<T, N>>) {
    return x;
  } else if constexpr (std::is_same_v<LaneOf<To>, bool>) {
    return To(x != Simd<T, N>(T{0}));
  } else {
    return To(x);
  }
}
template <class To, std::size_t Bytes, std::size_t N>
To lanes_as(const Mask<Bytes, N>& truth) {
  return select(truth, To(LaneOf<To>{1}), To(LaneOf<To>{0}));
}

}  // namespace detail

template <class Input, std::size_t Lanes, std::size_t N>
void flatten_padded(const Input& window, Simd<float, Lanes> (&input)[N], std::size_t& position) {
  using Message = typename Input::value_type;
  for (std::uint32_t w = 0; w < Input::kMaxSize; ++w) {
    const Message message = detail::padded(window, w, {});
    for (std::size_t i = 0; i < size_of<Message>; ++i)
      input[position++] = detail::lanes_as<Simd<float, Lanes>>(element(message, i));
  }
}

template <class Message, std::size_t Lanes, std::size_t N>
Message unflatten(const Simd<float, Lanes> (&output)[N], std::size_t& position) {
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i)
    element(action, i) = detail::lanes_as<ScalarOf<Message>>(output[position++]);
  return action;
}

/// Space::clipped().
template <class Message>
Message clipped(Message action, const Space<Message>& space) {
  using Scalar = ScalarOf<Message>;
  if constexpr (!std::is_same_v<LaneOf<Scalar>, bool>) {
    for (std::size_t i = 0; i < size_of<Message>; ++i) {
      Scalar& x = element(action, i);
      x = select(x >= element(space.low, i), x, element(space.low, i));
      x = select(x > element(space.high, i), element(space.high, i), x);
    }
  }
  return action;
}

/// The largest of `count` numbers, the first of equal ones.
template <std::size_t Lanes>
LaneCounts<Lanes> argmax(const Simd<float, Lanes>* y, std::size_t count) {
  Simd<float, Lanes> largest = y[0];
  LaneCounts<Lanes> best(0U);
  for (std::size_t k = 1; k < count; ++k) {
    const auto is_larger = largest < y[k];
    best = select(is_larger, LaneCounts<Lanes>(static_cast<std::uint32_t>(k)), best);
    largest = select(is_larger, y[k], largest);
  }
  return best;
}
template <std::size_t Lanes, std::size_t N>
LaneCounts<Lanes> argmax(const Simd<float, Lanes> (&y)[N]) {
  return argmax(&y[0], N);
}

template <class Message, std::size_t Lanes>
Message choice(const Space<Message>& space, const LaneCounts<Lanes>& index) {
  Message action{};
  element(action, 0) = element(space.low, 0) + detail::lanes_as<ScalarOf<Message>>(index);
  return action;
}

template <class Message, std::size_t Lanes, std::size_t N>
Message choices(const Space<Message>& space, const Simd<float, Lanes> (&output)[N],
                std::size_t& position) {
  using Scalar = ScalarOf<Message>;
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) {
    const Scalar low = element(space.low, i);
    const auto values =
        static_cast<std::size_t>(lane(element(space.high, i), 0) - lane(low, 0)) + 1;
    element(action, i) = low + detail::lanes_as<Scalar>(argmax(output + position, values));
    position += values;
  }
  return action;
}

template <class Message, std::size_t Lanes, std::size_t N>
Message bits(const Simd<float, Lanes> (&output)[N], std::size_t& position) {
  Message action{};
  for (std::size_t i = 0; i < size_of<Message>; ++i)
    element(action, i) =
        detail::lanes_as<ScalarOf<Message>>(output[position++] > Simd<float, Lanes>(0.0F));
  return action;
}

}  // namespace eagerx
