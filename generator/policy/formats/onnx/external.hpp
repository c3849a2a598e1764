// Values in separate files next to an ONNX file ("external data"). Inside formats/onnx only.
#pragma once

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Moves such values into their tensors, as if the file contained them. E0617 if a name is not that
/// of a file in the same folder, or if the file does not match the tensor.
bool take_external_values(onnx::GraphProto& graph, const FilesInFolder& files,
                          PolicyProblem& problem);

}  // namespace eagerx::gen
