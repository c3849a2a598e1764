// A graph as boxes with ports and wires, before layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "generator/graph/resolve/graph.hpp"

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
  entry,  // within a composite: where its inputs come in
  exit,   // and where its outputs leave
};

struct BoxPort {
  std::string name;
  std::string detail;  // "window 4, delay 0.05 s"; empty if there is nothing to say
};

struct Drawing;

struct Box {
  BoxKind kind = BoxKind::node;
  std::string name;
  std::string subtitle;  // "ButterworthFilter, 30 Hz"
  std::string about;     // the summary of its manifest
  std::vector<BoxPort> inputs, outputs;
  std::optional<std::size_t> node = {}, object = {};  // of the graph; `actions` is node 0, too
  std::optional<std::size_t> group = {};              // that it is in
  /// The contents of a composite. Its ends are its boxes 0 (entry) and 1 (exit).
  std::shared_ptr<const Drawing> inside = {};
  std::string full_name = {};  // where `name` is that within a composite
};

struct Wire {
  std::size_t from = 0, output = 0;  // box, and its port
  std::size_t to = 0, input = 0;
  std::string about;        // "pendulum.theta to observations.angle: float32 [1]"
  bool sets_state = false;  // from a reset node to the state it brings about
  /// The inputs that it leads to: a node of the graph, and which of its inputs. A wire that sets a
  /// state has none; one to a port of a composite may have several.
  struct Reader {
    std::size_t node = 0, input = 0;
  };
  std::vector<Reader> readers = {};
};

/// A composite: boxes that are drawn in a frame, or as one.
struct BoxGroup {
  Box box;                            // as one
  std::optional<std::size_t> around;  // the group that it is in
  /// For a port of an inner box, as `box.port`, the number of the corresponding outer port.
  std::map<std::string, std::size_t> inputs, outputs;
};

/// Boxes in the order actions, nodes, objects, observations, so that in a cycle the drivers are on
/// the left.
struct Drawing {
  std::string title;
  std::vector<Box> boxes;
  std::vector<Wire> wires;
  std::vector<BoxGroup> groups;  // of a drawing that is not nested
};

/// All boxes and wires side by side; each box says in which group it is.
Drawing drawing_of(const Graph& graph, const std::vector<CompositeSpec>& composites,
                   GraphView view);
/// Each group as one box with a drawing inside, and wires that pass its ports.
Drawing nested(const Drawing& flat);

}  // namespace eagerx::gen
