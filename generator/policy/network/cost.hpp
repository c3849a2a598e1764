// Descriptions of layers, and their costs.
#pragma once

#include <cstddef>
#include <string>

#include "generator/policy/network/layer.hpp"

namespace eagerx::gen {

/// For people: " relu", " gru", " convolution 3x3 relu"; empty for a dense layer without
/// activation.
std::string note_of(const Layer& layer);

struct LayerCost {
  std::size_t parameters = 0;
  std::size_t bytes = 0;          // of flash
  std::size_t multiply_adds = 0;  // of one answer
};
LayerCost cost_of(const Layer& layer);

}  // namespace eagerx::gen
