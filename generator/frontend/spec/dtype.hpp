// Types of a message's elements, by numpy's names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

enum class Dtype : std::uint8_t {
  float32,
  float64,
  int8,
  int16,
  int32,
  int64,
  uint8,
  uint16,
  uint32,
  uint64,
  boolean
};
std::string_view to_string(Dtype dtype);
std::optional<Dtype> dtype_of(std::string_view name);
/// "float32", "float64", … in the order of the enumeration.
const std::vector<std::string>& dtype_names();
bool is_floating(Dtype dtype);
/// Lowest and highest value of the type (of float32 and float64 too).
double lowest_of(Dtype dtype);
double highest_of(Dtype dtype);

}  // namespace eagerx::gen
