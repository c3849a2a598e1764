// Elements of a message whose type is known only at run time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <targets/linux-sim/message_view.hpp>

namespace eagerx::linux_sim {

/// f(T{}) for the scalar type T.
template <class F>
decltype(auto) with_scalar(Scalar scalar, F&& f) {
  switch (scalar) {
    case Scalar::boolean:
      return f(bool{});
    case Scalar::i8:
      return f(std::int8_t{});
    case Scalar::i16:
      return f(std::int16_t{});
    case Scalar::i32:
      return f(std::int32_t{});
    case Scalar::i64:
      return f(std::int64_t{});
    case Scalar::u8:
      return f(std::uint8_t{});
    case Scalar::u16:
      return f(std::uint16_t{});
    case Scalar::u32:
      return f(std::uint32_t{});
    case Scalar::u64:
      return f(std::uint64_t{});
    case Scalar::f64:
      return f(double{});
    case Scalar::f32:
      break;
  }
  return f(float{});
}

/// f(T* elements) for the scalar type T of `data`.
template <class F>
decltype(auto) with_elements(Scalar scalar, void* data, F&& f) {
  return with_scalar(
      scalar, [&](auto zero) -> decltype(auto) { return f(static_cast<decltype(zero)*>(data)); });
}
template <class F>
decltype(auto) with_elements(Scalar scalar, const void* data, F&& f) {
  return with_scalar(scalar, [&](auto zero) -> decltype(auto) {
    return f(static_cast<const decltype(zero)*>(data));
  });
}

/// Element `i` as a double, rounded if it has more digits.
inline double number_of(Scalar scalar, const void* data, std::size_t i) {
  return with_elements(scalar, data,
                       [&](const auto* elements) { return static_cast<double>(elements[i]); });
}

}  // namespace eagerx::linux_sim
