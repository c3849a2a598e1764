// Types of a tensor's elements, with their names and layouts in file formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "generator/policy/network/problem.hpp"

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
bool is_real(ElementType type);

/// The whole number in the first `count` bytes, little-endian.
std::uint64_t little_endian(std::string_view bytes, std::size_t count);

/// The element that begins at `from`, little-endian.
double value_at(ElementType type, const char* from);

/// By NumPy's code without its byte order: "f4".
std::optional<ElementType> numpy_type(std::string_view code);
/// By safetensors' name: "F32".
std::optional<ElementType> safetensors_type(std::string_view name);
/// By the class of torch's storage: "torch.FloatStorage".
std::optional<ElementType> torch_storage_type(std::string_view name);
/// By ONNX's number: 1. And that number of a type.
std::optional<ElementType> onnx_type(std::int64_t number);
std::int64_t onnx_number(ElementType type);
/// ONNX's name of its type `number`, as "FLOAT", also of those that are not read; nothing if there
/// is none.
std::optional<std::string_view> onnx_type_name(std::int64_t number);

/// Finite numbers as float32: E0615 for values beyond float32, in tensor `name`; `verb` describes
/// the file for the message: "exporting", "saving".
std::optional<std::vector<float>> exact_floats(const std::vector<double>& values,
                                               std::string_view name, std::string_view verb,
                                               PolicyProblem& problem);
/// E0616 unless all of `values` are finite; `verb` as "export", "save".
bool all_finite(const std::vector<double>& values, std::string_view name, std::string_view verb,
                PolicyProblem& problem);

}  // namespace eagerx::gen
