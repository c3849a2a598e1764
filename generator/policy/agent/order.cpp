#include "generator/policy/agent/order.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Of `parts` those of this size whose names `others` do not have.
std::vector<std::string> unknown(const std::vector<NamedPart>& parts,
                                 const std::vector<NamedPart>& others, std::uint64_t size) {
  std::vector<std::string> names;
  for (const NamedPart& part : parts) {
    const bool known = ranges::contains(others, part.name, &NamedPart::name);
    if (!known && part.size == size) names.push_back(part.name);
  }
  return names;
}

}  // namespace

std::optional<TrainingOrder> order_of_training(const std::vector<NamedPart>& theirs,
                                               const std::vector<NamedPart>& ours) {
  TrainingOrder order;
  for (const NamedPart& part : theirs) {
    if (ranges::contains(ours, part.name, &NamedPart::name)) {
      order.names.push_back(part.name);
      continue;
    }
    const auto may_be = unknown(ours, theirs, part.size);
    if (may_be.size() != 1 || unknown(theirs, ours, part.size).size() != 1) return std::nullopt;
    order.names.push_back(may_be.front());
    order.renamed.push_back(
        fmt::format("`{}`, if it is the `{}` of the training", may_be.front(), part.name));
  }
  return order.names.size() == ours.size() ? std::optional(order) : std::nullopt;
}

}  // namespace eagerx::gen
