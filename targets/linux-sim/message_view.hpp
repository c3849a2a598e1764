// Messages without their types, as the library of linux-sim sees them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <type_traits>

namespace eagerx::linux_sim {

enum class Scalar : std::uint8_t { boolean, i8, i16, i32, i64, u8, u16, u32, u64, f32, f64 };

template <class T>
constexpr Scalar scalar_of() {
  if constexpr (std::is_same_v<T, bool>) return Scalar::boolean;
  if constexpr (std::is_same_v<T, float>) return Scalar::f32;
  if constexpr (std::is_same_v<T, double>) return Scalar::f64;
  constexpr Scalar kSigned = sizeof(T) == 1   ? Scalar::i8
                             : sizeof(T) == 2 ? Scalar::i16
                             : sizeof(T) == 4 ? Scalar::i32
                                              : Scalar::i64;
  constexpr Scalar kUnsigned = sizeof(T) == 1   ? Scalar::u8
                               : sizeof(T) == 2 ? Scalar::u16
                               : sizeof(T) == 4 ? Scalar::u32
                                                : Scalar::u64;
  return std::is_signed_v<T> ? kSigned : kUnsigned;
}

/// [shape...] of a scalar type; a scalar has no dimension.
struct MessageType {
  Scalar scalar = Scalar::f32;
  std::size_t size = 1;   // elements
  std::size_t bytes = 0;  // of all
  const std::size_t* shape = nullptr;
  std::size_t dimensions = 0;

  constexpr bool is_scalar() const { return dimensions == 0; }
};

template <class Message>
struct TypeOf {
  static constexpr MessageType value{scalar_of<Message>(), 1, sizeof(Message), nullptr, 0};
};
template <class T, std::size_t... Shape>
struct TypeOf<Array<T, Shape...>> {
  static constexpr std::size_t kShape[] = {Shape...};
  static constexpr MessageType value{scalar_of<T>(), (Shape * ...), sizeof(Array<T, Shape...>),
                                     kShape, sizeof...(Shape)};
};

/// A view of the elements of a message, which it does not own.
struct MessageView {
  void* data;
  Scalar scalar;
  std::size_t size;

  template <class Message>
  static MessageView of(Message& message) {
    return {&element(message, 0), scalar_of<ScalarOf<Message>>(), size_of<Message>};
  }
};

}  // namespace eagerx::linux_sim
