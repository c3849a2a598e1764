// Which boxes of a drawing are in which composite.
#pragma once

#include <vector>

#include "generator/tools/drawing/drawing.hpp"

namespace eagerx::gen {

/// Fills the groups of a drawing that has all its boxes.
void add_groups(const std::vector<CompositeSpec>& composites, Drawing& drawing);

}  // namespace eagerx::gen
