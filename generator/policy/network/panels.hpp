// Storage of dense weights: panels of outputs that are computed side by side.
#pragma once

#include <cstddef>
#include <vector>

namespace eagerx::gen {

/// Outputs `first` to `last`, and zeros up to `end`.
struct Panel {
  std::size_t first, last, end;
};
std::vector<Panel> panels_of(std::size_t outputs);

/// Number of stored outputs: full panels, the rest padded to a power of two.
std::size_t padded_outputs(std::size_t outputs);

}  // namespace eagerx::gen
