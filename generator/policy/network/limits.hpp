// The largest files and networks that are read. Larger ones are rejected before they take memory or
// time.
#pragma once

#include <cstddef>
#include <cstdint>

namespace eagerx::gen {

/// Of a file with weights. A 1024-1024-512 network has 6 MB.
inline constexpr std::size_t kMaxPolicyBytes = std::size_t{64} << 20U;

/// As many parameters as the largest file can hold.
inline constexpr std::int64_t kMaxParameters = std::int64_t{16} << 20U;
inline constexpr std::size_t kMaxLayers = 256;

/// Values between two layers, which a robot must keep in RAM.
inline constexpr std::int64_t kMaxValues = std::int64_t{1} << 22U;

/// Products in one layer: more than a robot can compute in a step, or a generator in a minute.
inline constexpr std::int64_t kMaxProducts = std::int64_t{1} << 30U;

}  // namespace eagerx::gen
