#include "generator/graph/plan/order.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace eagerx::gen {
namespace {

/// Kahn's algorithm. Among the nodes that are ready it stays with the rate of the last one, so that
/// the generated code asks seldom whether a rate is due; ties go by name, never by the order in the
/// file.
class Sorter {
 public:
  Sorter(const Graph& graph, const std::vector<std::size_t>& rate_of)
      : graph_(graph), rate_of_(rate_of) {
    waits_for_.assign(graph.nodes.size(), 0);
    readers_.resize(graph.nodes.size());
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
      for (const auto& input : graph.nodes[n].inputs) {
        if (input.skip) continue;
        ++waits_for_[n];
        readers_[input.source_node].push_back(n);
      }
    }
    if (!graph.asynchronous) return;
    // The engine waits for a slot's instant; nothing that runs by its clock begins before that.
    for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
      if (n == Graph::kEngine || n == Graph::kEnvironment) continue;
      ++waits_for_[n];
      readers_[Graph::kEngine].push_back(n);
    }
  }

  /// Runs every ready node of `phase` until none is left.
  std::vector<std::size_t> run(const std::vector<bool>& phase) {
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
      if (phase[n] && waits_for_[n] == 0) ready_[rate_of_[n]].insert({graph_.nodes[n].name, n});
    }
    std::vector<std::size_t> order;
    while (const auto next = pop()) {
      order.push_back(*next);
      release(*next, phase);
    }
    return order;
  }

  void release(std::size_t node, const std::vector<bool>& phase) {
    for (const std::size_t reader : readers_[node]) {
      if (--waits_for_[reader] == 0 && phase[reader])
        ready_[rate_of_[reader]].insert({graph_.nodes[reader].name, reader});
    }
  }

 private:
  std::optional<std::size_t> pop() {
    if (ready_[rate_].empty()) {
      const auto fullest = std::ranges::max_element(
          ready_, {}, [](const auto& of_rate) { return of_rate.second.size(); });
      if (fullest == ready_.end() || fullest->second.empty()) return std::nullopt;
      rate_ = fullest->first;
    }
    auto& set = ready_[rate_];
    const std::size_t node = set.begin()->second;
    set.erase(set.begin());
    return node;
  }

  const Graph& graph_;
  const std::vector<std::size_t>& rate_of_;
  std::vector<std::size_t> waits_for_;
  std::vector<std::vector<std::size_t>> readers_;
  std::map<std::size_t, std::set<std::pair<std::string, std::size_t>>> ready_;
  std::size_t rate_ = 0;
};

}  // namespace

Order order_nodes(const Graph& graph, const std::vector<std::size_t>& rate_of) {
  std::vector<bool> after(graph.nodes.size(), false);
  std::vector<std::vector<std::size_t>> readers(graph.nodes.size());
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    for (const auto& input : graph.nodes[n].inputs) {
      if (!input.skip) readers[input.source_node].push_back(n);
    }
  }
  std::vector<std::size_t> todo = readers[Graph::kEnvironment];
  while (!todo.empty()) {
    const std::size_t node = todo.back();
    todo.pop_back();
    if (after[node]) continue;
    after[node] = true;
    todo.insert(todo.end(), readers[node].begin(), readers[node].end());
  }
  std::vector<bool> before(graph.nodes.size());
  for (std::size_t n = 0; n < graph.nodes.size(); ++n)
    before[n] = !after[n] && n != Graph::kEnvironment;

  Sorter sorter(graph, rate_of);
  Order order;
  order.before = sorter.run(before);
  sorter.release(Graph::kEnvironment, after);
  order.after = sorter.run(after);
  return order;
}

}  // namespace eagerx::gen
