// Answers of one layer, with the bits of generated programs, and in float64.
#pragma once

#include <vector>

#include "generator/policy/network/layer.hpp"

namespace eagerx::gen {

/// The result of `layer` for `x`, before norm and activation. `memory` is its state: empty for
/// nothing yet; changed by layers that remember.
std::vector<float> evaluate_layer(const Layer& layer, const std::vector<float>& x,
                                  std::vector<float>& memory);
std::vector<double> evaluate_layer(const Layer& layer, const std::vector<double>& x,
                                   std::vector<double>& memory);

}  // namespace eagerx::gen
