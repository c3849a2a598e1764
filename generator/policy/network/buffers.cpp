#include "generator/policy/network/buffers.hpp"

#include <algorithm>

namespace eagerx::gen {
namespace {

/// The layer that made the numbers of layer `i`, which may be a slice of a slice; -1: the
/// observation.
std::int32_t maker_of(const Network& network, std::int32_t i) {
  while (i >= 0 && first_of_slice(network.layers[static_cast<std::size_t>(i)])) {
    i = network.taken_by(static_cast<std::size_t>(i)).front();
  }
  return i;
}

/// As last_uses_of, but a slice keeps alive what it is a part of.
std::vector<std::size_t> last_uses_of_memory(const Network& network) {
  std::vector<std::size_t> last(network.layers.size() + 1, 0);
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    for (const std::int32_t from : network.taken_by(i)) {
      last[static_cast<std::size_t>(std::int64_t{maker_of(network, from)} + 1)] = i;
    }
  }
  return last;
}

/// Of the free buffers the smallest that is large enough, else the largest, which grows.
std::optional<std::size_t> best_buffer(const std::vector<std::size_t>& sizes,
                                       const std::vector<std::size_t>& free_after, std::size_t now,
                                       std::size_t wanted) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (free_after[k] >= now) continue;
    const auto is_better = [&](std::size_t other) {
      const bool fits = sizes[k] >= wanted;
      if (fits != (sizes[other] >= wanted)) return fits;
      return fits ? sizes[k] < sizes[other] : sizes[k] > sizes[other];
    };
    if (!best || is_better(*best)) best = k;
  }
  return best;
}

}  // namespace

std::vector<std::size_t> last_uses_of(const Network& network) {
  std::vector<std::size_t> last(network.layers.size() + 1, network.layers.size());
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    for (const std::int32_t from : network.taken_by(i)) {
      last[static_cast<std::size_t>(std::int64_t{from} + 1)] = i;
    }
  }
  return last;
}

std::optional<std::uint32_t> first_of_slice(const Layer& layer) {
  const auto* form = std::get_if<Reorder>(&layer.form);
  const bool plain = form != nullptr && !layer.norm && layer.activation == Activation::identity;
  if (!plain || form->from.empty()) return std::nullopt;
  const std::uint32_t first = form->from.front();
  for (std::size_t i = 0; i < form->from.size(); ++i) {
    if (form->from[i] != first + i) return std::nullopt;
  }
  return first;
}

BufferPlan plan_buffers(const Network& network) {
  const std::vector<std::size_t> last_uses = last_uses_of_memory(network);
  BufferPlan plan;
  std::vector<std::size_t> free_after;  // the last layer that takes what lies in a buffer
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    plan.places.emplace_back();
    const bool is_action = i + 1 == network.layers.size();
    if (is_action || first_of_slice(network.layers[i])) continue;
    const std::size_t wanted = network.layers[i].outputs;
    auto place = best_buffer(plan.sizes, free_after, i, wanted);
    if (!place) {
      place = plan.sizes.size();
      plan.sizes.push_back(0);
      free_after.push_back(0);
    }
    plan.sizes[*place] = std::max(plan.sizes[*place], wanted);
    free_after[*place] = std::max(i, last_uses[i + 1]);
    plan.places.back() = place;
  }
  return plan;
}

}  // namespace eagerx::gen
