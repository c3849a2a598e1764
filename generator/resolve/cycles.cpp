// A cycle of connections without `skip` can never start: every node waits for the one before it.
#include <fmt/format.h>

#include <algorithm>

#include "generator/resolve/draft.hpp"

namespace eagerx::gen {
namespace {

/// Depth-first search with its own stack: graphs may be long chains.
class CycleFinder {
 public:
  explicit CycleFinder(const Graph& graph) : graph_(graph), color_(graph.nodes.size(), Color::white) {}

  /// Cycles as lists of nodes, each waiting for the next; at most `limit`.
  std::vector<std::vector<std::size_t>> find(std::size_t limit) {
    for (std::size_t start = 0; start < graph_.nodes.size() && cycles_.size() < limit; ++start) visit(start);
    return cycles_;
  }

 private:
  enum class Color : std::uint8_t { white, grey, black };
  struct Frame {
    std::size_t node, next_input;
  };

  void visit(std::size_t start) {
    if (color_[start] != Color::white) return;
    push(start);
    while (!stack_.empty()) {
      Frame& frame = stack_.back();
      const auto& inputs = graph_.nodes[frame.node].inputs;
      if (frame.next_input == inputs.size()) {
        color_[frame.node] = Color::black;
        stack_.pop_back();
        continue;
      }
      const Input& input = inputs[frame.next_input++];
      if (input.skip) continue;
      if (color_[input.source_node] == Color::white) {
        push(input.source_node);
      } else if (color_[input.source_node] == Color::grey) {
        note_cycle(input.source_node);
      }
    }
  }

  void push(std::size_t node) {
    color_[node] = Color::grey;
    stack_.push_back({node, 0});
  }

  void note_cycle(std::size_t back_to) {
    std::vector<std::size_t> cycle;
    for (auto frame = stack_.rbegin(); frame != stack_.rend(); ++frame) {
      cycle.push_back(frame->node);
      if (frame->node == back_to) break;
    }
    std::reverse(cycle.begin(), cycle.end());
    cycles_.push_back(std::move(cycle));
  }

  const Graph& graph_;
  std::vector<Color> color_;
  std::vector<Frame> stack_;
  std::vector<std::vector<std::size_t>> cycles_;
};

std::string port_name(const Graph& graph, std::size_t node, const std::string& port, bool sends) {
  if (node == Graph::kEnvironment) return fmt::format("{}.{}", sends ? "actions" : "observations", port);
  return fmt::format("{}.{}", graph.nodes[node].name, port);
}

const Input& connection_between(const Graph& graph, std::size_t from, std::size_t to) {
  const auto& inputs = graph.nodes[to].inputs;
  return *std::find_if(inputs.begin(), inputs.end(), [&](const Input& i) { return i.source_node == from && !i.skip; });
}

}  // namespace

void check_cycles(const Graph& graph, Diagnostics& diagnostics) {
  constexpr std::size_t kMostCycles = 5;
  for (const auto& cycle : CycleFinder(graph).find(kMostCycles)) {
    // cycle[i] waits for cycle[i + 1]; the last one waits for the first.
    std::vector<const Input*> connections;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::size_t from = cycle[(i + 1) % cycle.size()];
      const Input& input = connection_between(graph, from, cycle[i]);
      connections.push_back(&input);
      names.push_back(fmt::format("{} -> {}", port_name(graph, from, graph.nodes[from].outputs[input.source_output].name, true),
                                  port_name(graph, cycle[i], input.name, false)));
    }
    auto& problem = diagnostics.error("E0314", connections.front()->span, fmt::format("connection `{}` closes a cycle without a delay of one tick", names.front()));
    problem.label = fmt::format("needs `{}` of the same tick", names.front().substr(0, names.front().find(' ')));
    for (std::size_t i = 1; i < connections.size(); ++i) {
      problem.notes.push_back({fmt::format("the cycle goes on with `{}`", names[i]), connections[i]->span, ""});
    }
    problem.help = "add `skip: true` to one of these connections: it then takes the message of the tick before";
  }
}

}  // namespace eagerx::gen
