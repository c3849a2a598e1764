// Tensors of an ONNX file: sizes checked before anything is believed, values read on demand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/formats/common/problem.hpp"
#include "generator/formats/common/shape.hpp"
#include "generator/formats/onnx/onnx.pb.h"

namespace eagerx::gen {

/// What helps against damaged files, and layers of other sizes.
inline constexpr const char* kExportAgain = "the file is damaged: export the actor again";
inline constexpr const char* kExportMisfit =
    "the layers of the file do not fit together: export the actor again";

/// Dimensions of a tensor.
inline constexpr std::size_t kMaxOnnxRank = 8;

/// A shape, or axes, or places.
using Integers = std::vector<std::int64_t>;

/// A constant of the file, without a copy of its values.
struct OnnxConstant {
  const onnx::TensorProto* tensor = nullptr;
  Dims dims;                // as seen after a transposition
  bool transposed = false;  // two dimensions only: values lie in the order of the swapped dims
};

/// Checks type, dims and amount of data (not the values); or sets `problem`.
std::optional<OnnxConstant> make_constant(const onnx::TensorProto& tensor, PolicyProblem& problem);

/// The values in row-major order of `constant.dims`, converted to float where that is exact.
std::optional<std::vector<float>> read_floats(const OnnxConstant& constant, PolicyProblem& problem);

/// Plus or minus infinity, if that is the only value.
std::optional<float> infinity_of(const OnnxConstant& constant);

/// The values of an integer tensor of at most `most` (a shape, axes); nothing if it is something
/// else.
std::optional<std::vector<std::int64_t>> read_integers(const OnnxConstant& constant,
                                                       std::int64_t most = 64);

}  // namespace eagerx::gen
