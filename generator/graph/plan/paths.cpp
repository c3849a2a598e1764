#include "generator/graph/plan/paths.hpp"

#include <algorithm>
#include <set>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxSteps = 20'000;  // of a search from one destination

/// In an episode a reset node passes its feedthroughs on and nothing else.
bool passes_on(const GraphNode& node, const Input& input) {
  return !node.is_reset_node() || input.feedthrough;
}

}  // namespace

PathEnds usual_ends(const Graph& graph) {
  const bool engine = graph.has_engine();
  return {!engine, !engine, engine};
}

std::vector<std::string> names_of_sources(const Graph& graph, bool actions) {
  std::set<std::string> names;
  for (const GraphNode& node : graph.nodes) {
    for (const Output& output : node.outputs) {
      if (actions && node.role == NodeRole::environment) names.insert("actions." + output.name);
      if (!actions) names.insert(output.sensors.begin(), output.sensors.end());
    }
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> names_of_destinations(const Graph& graph, bool observations) {
  std::set<std::string> names;
  for (const GraphNode& node : graph.nodes) {
    for (const Input& input : node.inputs) {
      if (observations ? node.role == NodeRole::environment : input.actuator)
        names.insert(input.written);
    }
  }
  return {names.begin(), names.end()};
}

PathFinder::PathFinder(const Plan& plan, const PathEnds& ends) : plan_(plan), ends_(ends) {
  make_edges();
  mark_behind_sources();
  on_path_.assign(edges_.size(), false);
  for (std::size_t n = 0; n < edges_.size(); ++n) {
    for (const PathEdge& edge : edges_[n]) {
      const Input& input = plan.graph->nodes[n].inputs[edge.input];
      if (!is_last(plan.graph->nodes[n], input)) continue;
      steps_ = 0;
      walk(input.written, edge);
      if (steps_ > kMaxSteps) shortest(input.written, edge);
    }
  }
}

bool PathFinder::is_last(const GraphNode& node, const Input& input) const {
  return ends_.to_observations ? node.role == NodeRole::environment : input.actuator;
}

/// Whether a path may lead through a node. It begins at the environment or does not go over it.
bool PathFinder::is_passed(const GraphNode& node) const {
  if (node.role == NodeRole::environment) return ends_.through_agent && !ends_.from_actions;
  return node.role != NodeRole::engine_node && node.role != NodeRole::engine;
}

void PathFinder::make_edges() {
  const auto& nodes = plan_.graph->nodes;
  edges_.resize(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (std::size_t i = 0; i < nodes[n].inputs.size(); ++i) {
      if (!passes_on(nodes[n], nodes[n].inputs[i])) continue;
      const Input& input = nodes[n].inputs[i];
      if (auto edge = make_path_edge(plan_, n, i)) {
        edges_[n].push_back(*edge);
      } else if (input.actuator || nodes[n].role == NodeRole::environment ||
                 nodes[n].role == NodeRole::node) {
        unknown_.emplace_back(n, i);
      }
    }
  }
}

void PathFinder::mark_behind_sources() {
  const auto& nodes = plan_.graph->nodes;
  reached_.assign(nodes.size(), false);
  std::vector<std::vector<std::size_t>> readers(nodes.size());
  std::vector<std::size_t> todo;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const PathEdge& edge : edges_[n]) {
      const Input& input = nodes[n].inputs[edge.input];
      if (!is_passed(nodes[n])) continue;
      readers[input.source_node].push_back(n);
      if (!source_of(edge).empty()) todo.push_back(n);
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

/// The beginning of a path; empty if the path continues.
std::string PathFinder::source_of(const PathEdge& edge) const {
  const Input& input = plan_.graph->nodes[edge.node].inputs[edge.input];
  const GraphNode& source = plan_.graph->nodes[input.source_node];
  const Output& output = source.outputs[input.source_output];
  if (!ends_.from_actions) return input.sensor;
  return source.role == NodeRole::environment ? "actions." + output.name : std::string();
}

std::vector<const PathEdge*> PathFinder::behind(const PathEdge& edge) const {
  const Input& input = plan_.graph->nodes[edge.node].inputs[edge.input];
  const GraphNode& source = plan_.graph->nodes[input.source_node];
  std::vector<const PathEdge*> result;
  if (!reached_[input.source_node]) return result;
  for (const PathEdge& next : edges_[input.source_node]) {
    // Each output of a reset node has a feedthrough of its own.
    const Input& read = source.inputs[next.input];
    if (read.feedthrough && read.name != source.outputs[input.source_output].name) continue;
    result.push_back(&next);
  }
  return result;
}

void PathFinder::walk(const std::string& destination, const PathEdge& edge) {
  if (++steps_ > kMaxSteps) return;
  const std::size_t sender = plan_.graph->nodes[edge.node].inputs[edge.input].source_node;
  path_.push_back(&edge);
  if (const std::string source = source_of(edge); !source.empty()) {
    keep(source, destination, path_, true);
  } else if (!on_path_[sender]) {
    on_path_[sender] = true;
    for (const PathEdge* next : behind(edge)) walk(destination, *next);
    on_path_[sender] = false;
  }
  path_.pop_back();
}

/// The path with the least sum to every source, from the destination backwards (Dijkstra).
void PathFinder::shortest(const std::string& destination, const PathEdge& first) {
  std::map<const PathEdge*, std::pair<std::int64_t, const PathEdge*>>
      best;  // sum, the edge after it
  std::set<std::pair<std::int64_t, const PathEdge*>> open;
  best[&first] = {first.newest_bound, nullptr};
  open.insert({first.newest_bound, &first});
  std::set<std::string> found;
  while (!open.empty()) {
    const auto [sum, edge] = *open.begin();
    open.erase(open.begin());
    if (const std::string source = source_of(*edge); !source.empty()) {
      if (!found.insert(source).second) continue;
      std::vector<const PathEdge*> path;
      for (const PathEdge* at = edge; at != nullptr; at = best[at].second)
        path.insert(path.begin(), at);
      keep(source, destination, path, false);
      continue;
    }
    for (const PathEdge* next : behind(*edge)) {
      const std::int64_t longer = sum + next->newest_bound;
      const auto known = best.find(next);
      if (known != best.end() && known->second.first <= longer) continue;
      if (known != best.end()) open.erase({known->second.first, next});
      best[next] = {longer, edge};
      open.insert({longer, next});
    }
  }
}

void PathFinder::keep(const std::string& source, const std::string& destination,
                      const std::vector<const PathEdge*>& path, bool complete) {
  Paths& paths = paths_[{source, destination}];
  paths.all.push_back(path);
  paths.complete = paths.complete && complete;
}

std::vector<const Input*> PathFinder::unknown_between(const std::string& from,
                                                      const std::string& to) const {
  std::vector<const Input*> result;
  if (unknown_.empty()) return result;
  const auto& nodes = plan_.graph->nodes;
  // Nodes that data reach from `from`, and nodes whose data reach `to`, over all connections.
  std::vector<bool> before(nodes.size(), false), after(nodes.size(), false);
  const auto begins = [&](const PathEdge& edge) {
    const std::string source = source_of(edge);
    return !source.empty() && (from.empty() || source == from);
  };
  const auto ends = [&](std::size_t n, const Input& input) {
    return is_last(nodes[n], input) && (to.empty() || input.written == to);
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      for (std::size_t i = 0; i < nodes[n].inputs.size(); ++i) {
        const Input& input = nodes[n].inputs[i];
        if (!passes_on(nodes[n], input)) continue;
        const PathEdge edge{.node = n, .input = i};
        const std::size_t source = input.source_node;
        if (!before[n] && is_passed(nodes[n]) && (begins(edge) || before[source]))
          more = before[n] = true;
        if (!after[source] && is_passed(nodes[source]) && (ends(n, input) || after[n]))
          more = after[source] = true;
      }
    }
  }
  for (const auto& [n, i] : unknown_) {
    const Input& input = nodes[n].inputs[i];
    if ((begins({.node = n, .input = i}) || before[input.source_node]) &&
        (ends(n, input) || after[n]))
      result.push_back(&input);
  }
  return result;
}

}  // namespace eagerx::gen
