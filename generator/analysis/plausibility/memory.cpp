// Budgets that name nothing, and buffers that do not fit into their memory.
#include <fmt/format.h>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/backend/program_map/program_map.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

void check_budget_names(const CheckedGraph& checked, const std::vector<NodeBudgetSpec>& nodes,
                        Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const auto& node : checked.graph.nodes) {
    if (node.role != NodeRole::environment) known.push_back(node.name);
  }
  for (const auto& [name, flash, ram] : nodes) {
    if (contains(known, name.value) || ranges::contains(kSharedParts, name.value)) continue;
    diagnostics.error("E0421", name.span, fmt::format("there is no node `{}`", name.value)).help =
        suggestion(name.value, known);
  }
}

std::uint64_t bytes_of_ring(const CheckedGraph& checked, const Ring& ring) {
  return ring.capacity * (bytes_of(ring.space) + (checked.graph.asynchronous ? 8 : 0));
}

/// The buffers of the program, or of the part that runs on the board.
struct Buffers {
  std::uint64_t bytes = 0;
  std::optional<std::size_t> largest;  // a ring
};

/// Those of one part; of a whole graph all.
Buffers buffers_of(const CheckedGraph& checked, std::optional<std::size_t> part) {
  Buffers result;
  const auto& rings = checked.plan.rings;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (part && checked.graph.placement->part_of[rings[r].node] != *part) continue;
    if (checked.graph.nodes[rings[r].node].drawn) continue;  // a board has none of them
    const std::uint64_t bytes = bytes_of_ring(checked, rings[r]);
    result.bytes += bytes;
    if (!result.largest || bytes_of_ring(checked, rings[*result.largest]) < bytes)
      result.largest = r;
  }
  return result;
}

/// The input that needs the most messages of the ring; nullptr if no input reads it.
const Input* neediest(const CheckedGraph& checked, std::size_t ring) {
  const Input* result = nullptr;
  std::uint64_t most = 0;
  for (std::size_t n = 0; n < checked.plan.nodes.size(); ++n) {
    const auto& receptions = checked.plan.nodes[n].receptions;
    for (std::size_t i = 0; i < receptions.size(); ++i) {
      if (receptions[i].ring != ring || receptions[i].keep <= most) continue;
      most = receptions[i].keep;
      result = &checked.graph.nodes[n].inputs[i];
    }
  }
  return result;
}

/// `place` of the limit; without one it is the connection that needs the most.
void report(const CheckedGraph& checked, const Buffers& buffers, std::optional<Span> place,
            std::uint64_t room, const std::string& whose, Diagnostics& diagnostics) {
  if (!buffers.largest || buffers.bytes <= room) return;
  const Ring& ring = checked.plan.rings[*buffers.largest];
  const Output& output = checked.graph.nodes[ring.node].outputs[ring.output];
  const Input* input = neediest(checked, *buffers.largest);
  const Span largest = input != nullptr ? input->span : output.span;
  const std::string needs = input != nullptr ? fmt::format("`{}` needs them", input->written) : "";
  auto& problem = diagnostics.error(
      "E0423", place.value_or(largest),
      fmt::format("the buffers take {} bytes of RAM, and {} {}", buffers.bytes, whose, room));
  problem.notes.push_back(
      {fmt::format("the largest, of `{}`, holds {} messages and takes {} bytes",
                   input != nullptr ? name_of_source(checked.graph, *input) : output.name,
                   ring.capacity, bytes_of_ring(checked, ring)),
       largest, input != nullptr && place ? needs : ""});
  if (!place) problem.label = needs;
  problem.help = "shorten the delay or the window, or lower the rate of what is sent";
}

}  // namespace

void check_memory(const CheckedGraph& checked, Diagnostics& diagnostics) {
  std::optional<Spanned<std::uint64_t>> ram;
  if (const auto& budget = checked.spec.budget) {
    if (budget->nodes) check_budget_names(checked, *budget->nodes, diagnostics);
    ram = budget->ram;
  }
  const auto check = [&](std::optional<std::size_t> part,
                         const std::vector<const Target*>& targets) {
    const Buffers buffers = buffers_of(checked, part);
    if (ram) report(checked, buffers, ram->span, ram->value, "the budget is", diagnostics);
    for (const Target* target : targets) {
      if (!target->ram_bytes) continue;
      report(checked, buffers, std::nullopt, *target->ram_bytes,
             fmt::format("`{}` has", target->id.value), diagnostics);
    }
  };
  if (!checked.graph.placement) return check(std::nullopt, checked.targets);
  for (std::size_t part = 0; part < checked.graph.placement->parts.size(); ++part)
    check(part, {checked.graph.placement->parts[part].target});
}

}  // namespace eagerx::gen
