#include "generator/backend/emit/repeats.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "generator/graph/plan/split.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kFewest = 3;   // chains
constexpr std::size_t kLongest = 8;  // nodes of a chain

class Finder {
 public:
  Finder(const Plan& plan, Part part, const std::vector<std::size_t>& owners)
      : plan_(plan), graph_(*plan.graph), part_(part), owners_(owners) {
    for (const Ring& ring : plan.rings)
      if (ring.reader_node) converted_.emplace(ring.node, ring.output);
  }

  Repeats run() {
    if (graph_.asynchronous) return {};
    for (const auto* phase : {&plan_.before, &plan_.after}) search(*phase);
    return std::move(found_);
  }

 private:
  void search(const std::vector<std::size_t>& phase) {
    for (std::size_t at = 0; at < phase.size();) {
      const std::optional<Repeat> best = longest(phase, at);
      if (best) found_.all.push_back(*best);
      at += best ? best->nodes.size() : 1;
    }
  }

  /// The one that begins here and has most nodes; its rings are taken.
  std::optional<Repeat> longest(const std::vector<std::size_t>& phase, std::size_t at) {
    std::vector<Repeat> candidates;
    for (std::size_t length = 1; length <= kLongest; ++length) {
      std::size_t nodes = 0;
      while (at + nodes < phase.size() && (nodes < length || phase[at + nodes] != phase[at]) &&
             is_like(phase[at + nodes], phase[at + nodes % length], nodes >= length))
        ++nodes;
      const std::size_t count = nodes / length;
      if (count < kFewest) continue;
      const auto begin = phase.begin() + static_cast<std::ptrdiff_t>(at);
      candidates.push_back({count, {begin, begin + static_cast<std::ptrdiff_t>(count * length)}});
    }
    std::ranges::stable_sort(candidates, [](const Repeat& a, const Repeat& b) {
      return a.nodes.size() > b.nodes.size();
    });
    for (const Repeat& candidate : candidates) {
      if (take_rings(candidate)) return candidate;
    }
    return std::nullopt;
  }

  bool is_like(std::size_t node, std::size_t first, bool other) const {
    return is_plain(node) && plan_.nodes[node].rate == plan_.nodes[first].rate &&
           (!other || owners_[node] == owners_[first]);
  }

  bool is_plain(std::size_t n) const {
    const GraphNode& node = graph_.nodes[n];
    if (node.role != NodeRole::node || node.drawn || node.object || node.waits_during_reset ||
        !node.reset_targets.empty() || !runs_here(graph_, part_, n))
      return false;
    if (graph_.task && graph_.task->node == n) return false;
    for (std::size_t o = 0; o < node.outputs.size(); ++o) {
      if (node.outputs[o].processor || is_converted(n, o) || crosses(n, o)) return false;
    }
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const Input& input = node.inputs[i];
      const auto count = plan_.nodes[n].receptions[i].count;
      if (input.window == 0 || input.max_delay_s || input.entity_sets_delay ||
          (count != Reception::Count::ticks && count != Reception::Count::ticks_but_one &&
           count != Reception::Count::ticks_before))
        return false;
    }
    return true;
  }

  bool is_converted(std::size_t node, std::size_t output) const {
    return converted_.contains({node, output});
  }

  bool crosses(std::size_t node, std::size_t output) const {
    return link_use(plan_, part_, node, output).any();
  }

  /// Whether everything that the chains read and write is the same for all, or one array.
  bool take_rings(const Repeat& repeat) {
    std::vector<std::vector<std::size_t>> arrays;
    const std::size_t length = repeat.length();
    for (std::size_t m = 0; m < length; ++m) {
      const PlannedNode& first = plan_.nodes[repeat.nodes[m]];
      for (std::size_t o = 0; o < first.rings.size(); ++o) {
        std::vector<std::size_t> column;
        for (std::size_t j = 0; j < repeat.count; ++j)
          column.push_back(plan_.nodes[repeat.nodes[j * length + m]].rings[o]);
        if (!add(std::move(column), arrays)) return false;
      }
      for (std::size_t i = 0; i < first.receptions.size(); ++i) {
        std::vector<std::size_t> column;
        for (std::size_t j = 0; j < repeat.count; ++j) {
          const std::size_t n = repeat.nodes[j * length + m];
          if (!is_received_alike(n, repeat.nodes[m], i)) return false;
          column.push_back(plan_.nodes[n].receptions[i].ring);
        }
        const bool shared = std::ranges::count(column, column.front()) == std::ssize(column);
        if (shared ? belongs_to(column.front(), arrays) : !add(std::move(column), arrays))
          return false;
      }
    }
    for (auto& array : arrays) {
      for (const std::size_t ring : array) array_of_[ring] = found_.arrays.size();
      found_.arrays.push_back(std::move(array));
    }
    return true;
  }

  bool is_received_alike(std::size_t node, std::size_t first, std::size_t input) const {
    const Reception &a = plan_.nodes[node].receptions[input],
                    &b = plan_.nodes[first].receptions[input];
    const std::size_t sources[] = {graph_.nodes[node].inputs[input].source_node,
                                   graph_.nodes[first].inputs[input].source_node};
    // The program waits for each node of another part separately.
    if (sources[0] != sources[1] &&
        (is_pipelined(plan_, part_, sources[0]) || is_pipelined(plan_, part_, sources[1])))
      return false;
    return a.count == b.count && plan_.nodes[sources[0]].rate == plan_.nodes[sources[1]].rate;
  }

  static bool belongs_to(std::size_t ring, const std::vector<std::vector<std::size_t>>& arrays) {
    return ranges::any_of(arrays, [&](const auto& array) { return ranges::contains(array, ring); });
  }

  /// False if these rings cannot be an array, or if one of them is in another.
  bool add(std::vector<std::size_t> column, std::vector<std::vector<std::size_t>>& arrays) const {
    if (ranges::contains(arrays, column)) return true;
    const auto known = array_of_.find(column.front());
    if (known != array_of_.end()) return found_.arrays[known->second] == column;
    const Ring& first = plan_.rings[column.front()];
    for (const std::size_t r : column) {
      const Ring& ring = plan_.rings[r];
      if (array_of_.contains(r) || belongs_to(r, arrays) || ring.capacity != first.capacity ||
          ring.space.dtype != first.space.dtype || ring.space.shape != first.space.shape ||
          graph_.nodes[ring.node].drawn)
        return false;
    }
    if (std::set<std::size_t>(column.begin(), column.end()).size() != column.size()) return false;
    arrays.push_back(std::move(column));
    return true;
  }

  const Plan& plan_;
  const Graph& graph_;
  Part part_;
  const std::vector<std::size_t>& owners_;
  std::set<std::pair<std::size_t, std::size_t>> converted_;  // outputs with a ring of one reader
  Repeats found_;
  std::map<std::size_t, std::size_t> array_of_;  // by ring
};

}  // namespace

Repeats find_repeats(const Plan& plan, Part part, const std::vector<std::size_t>& owners) {
  return Finder(plan, part, owners).run();
}

}  // namespace eagerx::gen
