// TorchScript: the archives of `torch.jit.save`.
#pragma once

#include <optional>
#include <string>

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// Whether an archive holds a program.
bool is_torchscript(const Archive& archive);

/// The network of its `forward`; for several results, the one at the place `output_name`: "0",
/// "1.0" in a tuple of tuples. E0751: ambiguous, or no such result. E0753 to E0756 (E0755: its
/// inputs could have other sizes), and those of ONNX's operators.
std::optional<Network> read_torchscript(const Archive& archive, const ReadContext& context,
                                        PolicyProblem& problem);

}  // namespace eagerx::gen
