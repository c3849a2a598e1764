// What templates/cpp/policy.hpp.mustache shows of a network.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>

#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// Keys: file, format, inputs, outputs, parameters, bytes, layers (each: number, inputs, outputs,
/// activation, slope, weights, biases, input, output, hidden, plain, norm, gamma, beta, epsilon),
/// normalization (source, mean, deviation, clip), has_rows, rows, self_test (each: observation,
/// answer). The template also needs `namespace`, the graph's. `real`: the type of its numbers.
kainjow::mustache::data policy_view(const Network& network, const std::string& real = "float");

}  // namespace eagerx::gen
