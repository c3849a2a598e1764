#pragma once

#include "generator/analysis/size/size.hpp"

namespace eagerx::gen {

/// The deepest stack of the program in `image`, from its start-up code on. `build` has the .ci
/// files of its sources. The calls are not assigned to nodes yet. Interrupts need additional stack.
StackBound stack_bound(const std::string& prefix, const std::string& image,
                       const std::string& build);

}  // namespace eagerx::gen
