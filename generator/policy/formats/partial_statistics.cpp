#include "generator/policy/formats/partial_statistics.hpp"

#include <fmt/core.h>

#include <limits>
#include <utility>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Puts `layers`, a chain, between the observation and the existing layers.
void put_in_front(Network& network, std::vector<Layer> layers) {
  const auto count = static_cast<std::int32_t>(layers.size());
  for (Layer& layer : network.layers) {
    for (std::int32_t& from : layer.takes) from += count;  // -1 becomes the last one in front
  }
  network.layers.insert(network.layers.begin(), std::make_move_iterator(layers.begin()),
                        std::make_move_iterator(layers.end()));
}

/// VecNormalize clips what it normalises: `clips` says which numbers these are.
void clip_in_front(Network& network, const std::vector<bool>& clips, double clip) {
  using Operation = Elementwise::Operation;
  const std::uint32_t count = network.inputs();
  std::vector<float> lowest, highest;
  for (const bool is_clipped : clips) {
    const float most = is_clipped ? static_cast<float>(clip) : std::numeric_limits<float>::max();
    lowest.push_back(-most);
    highest.push_back(most);
  }
  put_in_front(network,
               {layer_of(Elementwise{Operation::at_least}, count, count, std::move(lowest)),
                layer_of(Elementwise{Operation::at_most}, count, count, std::move(highest))});
}

}  // namespace

bool are_partial(const Normalization& statistics, const Network& network) {
  const std::vector<NamedPart>& all = network.contract.observations;
  return !statistics.parts.empty() && statistics.parts.size() < all.size() &&
         ranges::all_of(statistics.parts, [&](const NamedPart& part) {
           return ranges::find(all, part.name, &NamedPart::name) != all.end();
         });
}

bool complete_statistics(Normalization& statistics, Network& network, const std::string& policy,
                         PolicyProblem& problem) {
  const std::vector<std::uint32_t>& choices = network.contract.choices;
  Normalization whole = statistics;
  whole.mean.clear();
  whole.variance.clear();
  whole.epsilon = 0.0;  // it is in the variances: those of the others are 1 exactly
  whole.parts = network.contract.observations;
  std::vector<bool> clips;
  for (const NamedPart& part : whole.parts) {
    std::size_t at = 0;  // of the part's first number in the statistics
    const NamedPart* known = nullptr;
    for (const NamedPart& candidate : statistics.parts) {
      if (candidate.name == part.name) {
        known = &candidate;
        break;
      }
      at += static_cast<std::size_t>(candidate.size);
    }
    if (known != nullptr && known->size != part.size) {
      return refuse(problem, "E0627",
                    fmt::format("normalise {} numbers of `{}`, of which the policy `{}` takes {}",
                                known->size, printable(part.name), policy, part.size),
                    "name the statistics that were saved with this policy");
    }
    for (std::size_t i = 0; i < part.size; ++i) {
      const std::size_t place = clips.size();
      if (known != nullptr && place < choices.size() && choices[place] > 0) {
        return refuse(problem, "E0627",
                      fmt::format("normalise `{}`, which the policy `{}` takes as choices",
                                  printable(part.name), policy),
                      "name the statistics that were saved with this policy");
      }
      clips.push_back(known != nullptr);
      whole.mean.push_back(known != nullptr ? statistics.mean[at + i] : 0.0);
      whole.variance.push_back(known != nullptr ? statistics.variance[at + i] + statistics.epsilon
                                                : 1.0);
    }
  }
  if (clips.size() != network.inputs()) return true;  // the caller compares sizes
  if (whole.clip < static_cast<double>(std::numeric_limits<float>::max())) {
    clip_in_front(network, clips, whole.clip);
  }
  whole.clip = std::numeric_limits<double>::max();
  statistics = std::move(whole);
  return true;
}

}  // namespace eagerx::gen
