// Sixteen samples side by side, the unit of the networks.
#pragma once

#include <cstddef>
#include <vector>

namespace eagerx::train {

/// Samples in a SIMD vector, on every machine: the order of sums and so the bits depend on it.
inline constexpr std::size_t kLanes = 16;

/// One number of sixteen samples.
struct alignas(64) Simd {
  float lane[kLanes];
};

/// [rows of one number each], for example [inputs] of one tile (sixteen samples).
using Simds = std::vector<Simd>;

}  // namespace eagerx::train
