// Buffers for the results of layers, and which results share memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "generator/policy/network/network.hpp"

namespace eagerx::gen {

/// The last layer that takes a value: [0] of the observation, [i + 1] of the result of layer i.
/// A value that no layer takes lasts to the end.
std::vector<std::size_t> last_uses_of(const Network& network);

/// The first number that a layer takes if it takes neighbours in their order: its result is a part
/// of its input, and needs no memory.
std::optional<std::uint32_t> first_of_slice(const Layer& layer);

/// Buffers of a network with branches. The result of a layer is stored in a buffer whose previous
/// values are no longer needed, so that a layer's input and result never overlap.
struct BufferPlan {
  std::vector<std::size_t> sizes;                  // numbers of each buffer
  std::vector<std::optional<std::size_t>> places;  // of each layer; nothing: a slice, the action
};
BufferPlan plan_buffers(const Network& network);

}  // namespace eagerx::gen
