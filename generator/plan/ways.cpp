#include "generator/plan/ways.hpp"

#include <algorithm>
#include <set>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxSteps = 20'000;  // of a search from one actuator

/// In an episode a reset node passes its feedthroughs on and nothing else.
bool passes_on(const GraphNode& node, const Input& input) {
  return !node.is_reset_node() || input.feedthrough;
}

}  // namespace

WayFinder::WayFinder(const Plan& plan) : plan_(plan) {
  make_hops();
  mark_behind_sensors();
  on_way_.assign(hops_.size(), false);
  for (std::size_t n = 0; n < hops_.size(); ++n) {
    for (const Hop& hop : hops_[n]) {
      const Input& input = plan.graph->nodes[n].inputs[hop.input];
      if (!input.actuator) continue;
      steps_ = 0;
      walk(input.written, hop);
      if (steps_ > kMaxSteps) shortest(input.written, hop);
    }
  }
}

void WayFinder::make_hops() {
  const auto& nodes = plan_.graph->nodes;
  hops_.resize(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t i = 0; i < nodes[n].inputs.size(); ++i) {
      if (!passes_on(nodes[n], nodes[n].inputs[i])) continue;
      const Input& input = nodes[n].inputs[i];
      if (auto hop = make_hop(plan_, n, i)) {
        hops_[n].push_back(*hop);
      } else if (input.actuator || nodes[n].role == NodeRole::environment ||
                 nodes[n].role == NodeRole::node) {
        unknown_.push_back(&input);
      }
    }
  }
}

void WayFinder::mark_behind_sensors() {
  const auto& nodes = plan_.graph->nodes;
  reached_.assign(nodes.size(), false);
  std::vector<std::vector<std::size_t>> readers(nodes.size());
  std::vector<std::size_t> todo;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const Hop& hop : hops_[n]) {
      const Input& input = nodes[n].inputs[hop.input];
      if (nodes[n].role == NodeRole::engine_node || nodes[n].role == NodeRole::engine) continue;
      readers[input.source_node].push_back(n);
      if (!sensor_of(hop).empty()) todo.push_back(n);
    }
  }
  while (!todo.empty()) {
    const std::size_t node = todo.back();
    todo.pop_back();
    if (reached_[node]) continue;
    reached_[node] = true;
    todo.insert(todo.end(), readers[node].begin(), readers[node].end());
  }
}

const std::string& WayFinder::sensor_of(const Hop& hop) const {
  const Input& input = plan_.graph->nodes[hop.node].inputs[hop.input];
  return plan_.graph->nodes[input.source_node].outputs[input.source_output].sensor;
}

std::vector<const Hop*> WayFinder::behind(const Hop& hop) const {
  const Input& input = plan_.graph->nodes[hop.node].inputs[hop.input];
  const GraphNode& source = plan_.graph->nodes[input.source_node];
  std::vector<const Hop*> result;
  if (!reached_[input.source_node]) return result;
  for (const Hop& next : hops_[input.source_node]) {
    // Each output of a reset node has a feedthrough of its own.
    const Input& read = source.inputs[next.input];
    if (read.feedthrough && read.name != source.outputs[input.source_output].name) continue;
    result.push_back(&next);
  }
  return result;
}

void WayFinder::walk(const std::string& actuator, const Hop& hop) {
  if (++steps_ > kMaxSteps) return;
  const std::size_t source = plan_.graph->nodes[hop.node].inputs[hop.input].source_node;
  way_.push_back(&hop);
  if (const std::string& sensor = sensor_of(hop); !sensor.empty()) {
    keep(sensor, actuator, way_, true);
  } else if (!on_way_[source]) {
    on_way_[source] = true;
    for (const Hop* next : behind(hop)) walk(actuator, *next);
    on_way_[source] = false;
  }
  way_.pop_back();
}

/// The way with the least sum to every sensor, from the actuator backwards (Dijkstra).
void WayFinder::shortest(const std::string& actuator, const Hop& first) {
  std::map<const Hop*, std::pair<std::int64_t, const Hop*>> best;  // sum, the hop after it
  std::set<std::pair<std::int64_t, const Hop*>> open;
  best[&first] = {first.newest_bound, nullptr};
  open.insert({first.newest_bound, &first});
  std::set<std::string> found;
  while (!open.empty()) {
    const auto [sum, hop] = *open.begin();
    open.erase(open.begin());
    if (const std::string& sensor = sensor_of(*hop); !sensor.empty()) {
      if (!found.insert(sensor).second) continue;
      std::vector<const Hop*> way;
      for (const Hop* at = hop; at != nullptr; at = best[at].second) way.insert(way.begin(), at);
      keep(sensor, actuator, way, false);
      continue;
    }
    for (const Hop* next : behind(*hop)) {
      const std::int64_t longer = sum + next->newest_bound;
      const auto known = best.find(next);
      if (known != best.end() && known->second.first <= longer) continue;
      if (known != best.end()) open.erase({known->second.first, next});
      best[next] = {longer, hop};
      open.insert({longer, next});
    }
  }
}

void WayFinder::keep(const std::string& sensor, const std::string& actuator,
                     const std::vector<const Hop*>& way, bool complete) {
  Ways& ways = ways_[{sensor, actuator}];
  ways.all.push_back(way);
  ways.complete = ways.complete && complete;
}

}  // namespace eagerx::gen
