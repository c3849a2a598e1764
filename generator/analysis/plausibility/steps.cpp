// Nodes that tick several times in one step of a graph without an engine.
#include <fmt/format.h>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Who reads whom, the environment left out.
class Readers {
 public:
  explicit Readers(const Graph& graph) : graph_(graph), readers_(graph.nodes.size()) {
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
      for (const Input& input : graph.nodes[n].inputs) readers_[input.source_node].push_back(n);
    }
  }

  /// Everything behind these nodes; a node itself only if it is in a circle.
  [[nodiscard]] std::vector<bool> behind(std::vector<std::size_t> open) const {
    std::vector<bool> reached(readers_.size(), false);
    while (!open.empty()) {
      const std::size_t n = open.back();
      open.pop_back();
      for (const std::size_t reader : readers_[n]) {
        if (reached[reader]) continue;
        reached[reader] = true;
        open.push_back(reader);
      }
    }
    return reached;
  }

  /// A circle of nodes has something new at each tick, as a plant that is made of nodes does.
  [[nodiscard]] std::vector<bool> with_news() const {
    std::vector<std::size_t> circles;
    for (std::size_t n = 1; n < readers_.size(); ++n) {
      if (behind({n})[n]) circles.push_back(n);
    }
    std::vector<bool> result = behind(circles);
    for (const std::size_t n : circles) result[n] = true;
    return result;
  }

  /// Whether an observation with several messages shows what its ticks have made.
  [[nodiscard]] bool is_seen_whole(std::size_t node) const {
    std::vector<bool> reached = behind({node});
    reached[node] = true;
    return ranges::any_of(graph_.environment().inputs, [&](const Input& input) {
      return input.window != 1 && reached[input.source_node];
    });
  }

 private:
  const Graph& graph_;
  std::vector<std::vector<std::size_t>> readers_;
};

struct Burst {
  Rational rate_hz;
  Span place;
  std::vector<std::string> nodes;
  std::string action;
};

/// The nodes that see one message of an action at several ticks, those of a rate together.
std::vector<Burst> bursts(const CheckedGraph& checked) {
  const Graph& graph = checked.graph;
  const Readers readers(graph);
  const std::vector<bool> news = readers.with_news();
  std::vector<Burst> result;
  // By its first action, in the order of the file.
  std::vector<bool> reported(graph.nodes.size(), false);
  for (std::size_t a = 0; a < graph.environment().outputs.size(); ++a) {
    std::vector<std::size_t> direct;
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
      const bool reads = ranges::any_of(graph.nodes[n].inputs, [&](const Input& input) {
        return input.source_node == Graph::kEnvironment && input.source_output == a;
      });
      if (reads) direct.push_back(n);
    }
    std::vector<bool> reached = readers.behind(direct);
    for (const std::size_t n : direct) reached[n] = true;
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
      const GraphNode& node = graph.nodes[n];
      if (!reached[n] || reported[n] || news[n] || node.drawn ||
          node.rate_hz <= graph.environment().rate_hz || readers.is_seen_whole(n))
        continue;
      reported[n] = true;
      const auto same = ranges::find(result, node.rate_hz, &Burst::rate_hz);
      if (same != result.end()) {
        same->nodes.push_back(node.name);
        continue;
      }
      const EntitySpec* said = find_named(checked.spec.nodes, node.name);
      const Span place = said != nullptr && said->rate ? said->rate->span : node.span;
      result.push_back({node.rate_hz, place, {node.name}, graph.environment().outputs[a].name});
    }
  }
  return result;
}

}  // namespace

void check_steps(const CheckedGraph& checked, Diagnostics& diagnostics) {
  if (checked.graph.has_engine()) return;
  const Safety& safety = checked.graph.safety;
  if (safety.outputs.empty() && safety.undeclared.empty()) return;  // nothing acts on what leaves
  const Rational step_hz = checked.graph.environment().rate_hz;
  for (const Burst& burst : bursts(checked)) {
    const bool one = burst.nodes.size() == 1;
    auto& problem =
        diagnostics.warning("W0112", burst.place,
                            fmt::format("`{}` {} at {} Hz, but a step of this graph takes 1/{} s",
                                        join(burst.nodes, "`, `"), one ? "runs" : "run",
                                        burst.rate_hz.to_string(), step_hz.to_string()));
    const Rational ticks = burst.rate_hz / step_hz;
    problem.label = fmt::format("{} {} ticks of a step run at once, on one message of `actions.{}`",
                                ticks.is_integer() ? "all" : "up to", ticks.ceil(), burst.action);
    problem.notes.push_back({"the rate of step()", checked.spec.rate.span, ""});
    problem.help = fmt::format(
        "write `rate: {}` for the graph and call step() as often, or give {} a rate of at most {}",
        burst.rate_hz.to_string(), one ? "the node" : "the nodes", step_hz.to_string());
    problem.help.fixes = {set_in_graph("rate", burst.rate_hz.to_string())};
  }
}

}  // namespace eagerx::gen
