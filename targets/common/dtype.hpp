// The name of a type of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>

namespace eagerx::target {

/// As graphs and numpy write it: "float32", "bool".
template <class T>
std::string dtype_of() {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  constexpr std::size_t kBitsPerByte = 8;
  const std::string bits = std::to_string(sizeof(T) * kBitsPerByte);
  if constexpr (std::is_floating_point_v<T>) return "float" + bits;
  return (std::is_signed_v<T> ? "int" : "uint") + bits;
}

}  // namespace eagerx::target
