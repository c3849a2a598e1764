// The first half of a layout: finds the wires that run backwards, and the layer of each box.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/tools/drawing/drawing.hpp"

namespace eagerx::gen {

struct Layers {
  std::vector<std::size_t> layer;  // of each box
  std::vector<bool> backwards;     // of each wire
  std::size_t count = 1;
};

Layers layers_of(const Drawing& drawing);

}  // namespace eagerx::gen
