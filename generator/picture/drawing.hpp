// A graph as boxes with ports and wires between them, before anything has a place on paper.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/resolve/graph.hpp"

namespace eagerx::gen {

/// Whose graph is drawn.
enum class GraphView : std::uint8_t {
  user,    // as it was written: an object is one box
  engine,  // as it runs: the engine, and the nodes that an object consists of on it
};

enum class BoxKind : std::uint8_t {
  actions,
  observations,
  object,
  node,
  reset_node,
  engine,
  engine_node,
  task,
};

struct PicturePort {
  std::string name;
  std::string detail;  // "window 4, delay 0.05 s"; empty if there is nothing to say
};

struct Box {
  BoxKind kind = BoxKind::node;
  std::string name;
  std::string subtitle;  // "ButterworthFilter, 30 Hz"
  std::string about;     // the summary of its manifest
  std::vector<PicturePort> inputs, outputs;
  std::optional<std::size_t> node = {}, object = {};  // of the graph; `actions` is node 0, too
};

struct Wire {
  std::size_t from = 0, output = 0;  // box, and its port
  std::size_t to = 0, input = 0;
  std::string about;        // "pendulum.theta to observations.angle: float32 [1]"
  bool sets_state = false;  // from a reset node to the state it brings about
  /// The input that it is: a node of the graph, and which of its inputs. A wire that sets a state
  /// has none.
  struct Reader {
    std::size_t node = 0, input = 0;
  };
  std::optional<Reader> reader = {};
};

/// Boxes in the order actions, nodes, objects, observations: what drives stands left where a circle
/// leaves the choice.
struct Drawing {
  std::string title;
  std::vector<Box> boxes;
  std::vector<Wire> wires;
};

Drawing drawing_of(const Graph& graph, GraphView view);

}  // namespace eagerx::gen
