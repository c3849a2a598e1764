// Tensors of a file by name, in any format. Values are read on demand, so that unneeded parts of a
// file may contain anything.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/element_type.hpp"
#include "generator/policy/network/problem.hpp"
#include "generator/policy/network/shape.hpp"

namespace eagerx::gen {

/// A tensor as stored in the file.
struct StoredTensor {
  ElementType type = ElementType::float32;
  Dims shape;
  std::vector<std::int64_t> strides;  // elements from one to the next; empty: row-major
  std::string_view bytes;             // from its first element on, little-endian
};

/// E0614 unless every element of the shape is inside `bytes`.
bool fits(const std::string& name, const StoredTensor& tensor, PolicyProblem& problem);

/// All values in row-major order; `fits` was true.
std::vector<double> values_of(const StoredTensor& tensor);

/// The values as float32: E0616 for NaN and infinity, E0615 for values beyond float32 and for
/// integers.
std::optional<std::vector<float>> floats_of(const std::string& name, const StoredTensor& tensor,
                                            PolicyProblem& problem);

/// The finite values of a small table: E0616.
std::optional<std::vector<double>> finite_values_of(const std::string& name,
                                                    const StoredTensor& tensor,
                                                    PolicyProblem& problem);

/// Everything that a file with named tensors holds.
struct TensorTable {
  std::map<std::string, StoredTensor, std::less<>> tensors;
  std::map<std::string, std::string, std::less<>> notes;  // safetensors' metadata
  std::deque<std::string> buffers;                        // bytes that are not in the file itself

  [[nodiscard]] const StoredTensor* find(std::string_view name) const {
    const auto found = tensors.find(name);
    return found == tensors.end() ? nullptr : &found->second;
  }
  /// Adds a tensor that fits and whose name is new: E0614, E0610.
  bool add(const std::string& name, StoredTensor tensor, PolicyProblem& problem);
};

}  // namespace eagerx::gen
