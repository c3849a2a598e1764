#include "generator/graph/plan/split.hpp"

#include <algorithm>

#include "generator/graph/plan/pipelining.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

// Longer ones gain nothing on a serial line: eleven bytes of a frame are 1 % of it. A program for
// Linux has memory for an image, which is then one exchange.
constexpr std::size_t kLargestPayload = 1024;
constexpr std::size_t kLargestOnLinux = std::size_t{1} << 16U;
constexpr std::size_t kGreeting = 16;  // eagerx/link/frame.hpp
constexpr std::size_t kCommand = 2;    // eagerx/link/stream.hpp
constexpr std::size_t kReset = 18;

/// Follows the messages over one link through a hyperperiod, as the two programs do.
class Line {
 public:
  Line(const Plan& plan, const PartLink& link, std::size_t part) : plan_(plan), part_(part) {
    const Graph& graph = *plan.graph;
    bytes_.resize(graph.nodes.size());
    for (std::size_t c = 0; c < plan.channels.size(); ++c) {
      const Channel& channel = plan.channels[c];
      const std::size_t bytes = bytes_of(graph.nodes[channel.node].outputs[channel.output].space);
      if (link.to_part[c] || link.to_hub[c]) bytes_[channel.node] += bytes;
    }
    // Whether a reset node has reached its targets.
    for (const auto& node : graph.nodes) done_ += node.reset_targets.size();
  }

  /// One slot; `mask` is what is due in it, `next` in the one after it.
  void slot(std::uint64_t mask, std::uint64_t next) {
    if (due(Graph::kEnvironment, mask)) {
      to_part(kCommand);
      node(Graph::kEnvironment, mask);
      ++steps_;
    }
    for (const std::size_t n : plan_.after) node(n, mask);
    for (const std::size_t n : plan_.before) node(n, next);
  }
  void start_counting() { exchanges_ = steps_ = part_bytes_ = hub_bytes_ = 0; }

  /// `link` with what it needs for its messages.
  [[nodiscard]] PartLink measured(PartLink link) const {
    const Target& target = *plan_.graph->placement->parts[part_].target;
    const std::size_t largest = target.system.empty() ? kLargestPayload : kLargestOnLinux;
    const std::size_t to_part = std::max(most_part_, run_part_) + kReset;
    const std::size_t to_hub = std::max(most_hub_, run_hub_) + done_;
    link.part_payload = std::clamp(to_part, kGreeting, largest);
    link.hub_payload = std::clamp(to_hub, kGreeting, largest);
    link.several_frames = std::max(to_part, to_hub) > largest;
    if (steps_ == 0) return link;
    const auto per_step = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(steps_);
    };
    link.exchanges = per_step(exchanges_);
    link.part_bytes = per_step(part_bytes_);
    link.hub_bytes = per_step(hub_bytes_);
    return link;
  }

 private:
  bool due(std::size_t n, std::uint64_t mask) const {
    return (mask >> plan_.nodes[n].rate & 1U) != 0;
  }
  void node(std::size_t n, std::uint64_t mask) {
    if (!due(n, mask) || bytes_[n] == 0) return;
    plan_.graph->placement->part_of[n] == part_ ? to_hub(bytes_[n]) : to_part(bytes_[n]);
  }
  void to_part(std::size_t bytes) {
    most_hub_ = std::max(most_hub_, run_hub_);
    run_hub_ = 0;
    run_part_ += bytes;
    part_bytes_ += bytes;
  }
  void to_hub(std::size_t bytes) {
    // The hub asks for the first message after some of its own.
    if (run_hub_ == 0) ++exchanges_;
    most_part_ = std::max(most_part_, run_part_);
    run_part_ = 0;
    run_hub_ += bytes;
    hub_bytes_ += bytes;
  }

  const Plan& plan_;
  std::size_t part_;
  std::vector<std::size_t> bytes_;  // of what a node sends over the link at a tick
  std::size_t done_ = 0;
  std::size_t run_part_ = 0, run_hub_ = 0, most_part_ = 0, most_hub_ = 0;
  std::size_t exchanges_ = 0, steps_ = 0, part_bytes_ = 0, hub_bytes_ = 0;
};

