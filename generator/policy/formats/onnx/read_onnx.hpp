// ONNX files to networks.
#pragma once

#include <optional>
#include <string_view>

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// The actor in the bytes of an ONNX file, without setting `file`; or the reason why it cannot be
/// read. Its action is the output `output`; empty: the one that is recognized. Values may be in
/// `files`. E0617, E0751, E0752.
std::optional<Network> read_onnx(std::string_view bytes, std::string_view output,
                                 const FilesInFolder& files, PolicyProblem& problem);

}  // namespace eagerx::gen
