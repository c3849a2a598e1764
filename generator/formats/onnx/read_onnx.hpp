// ONNX files to networks.
#pragma once

#include <optional>
#include <string_view>

#include "generator/formats/common/problem.hpp"
#include "generator/network/network.hpp"

namespace eagerx::gen {

/// The actor in the bytes of an ONNX file, `file` left empty; or why there is none.
std::optional<Network> read_onnx(std::string_view bytes, PolicyProblem& problem);

}  // namespace eagerx::gen
