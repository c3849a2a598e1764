#include "generator/graph/resolve/cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

bool waits(const UnresolvedInput& input) {
  return input.edge && !skips(input.settings);
}

/// Depth-first search with its own stack: graphs may be long chains.
class CycleFinder {
 public:
  explicit CycleFinder(const UnresolvedGraph& draft)
      : draft_(draft), color_(draft.nodes.size(), Color::white) {}

  /// Cycles as lists of nodes, each waiting for the next; at most `limit`.
  std::vector<std::vector<std::size_t>> find(std::size_t limit) {
    for (std::size_t start = 0; start < draft_.nodes.size() && cycles_.size() < limit; ++start)
      visit(start);
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
      const auto& inputs = draft_.nodes[frame.node].inputs;
      if (frame.next_input == inputs.size()) {
        color_[frame.node] = Color::black;
        stack_.pop_back();
        continue;
      }
      const UnresolvedInput& input = inputs[frame.next_input++];
      if (!waits(input)) continue;
      if (color_[input.edge->node] == Color::white) {
        push(input.edge->node);
      } else if (color_[input.edge->node] == Color::grey) {
        note_cycle(input.edge->node);
      }
    }
  }

  void push(std::size_t node) {
    color_[node] = Color::grey;
    stack_.push_back({node, 0});
  }

  void note_cycle(std::size_t back_to) {
    std::vector<std::size_t> cycle;
    const auto first = ranges::find(stack_, back_to, &Frame::node);
    std::ranges::transform(first, stack_.end(), std::back_inserter(cycle), &Frame::node);
    cycles_.push_back(std::move(cycle));
  }

  const UnresolvedGraph& draft_;
  std::vector<Color> color_;
  std::vector<Frame> stack_;
  std::vector<std::vector<std::size_t>> cycles_;
};

const UnresolvedInput& connection_between(const UnresolvedGraph& draft, std::size_t from,
                                          std::size_t to) {
  const auto& inputs = draft.nodes[to].inputs;
  return *ranges::find_if(
      inputs, [&](const UnresolvedInput& i) { return waits(i) && i.edge->node == from; });
}

std::string source_name(const UnresolvedGraph& draft, const UnresolvedEdge& edge) {
  const UnresolvedNode& node = draft.nodes[edge.node];
  return fmt::format("{}.{}", edge.node == Graph::kEnvironment ? "actions" : node.node.name,
                     node.outputs[edge.output].name);
}

/// The fix. A cycle through the environment begins with it: it waits for an observation.
std::string help_for(const UnresolvedGraph& draft, const std::vector<std::size_t>& cycle,
                     const std::string& first) {
  if (cycle.front() != Graph::kEnvironment)
    return fmt::format("add `skip: true` to {}: it then takes the message of the tick before",
                       cycle.size() == 1 ? "this connection" : "one of these connections");
  return fmt::format(
      "an action is the answer to the observations of the same instant, so none of them can wait "
      "for it{}: add `skip: true` to `{}`, which then takes the message of the tick before",
      draft.spec.has_engine() ? "" : ", and without an engine nothing on the way takes time",
      first);
}

}  // namespace

void check_cycles(UnresolvedGraph& draft) {
  constexpr std::size_t kMostCycles = 5;
  for (const auto& cycle : CycleFinder(draft).find(kMostCycles)) {
    // cycle[i] waits for cycle[i + 1]; the last one waits for the first.
    std::vector<Span> places;
    std::vector<std::string> sources, names;
    std::vector<Fix> fixes;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const UnresolvedInput& input =
          connection_between(draft, cycle[(i + 1) % cycle.size()], cycle[i]);
      places.push_back(input.span);
      sources.push_back(source_name(draft, *input.edge));
      names.push_back(fmt::format("{} -> {}", sources.back(), input.written));
      if (input.span.file == places.front().file)
        fixes.push_back(skip_at(input.span, sources.back(), input.written));
    }
    auto& problem = draft.diagnostics.error(
        "E0314", places.front(),
        fmt::format("connection `{}` closes a cycle without a delay of one tick", names.front()));
    problem.label = fmt::format("needs `{}` of the same tick", sources.front());
    constexpr std::size_t kMostNotes = 12;
    const bool all = places.size() - 1 <= kMostNotes;
    for (std::size_t i = 1; i < (all ? places.size() : kMostNotes); ++i) {
      problem.notes.push_back(
          {fmt::format("the cycle continues with `{}`", names[i]), places[i], ""});
    }
    if (!all)
      problem.notes.push_back(
          {fmt::format("and with {} more connections, the last of which is `{}`",
                       places.size() - kMostNotes, names.back()),
           places.back(), ""});
    problem.help = help_for(draft, cycle, names.front());
    fixes.resize(std::min(fixes.size(), kMostNotes + 1));
    if (cycle.front() != Graph::kEnvironment) problem.help.fixes = std::move(fixes);
  }
}

}  // namespace eagerx::gen