/// Whether a node of the part, or the agent in it, reads the message.
bool is_read_in(const Graph& graph, std::size_t part, std::size_t node, std::size_t output) {
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    if (graph.placement->part_of[n] != part) continue;
    for (const auto& input : graph.nodes[n].inputs)
      if (input.source_node == node && input.source_output == output) return true;
  }
  return false;
}

PartLink find_messages(const Plan& plan, std::size_t part) {
  PartLink link;
  const Graph& graph = *plan.graph;
  link.to_part.resize(plan.channels.size());
  link.to_hub.resize(plan.channels.size());
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    const Channel& channel = plan.channels[c];
    const bool is_there = graph.placement->part_of[channel.node] == part;
    // The hub's trace has every message.
    link.to_hub[c] = is_there;
    link.to_part[c] = !is_there && is_read_in(graph, part, channel.node, channel.output);
  }
  return link;
}

PartLink make_link(const Plan& plan, std::size_t part) {
  PartLink link = find_messages(plan, part);
  Line line(plan, link, part);
  std::vector<std::uint64_t> masks = plan.schedule.masks;
  // A hyperperiod too long for a table: as if all rates were due at once, which is the most.
  if (masks.empty()) masks = {~std::uint64_t{0}};
  constexpr int kPasses = 2;  // the first one leads in
  for (int pass = 0; pass < kPasses; ++pass) {
    line.start_counting();
    for (std::size_t i = 0; i < masks.size(); ++i)
      line.slot(masks[i], masks[(i + 1) % masks.size()]);
  }
  link = line.measured(std::move(link));
  if (plan.schedule.masks.empty()) link.exchanges = link.part_bytes = link.hub_bytes = 0.0;
  return link;
}

/// All parts but `but`, which may be the hub.
std::vector<std::size_t> other_parts(const Graph& graph, std::size_t but) {
  std::vector<std::size_t> others;
  for (std::size_t part = 0; part < graph.placement->parts.size(); ++part)
    if (part != but) others.push_back(part);
  return others;
}

}  // namespace

Split make_split(const Plan& plan) {
  Split split;
  for (std::size_t part = 0; part < plan.graph->placement->parts.size(); ++part)
    split.links.push_back(make_link(plan, part));
  plan_pipelining(plan, split);
  return split;
}

LinkUse link_use(const Plan& plan, Part part, std::size_t node, std::size_t output) {
  LinkUse use;
  if (part == Part::whole) return use;
  const auto channel = ranges::find_if(plan.channels, [&](const Channel& item) {
    return item.node == node && item.output == output;
  });
  if (channel == plan.channels.end()) return use;
  const auto c = static_cast<std::size_t>(channel - plan.channels.begin());
  const auto& links = plan.split->links;
  if (part.is_placed()) {
    if (links[part.index()].to_hub[c]) use.to = {part.index()};
    if (links[part.index()].to_part[c]) use.from = part.index();
    return use;
  }
  for (std::size_t other = 0; other < links.size(); ++other) {
    if (links[other].to_hub[c]) use.from = other;
    if (links[other].to_part[c]) use.to.push_back(other);
  }
  return use;
}

LinkUse link_use_of_flags(const Graph& graph, Part part, std::size_t node) {
  LinkUse use;
  if (part == Part::whole) return use;
  const std::size_t owner = graph.placement->part_of[node];
  if (part.is_placed()) {
    (owner == part.index() ? use.to.emplace_back() : use.from.emplace()) = part.index();
    return use;
  }
  if (owner != Placement::kHub) use.from = owner;
  use.to = other_parts(graph, owner);
  return use;
}

bool is_pipelined(const Plan& plan, Part part, std::size_t node) {
  if (part != Part::hub || plan.graph->nodes[node].outputs.empty()) return false;
  const std::size_t owner = plan.graph->placement->part_of[node];
  return owner != Placement::kHub && plan.split->links[owner].is_pipelined;
}

}  // namespace eagerx::gen
