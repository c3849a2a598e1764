// Tensors of a file: values that are read on demand, so that unneeded ones may hold anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/element_type.hpp"
#include "generator/policy/network/problem.hpp"
#include "generator/policy/network/shape.hpp"

namespace eagerx::gen {

/// The help for damaged files, and layers of other sizes.
inline constexpr const char* kExportAgain = "the file is damaged: export the actor again";
inline constexpr const char* kExportMisfit =
    "the layers of the file do not fit together: export the actor again";

/// Dimensions of a tensor.
inline constexpr std::size_t kMaxRank = 8;

/// A shape, or axes, or places.
using Integers = std::vector<std::int64_t>;

/// A tensor whose size was checked: `bytes` holds all elements of `dims`.
struct NetTensor {
  std::string name;
  ElementType type = ElementType::float32;
  Dims dims{};
  std::string_view bytes{};  // row-major, little-endian
  std::string own{};         // what `bytes` shows, if it lies nowhere else
};

/// Numbers that are not in the file, or not in the required form.
const NetTensor& made_tensor(std::deque<NetTensor>& all, std::string_view name,
                             const std::vector<float>& numbers, const Dims& dims);

/// A tensor without a copy of its values.
struct NetConstant {
  const NetTensor* tensor = nullptr;
  Dims dims;                // as seen after a transposition
  bool transposed = false;  // two dimensions only: values lie in the order of the swapped dims
};

/// The values in row-major order of `constant.dims`, converted to float where that is exact. E0615,
/// E0616.
std::optional<std::vector<float>> read_floats(const NetConstant& constant, PolicyProblem& problem);

/// The values in that order, of any type; int64 is exact below 2^53.
std::vector<double> read_numbers(const NetConstant& constant);

/// Plus or minus infinity, if that is the only value.
std::optional<float> infinity_of(const NetConstant& constant);

/// The values of an integer tensor of at most `most` (a shape, axes); nothing if it is something
/// else.
std::optional<Integers> read_integers(const NetConstant& constant, std::int64_t most = 64);

}  // namespace eagerx::gen
