// Discrete parts of an observation, encoded as Stable-Baselines3's preprocess_obs does for its
// networks.
#include <fmt/core.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/policy/formats/actor/parts.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Which number of the observation each result comes from, and which choice it stands for.
struct OneHotPlaces {
  std::vector<std::uint32_t> from;
  std::vector<float> choice;
};

/// max(0, 1 - |x - choice|), which is exact for whole numbers.
void add_hats(const OneHotPlaces& hats, std::uint32_t inputs, Network& network) {
  using Operation = Elementwise::Operation;
  const auto size = static_cast<std::uint32_t>(hats.from.size());
  const auto add = [&](LayerForm form, std::vector<float> with) {
    network.layers.push_back(layer_of(std::move(form), size, size, std::move(with)));
  };
  network.layers.push_back(layer_of(Reorder{hats.from}, inputs, size));
  add(Elementwise{Operation::subtract}, hats.choice);
  add(Function{Function::Kind::abs}, {});
  add(Elementwise{Operation::multiply}, {-1.0F});
  add(Elementwise{Operation::add}, {1.0F});
  network.layers.back().activation = Activation::relu;
}

}  // namespace

bool add_one_hot(const ActorParts& parts) {
  const std::vector<std::uint32_t>& counts = parts.facts.contract.choices;
  if (ranges::all_of(counts, [](std::uint32_t count) { return count == 0; })) return true;
  const auto inputs = static_cast<std::uint32_t>(counts.size());
  OneHotPlaces hats;
  std::vector<std::uint32_t> plain;                   // numbers that stay as they are
  std::vector<std::pair<bool, std::uint32_t>> order;  // of the results: of a choice, and where
  for (std::uint32_t i = 0; i < inputs; ++i) {
    if (static_cast<std::int64_t>(hats.from.size()) + counts[i] > kMaxValues) {
      return parts.fail("E0619", fmt::format("has more than {} choices", kMaxValues),
                        "use a smaller observation space");
    }
    if (counts[i] == 0) {
      order.emplace_back(false, static_cast<std::uint32_t>(plain.size()));
      plain.push_back(i);
    }
    for (std::uint32_t choice = 0; choice < counts[i]; ++choice) {
      order.emplace_back(true, static_cast<std::uint32_t>(hats.from.size()));
      hats.from.push_back(i);
      hats.choice.push_back(static_cast<float>(choice));
    }
  }
  const auto ones = static_cast<std::uint32_t>(hats.from.size());
  add_hats(hats, inputs, parts.network);
  if (plain.empty()) return true;
  const auto rest = static_cast<std::uint32_t>(plain.size());
  const auto last = static_cast<std::int32_t>(parts.network.layers.size()) - 1;
  parts.network.layers.push_back(layer_of(Reorder{plain}, inputs, rest));
  parts.network.layers.back().takes = {-1};
  Layer join =
      layer_of(Combination{Combination::Operation::join, {ones, rest}}, ones + rest, ones + rest);
  join.takes = {last, last + 1};
  parts.network.layers.push_back(std::move(join));
  std::vector<std::uint32_t> from;
  from.reserve(order.size());
  for (const auto& [is_choice, at] : order) from.push_back(is_choice ? at : ones + at);
  const auto all = static_cast<std::uint32_t>(from.size());
  parts.network.layers.push_back(layer_of(Reorder{std::move(from)}, ones + rest, all));
  return true;
}

}  // namespace eagerx::gen
