#include "generator/graph/plan/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace eagerx::gen {
namespace {

/// A node, the nodes it hears, and the index of its rate.
struct Sketch {
  std::string name;
  std::vector<std::pair<std::string, bool>> hears;  // name, skip
  std::size_t rate = 0;
};

struct SketchedGraph {
  Graph graph;
  std::vector<std::size_t> rate_of;
};

SketchedGraph sketched_graph(const std::vector<Sketch>& sketches) {
  SketchedGraph sketched;
  for (const auto& sketch : sketches) {
    GraphNode node;
    node.name = sketch.name;
    for (const auto& [name, skip] : sketch.hears) {
      Input input;
      input.skip = skip;
      const auto source =
          std::find_if(sketches.begin(), sketches.end(),
                       [&, wanted = name](const Sketch& s) { return s.name == wanted; });
      input.source_node = static_cast<std::size_t>(source - sketches.begin());
      node.inputs.push_back(input);
    }
    sketched.graph.nodes.push_back(std::move(node));
    sketched.rate_of.push_back(sketch.rate);
  }
  return sketched;
}

std::vector<std::string> names(const Graph& graph, const std::vector<std::size_t>& nodes) {
  std::vector<std::string> result;
  for (const std::size_t n : nodes) result.push_back(graph.nodes[n].name);
  return result;
}

/// A random graph without cycles; actions feed some nodes, some nodes feed observations.
std::vector<Sketch> random_sketches(std::mt19937& random, std::size_t count) {
  std::vector<Sketch> sketches = {{"environment", {}, random() % 3}, {"engine", {}, random() % 3}};
  std::vector<bool> after_action = {false, false};
  for (std::size_t n = 2; n < count; ++n) {
    Sketch sketch{"node" + std::to_string((n * 7919) % 1000), {}, random() % 3};
    bool after = false;
    for (int i = 0; i < 3; ++i) {
      const std::size_t source = random() % n;
      sketch.hears.emplace_back(sketches[source].name, false);
      after = after || source == 0 || after_action[source];
    }
    after_action.push_back(after);
    sketches.push_back(sketch);
  }
  for (std::size_t n = 1; n < count; ++n) {
    if (!after_action[n] && random() % 2 == 0)
      sketches[0].hears.emplace_back(sketches[n].name, false);
    const std::size_t late = random() % count;
    if (late > n && random() % 4 == 0)
      sketches[n].hears.emplace_back(sketches[late].name, true);  // against the flow, skipped
  }
  return sketches;
}

TEST(Order, EveryNodeOnceBehindWhatItHears) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const SketchedGraph sketched = sketched_graph(random_sketches(random, 2 + random() % 60));
    const Order order = order_nodes(sketched.graph, sketched.rate_of);
    std::vector<std::size_t> sequence = order.before;
    sequence.push_back(Graph::kEnvironment);
    sequence.insert(sequence.end(), order.after.begin(), order.after.end());
    ASSERT_EQ(sequence.size(), sketched.graph.nodes.size());
    std::vector<std::size_t> place(sequence.size(), sequence.size());
    for (std::size_t i = 0; i < sequence.size(); ++i) place[sequence[i]] = i;
    for (std::size_t n = 0; n < sketched.graph.nodes.size(); ++n) {
      ASSERT_LT(place[n], sequence.size()) << "missing";
      for (const auto& input : sketched.graph.nodes[n].inputs) {
        if (input.skip) continue;
        ASSERT_LT(place[input.source_node], place[n]) << sketched.graph.nodes[n].name;
      }
    }
  }
}

TEST(Order, OnlyWhatNeedsTheActionComesAfterTheEnvironment) {
  const SketchedGraph sketched = sketched_graph({{"environment", {{"theta", false}}},
                                                 {"engine", {}},
                                                 {"theta", {{"engine", false}}},
                                                 {"filter", {{"environment", false}}},
                                                 {"u", {{"filter", false}, {"engine", false}}},
                                                 {"echo", {{"u", true}}}});
  const Order order = order_nodes(sketched.graph, sketched.rate_of);
  EXPECT_EQ(names(sketched.graph, order.before),
            (std::vector<std::string>{"echo", "engine", "theta"}));
  EXPECT_EQ(names(sketched.graph, order.after), (std::vector<std::string>{"filter", "u"}));
}

TEST(Order, DoesNotDependOnTheOrderOfTheFile) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Sketch> sketches = random_sketches(random, 30);
    const SketchedGraph sketched = sketched_graph(sketches);
    const Order order = order_nodes(sketched.graph, sketched.rate_of);
    std::vector<Sketch> shuffled = sketches;
    std::shuffle(shuffled.begin() + 2, shuffled.end(),
                 random);  // environment and engine stay in front
    const SketchedGraph other = sketched_graph(shuffled);
    const Order again = order_nodes(other.graph, other.rate_of);
    ASSERT_EQ(names(sketched.graph, order.before), names(other.graph, again.before));
    ASSERT_EQ(names(sketched.graph, order.after), names(other.graph, again.after));
  }
}

TEST(Order, StaysWithARateAsLongAsItCan) {
  const SketchedGraph sketched = sketched_graph({{"environment", {}},
                                                 {"engine", {}, 0},
                                                 {"a", {{"engine", false}}, 1},
                                                 {"b", {{"engine", false}}, 0},
                                                 {"c", {{"engine", false}}, 1},
                                                 {"d", {{"engine", false}}, 0}});
  const Order order = order_nodes(sketched.graph, sketched.rate_of);
  EXPECT_EQ(names(sketched.graph, order.before),
            (std::vector<std::string>{"engine", "b", "d", "a", "c"}));
}

}  // namespace
}  // namespace eagerx::gen
