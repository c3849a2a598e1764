// Answers of a policy, as the generated program computes them and without rounding.
#pragma once

#include <optional>
#include <vector>

#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// The observation as the first layer takes it: through VecNormalize's statistics, if there are
/// any.
std::vector<float> normalized(const Network& network, std::vector<float> observation);

/// The state of a network from one observation to the next, layer by layer; empty: none yet.
template <class Real>
using Memory = std::vector<std::vector<Real>>;

/// The network's outputs for a (normalised) input, with the bits of the generated program. Without
/// `memory` the input is the first one of its episode.
std::vector<float> evaluate(const Network& network, std::vector<float> input,
                            Memory<float>* memory = nullptr);

/// The same, with the results of all layers, the last of which is the outputs.
std::vector<std::vector<float>> results_of_layers(const Network& network, std::vector<float> input,
                                                  Memory<float>* memory = nullptr);

/// The same in float64, with the weights of the file.
std::vector<double> evaluate_in_double(const Network& network, const std::vector<float>& input,
                                       Memory<double>* memory = nullptr);

/// Outputs as an action, as predict(deterministic=True) has it: squashed outputs are mapped to the
/// bounds of the contract, others clipped to them; argmax: one number for each choice; binary: 0
/// and
/// 1. Without bounds nothing, but for choices.
std::optional<std::vector<double>> action_of(const Network& network,
                                             const std::vector<double>& outputs);

}  // namespace eagerx::gen
