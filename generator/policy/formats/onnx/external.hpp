// Values in separate files next to an ONNX file ("external data"). Inside formats/onnx only.
#pragma once

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/formats/onnx/onnx.pb.h"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Puts such values into their tensors, as if they had been in the file. E0617 if a name is not
/// that of a file in its folder, or the file is not what the tensor says.
bool take_external_values(onnx::GraphProto& graph, const FilesInFolder& files,
                          PolicyProblem& problem);

}  // namespace eagerx::gen
