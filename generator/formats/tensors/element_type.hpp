// Types of a tensor's elements, and what file formats call them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace eagerx::gen {

enum class ElementType : std::uint8_t {
  float16,
  bfloat16,
  float32,
  float64,
  int8,
  uint8,
  int16,
  int32,
  int64,
  boolean,
};
/// Bytes of one element.
std::size_t size_of(ElementType type);

/// By NumPy's code without its byte order: "f4".
std::optional<ElementType> numpy_type(std::string_view code);
/// By safetensors' name: "F32".
std::optional<ElementType> safetensors_type(std::string_view name);
/// By the class of torch's storage: "torch.FloatStorage".
std::optional<ElementType> torch_storage_type(std::string_view name);

}  // namespace eagerx::gen
