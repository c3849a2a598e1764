// TorchScript: the archives of `torch.jit.save`.
#pragma once

#include <optional>

#include "generator/formats/common/problem.hpp"
#include "generator/formats/tensors/archive.hpp"
#include "generator/network/network.hpp"

namespace eagerx::gen {

/// Whether an archive holds a program.
bool is_torchscript(const Archive& archive);

/// The network of its `forward`. E0753 to E0756, and those of ONNX's operators.
std::optional<Network> read_torchscript(const Archive& archive, PolicyProblem& problem);

}  // namespace eagerx::gen
