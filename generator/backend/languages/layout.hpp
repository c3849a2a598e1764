// Layout of a part of a placed graph for programs in languages other than C++: its messages, their
// order on the line, its nodes and when they run.
#pragma once

#include <cstdint>
#include <runtime/host/base/hash.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "generator/graph/plan/plan.hpp"
#include "generator/graph/resolve/needs.hpp"

namespace eagerx::gen {

/// A message that crosses the line of the part.
struct LayoutMessage {
  std::size_t channel = 0;  // of Plan::channels
  std::string unit;
  bool to_hub = false;
  std::uint64_t offset = 0;  // in what its node sends over the line at a tick
  std::uint64_t bytes = 0;
  std::uint64_t keep = 1;  // messages that readers look back at
};

/// The behavior of a node at its ticks: it runs in the part, or its messages come over the line.
struct LayoutTurn {
  std::size_t node = 0;
  bool runs = false;
  std::vector<std::size_t> messages;  // of PartLayout::messages, as they follow each other
};

struct PartLayout {
  std::size_t part = 0;  // of Placement::parts
  std::vector<LayoutMessage> messages;
  std::vector<std::size_t> actions;       // of the step that begins
  std::vector<LayoutTurn> before, after;  // in every slot, up to and from the environment
  /// The message of an output, or messages.size().
  [[nodiscard]] std::size_t find(const Plan& plan, std::size_t node, std::size_t output) const;
};

/// `plan` is of a placed graph.
PartLayout layout_of_part(const Plan& plan, std::size_t part);

/// The hash that the hub and one part agree on, as hash_of_part() of eagerx/link/frame.hpp: FNV-1a
/// continued from the hash of the graph.
inline std::uint64_t hash_of_part(std::uint64_t graph, std::string_view part) {
  return host::fnv1a(part, graph);
}

/// Reports features of a part that only C++ supports: E0350.
void check_languages(const Plan& plan, std::size_t part, Diagnostics& diagnostics);

/// Its file name next to the program of a part.
inline constexpr const char* kLayoutFile = "part.json";
/// Its text. `hash`: of the part.
std::string layout_json(const Plan& plan, const PartLayout& layout, std::uint64_t hash,
                        const std::string& version);

}  // namespace eagerx::gen
