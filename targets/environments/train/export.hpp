// Writes a policy as a file for eagerx-gen, with golden answers to check it.
#pragma once

#include <string>

#include "targets/environments/train/policy.hpp"

namespace eagerx::train {

/// safetensors: the layers as `policy.hidden.0.weight` …, `policy.action.bias`, a memory before
/// them as `policy.memory.weight_ih_l0` …, and in the metadata the conditions of the training:
/// names and sizes of the observations, bounds of the actions, rate, hash of the graph's contract,
/// seed, settings.
std::string safetensors_of(const Policy& policy, const Description& description,
                           const Settings& settings);

/// Observations with their answers as CSV: obs0 …, network_out…, action…. `rows` [count][inputs].
/// Of a policy that remembers in episodes, and `episode_start` says where they begin.
std::string golden_rows(const Policy& policy, const Kernels& kernels,
                        const std::vector<float>& rows);

/// "policy.safetensors" → "policy.golden.csv".
std::string golden_path(const std::string& path);

}  // namespace eagerx::train
