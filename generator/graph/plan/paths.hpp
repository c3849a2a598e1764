// The paths that messages take from sensors or actions to actuators or observations.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/graph/plan/path_edge.hpp"

namespace eagerx::gen {

/// The ends of the paths to find.
struct PathEnds {
  bool from_actions = false;     // else from sensors
  bool to_observations = false;  // else to actuators
  bool through_agent = true;     // from an observation to every action; never if from_actions

  friend auto operator<=>(const PathEnds&, const PathEnds&) = default;
};

/// From sensors to actuators; without an engine from actions to observations.
PathEnds usual_ends(const Graph& graph);

/// The sorted names of possible ends, with or without a path.
std::vector<std::string> names_of_sources(const Graph& graph, bool actions);
std::vector<std::string> names_of_destinations(const Graph& graph, bool observations);

/// All paths of one pair, each from the last connection back to the first.
struct Paths {
  std::vector<std::vector<const PathEdge*>> all;
  bool complete = true;  // false: there are more; the one with the least sum is among these
};

/// Paths by the names of both ends. Edges live as long as this.
class PathFinder {
 public:
  PathFinder(const Plan& plan, const PathEnds& ends);
  PathFinder(const PathFinder&) = delete;
  PathFinder& operator=(const PathFinder&) = delete;
  using Pair = std::pair<std::string, std::string>;  // from, to
  [[nodiscard]] const std::map<Pair, Paths>& paths() const { return paths_; }
  /// Connections on possible paths from `from` to `to` whose contribution to the age is unknown,
  /// because they are too slow or too long. No path uses them. An empty name means every end.
  [[nodiscard]] std::vector<const Input*> unknown_between(const std::string& from,
                                                          const std::string& to) const;

 private:
  void make_edges();
  void mark_behind_sources();
  void walk(const std::string& destination, const PathEdge& edge);
  void shortest(const std::string& destination, const PathEdge& edge);
  void keep(const std::string& source, const std::string& destination,
            const std::vector<const PathEdge*>& path, bool complete);
  [[nodiscard]] bool is_last(const GraphNode& node, const Input& input) const;
  [[nodiscard]] bool is_passed(const GraphNode& node) const;
  [[nodiscard]] std::vector<const PathEdge*> behind(const PathEdge& edge) const;
  [[nodiscard]] std::string source_of(const PathEdge& edge) const;

  const Plan& plan_;
  const PathEnds ends_;
  std::vector<std::vector<PathEdge>> edges_;  // by node: those that its outputs come from
  std::vector<bool> reached_;                 // nodes that data of a source reach
  std::vector<const PathEdge*> path_;
  std::vector<bool> on_path_;
  std::size_t steps_ = 0;
  std::map<Pair, Paths> paths_;
  std::vector<std::pair<std::size_t, std::size_t>> unknown_;  // node, input
};

}  // namespace eagerx::gen
