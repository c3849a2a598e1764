// Requirements of a graph's entities besides the runtime.
#pragma once

#include <string>
#include <vector>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// Which program of a graph: the whole of it, or of a placed graph the hub or one of the parts.
class Part {
 public:
  static const Part whole, hub;
  /// `index` in Placement::parts.
  static constexpr Part placed(std::size_t index) { return {Kind::placed, index}; }

  bool operator==(const Part&) const = default;
  [[nodiscard]] bool is_placed() const { return kind_ == Kind::placed; }
  /// As Placement::part_of has it.
  [[nodiscard]] std::size_t index() const { return index_; }

 private:
  enum class Kind : std::uint8_t { whole, hub, placed };
  constexpr Part(Kind kind, std::size_t index) : kind_(kind), index_(index) {}

  Kind kind_;
  std::size_t index_;
};
inline constexpr Part Part::whole{Kind::whole, Placement::kHub};
inline constexpr Part Part::hub{Kind::hub, Placement::kHub};

/// Whether this node's callback is called in this program; the environment's: whether it decides.
bool runs_here(const Graph& graph, Part part, std::size_t node);
/// Whether this node's inputs are received in this program: the hub has all observations.
bool receives_here(const Graph& graph, Part part, std::size_t node);

/// pkg-config's names of the libraries, sorted, each once.
std::vector<std::string> packages_of(const Graph& graph, Part part);

/// Reports every entity of this program that needs another operating system or family of boards
/// than the target's: E0330.
void check_system(const Graph& graph, Part part, const Target& target, const Library& library,
                  Diagnostics& diagnostics);

}  // namespace eagerx::gen
