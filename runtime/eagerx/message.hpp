// Messages between nodes: a scalar for shape [], an Array for every other shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/index.hpp>
#include <type_traits>

namespace eagerx {

/// A message of shape [Shape...], row-major, without padding or heap. `operator[]` is flat.
template <class T, std::size_t... Shape>
struct Array {
  static_assert(sizeof...(Shape) > 0, "a message of shape [] is a plain scalar");
  static constexpr std::size_t kSize = (Shape * ...);
  T data[kSize];

  static constexpr std::size_t size() { return kSize; }
#if defined(EAGERX_CONSTANT_INDEXES)
  constexpr T& operator[](std::size_t i) {
    return data[known_below<kSize>(i)];
  }
  constexpr const T& operator[](std::size_t i) const {
    return data[known_below<kSize>(i)];
  }
#elif defined(EAGERX_CHECKS)
  constexpr T& operator[](Index i) {
    return data[i.below(kSize, "message")];
  }
  constexpr const T& operator[](Index i) const {
    return data[i.below(kSize, "message")];
  }
#else
  constexpr T& operator[](std::size_t i) {
    return data[i];
  }
  constexpr const T& operator[](std::size_t i) const {
    return data[i];
  }
#endif
  constexpr T* begin() {
    return data;
  }
  constexpr T* end() {
    return data + kSize;
  }
  constexpr const T* begin() const {
    return data;
  }
  constexpr const T* end() const {
    return data + kSize;
  }
  friend constexpr bool operator==(const Array& a,
                                   const Array& b) requires std::is_arithmetic_v<T> {
    for (std::size_t i = 0; i < kSize; ++i) {
      if (a.data[i] != b.data[i]) return false;
    }
    return true;
  }
};

/// The element types of messages: plain numbers, and SIMD vectors of them (eagerx/simd.hpp).
template <class T>
inline constexpr bool is_number = std::is_arithmetic_v<T>;

/// Scalar type and number of elements of a message type, scalar or Array.
template <class Message>
struct MessageTraits {
  static_assert(is_number<Message>, "a message is a number or an eagerx::Array");
  using Scalar = Message;
  static constexpr std::size_t size = 1;
};
template <class T, std::size_t... Shape>
struct MessageTraits<Array<T, Shape...>> {
  using Scalar = T;
  static constexpr std::size_t size = Array<T, Shape...>::kSize;
};
// Overload resolution of element() also considers const messages.
template <class Message>
struct MessageTraits<const Message> : MessageTraits<Message> {};

template <class Message>
using ScalarOf = typename MessageTraits<Message>::Scalar;
template <class Message>
inline constexpr std::size_t size_of = MessageTraits<Message>::size;

/// Element `i` of a message in row-major order; `i` must be 0 for a scalar.
template <class Message>
constexpr ScalarOf<Message>& element(Message& message, std::size_t i) {
  if constexpr (is_number<std::remove_const_t<Message>>) {
    return static_cast<void>(i), message;
  } else {
    return message[i];
  }
}
template <class Message>
constexpr const ScalarOf<Message>& element(const Message& message, std::size_t i) {
  if constexpr (is_number<std::remove_const_t<Message>>) {
    return static_cast<void>(i), message;
  } else {
    return message[i];
  }
}

/// A message with every element equal to `value`.
template <class Message>
constexpr Message filled(ScalarOf<Message> value) {
  Message message{};
  for (std::size_t i = 0; i < size_of<Message>; ++i) element(message, i) = value;
  return message;
}

}  // namespace eagerx
