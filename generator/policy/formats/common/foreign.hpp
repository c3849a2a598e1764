// Files that are not a policy in a supported format: what they are, and how to convert them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {

/// The formats that are read, as help.
inline constexpr const char* kKnownFormats =
    "the formats are Stable-Baselines3's zip, ONNX, TorchScript, safetensors, npz and torch.save";

/// The help for arrays of JAX.
inline constexpr const char* kJaxWay =
    "write the actor's weights as npz with torch's names (`net.0.weight` [outputs, inputs], "
    "`net.0.bias`)";

/// E0603 with the name of the format, recognized by the first bytes; nullopt if it is unknown.
std::optional<PolicyProblem> foreign_file(std::string_view bytes);

/// The same of a zip archive with entries `names` that is no policy.
PolicyProblem foreign_archive(const std::vector<std::string>& names);

/// The same for a folder with entries `names`, if the program that wrote it is known.
std::optional<PolicyProblem> foreign_folder(const std::vector<std::string>& names);

}  // namespace eagerx::gen
