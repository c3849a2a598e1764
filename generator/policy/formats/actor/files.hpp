// Files of tensors to networks.
#pragma once

#include <optional>
#include <string_view>

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/network/network.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// The actor in the bytes of a safetensors file, without setting `file`; or the reason why it
/// cannot be read.
std::optional<Network> read_safetensors(std::string_view bytes, const ReadContext& context,
                                        PolicyProblem& problem);

/// The same of a zip archive: Stable-Baselines3, torch.save, npz.
std::optional<Network> read_zip_policy(const Archive& archive, const ReadContext& context,
                                       PolicyProblem& problem);

/// The same for files of torch.save before 1.6.
std::optional<Network> read_legacy_torch_policy(std::string_view bytes, const ReadContext& context,
                                                PolicyProblem& problem);

}  // namespace eagerx::gen
