// Messages that cross a cut, and their names.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "generator/graph/cut/cut.hpp"

namespace eagerx::gen {

/// An output of a node of the whole graph.
using Sender = std::pair<std::size_t, std::size_t>;  // node, output

/// Messages that cross the cut under one name.
struct Crossing {
  Sender from;
  CutPort port;
  Span span;
  bool driven = false;  // an observation: its actuator has bounds of its own
  Space space = {};     // what leaves, within those of its actuator
};

/// All that crosses a cut, in the order of the graph.
struct Crossings {
  std::vector<Crossing> in, out;
  /// For each input inside that reads from outside: its place in `in`.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> of_input;
};
Crossings crossings_of(const Graph& whole, const std::vector<bool>& inside,
                       const CutRequest& request);

}  // namespace eagerx::gen
