// Sixteen samples side by side, the unit of the networks.
#pragma once

#include <cstddef>
#include <vector>

namespace eagerx::train {

/// Samples in a pack, on every machine: the order of sums, and with it the bits, depends on it.
inline constexpr std::size_t kLanes = 16;

/// One number of sixteen samples.
struct alignas(64) Pack {
  float lane[kLanes];
};

/// [rows of one number each], for example [inputs] of one tile (sixteen samples).
using Packs = std::vector<Pack>;

}  // namespace eagerx::train
