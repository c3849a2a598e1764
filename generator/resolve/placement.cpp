// What runs on a board.
#include <fmt/format.h>

#include <algorithm>

#include "generator/resolve/chosen_nodes.hpp"
#include "generator/resolve/draft.hpp"

namespace eagerx::gen {
namespace {

class Placer {
 public:
  explicit Placer(Draft& draft) : draft_(draft) {
    placement_.on_board.assign(draft.nodes.size(), false);
  }

  void run(const std::vector<PlacementSpec>& items) {
    for (const auto& item : items) {
      find_board(item);
      place(item);
    }
    if (placement_.on_board[Graph::kEnvironment] &&
        draft_.graph.agent.kind == AgentSpec::Kind::csv) {
      draft_.diagnostics
          .error("E0332", placement_.span, "the agent reads a file, and a board has no files")
          .help = "place only nodes, not `agent` or `controller`";
    }
    draft_.graph.placement = std::move(placement_);
  }

 private:
  void find_board(const PlacementSpec& item) {
    const Target* found = draft_.library.find_target(item.board.value);
    if (found == nullptr) {
      draft_.diagnostics
          .error("E0316", item.board.span, fmt::format("unknown target `{}`", item.board.value))
          .help = suggestion(item.board.value, partners(), "no target can run a part of a graph");
      return;
    }
    if (found->partner.empty()) {
      draft_.diagnostics
          .error("E0334", item.board.span,
                 fmt::format("target `{}` cannot run a part of a graph", item.board.value))
          .help = fmt::format("its manifest has no `partner`; these targets have one: {}",
                              fmt::join(partners(), ", "));
      return;
    }
    if (placement_.board == nullptr) {
      placement_.board = found;
      placement_.span = item.name.span;
    } else if (placement_.board != found) {
      draft_.diagnostics.error("E0333", item.board.span,
                               fmt::format("parts on two boards, `{}` and `{}`: there can be one",
                                           placement_.board->id.value, item.board.value));
    }
  }

  /// The targets that can run a part of a graph.
  [[nodiscard]] std::vector<std::string> partners() const {
    std::vector<std::string> ids;
    for (const auto& [id, target] : draft_.library.all_targets()) {
      if (!target.partner.empty()) ids.push_back(id);
    }
    return ids;
  }

  void place(const PlacementSpec& item) {
    const std::string& name = item.name.value;
    const auto& nodes = draft_.nodes;
    std::vector<std::string> known = {"controller", "agent"};
    bool found = false;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].node.role != NodeRole::node || draft_.is_added(n)) continue;
      known.push_back(nodes[n].node.name);
      known.push_back(known.back().substr(0, known.back().find_first_of("/[")));
      if (is_called(owner_of(nodes[n].node.name), name) == Called::no) continue;
      placement_.on_board[n] = true;
      found = true;
    }
    // A node that is called so comes before the word.
    if (found) return;
    if (name == "agent" || name == "controller") {
      placement_.on_board[Graph::kEnvironment] = true;
      for (std::size_t n = 0; name == "controller" && n < nodes.size(); ++n)
        if (nodes[n].node.role == NodeRole::node && !draft_.is_added(n))
          placement_.on_board[n] = true;
      return;
    }
    const bool simulated = name == "engine" || find_named(draft_.objects, name) != nullptr;
    if (simulated) {
      draft_.diagnostics
          .error("E0332", item.name.span, fmt::format("`{}` cannot be placed on a board", name))
          .help = "the engine and its objects stay on Linux: place nodes, `agent` or `controller`";
      return;
    }
    draft_.diagnostics.error("E0307", item.name.span, fmt::format("there is no node `{}`", name))
        .help = suggestion(name, known, "");
  }

  /// `leg[2]/…` for `mux/leg[2]/…`, which compose/ adds for an input of it and goes along.
  static std::string_view owner_of(std::string_view node) {
    constexpr std::string_view kAdded = "mux/";
    if (node.starts_with(kAdded)) node.remove_prefix(kAdded.size());
    return node;
  }

  Draft& draft_;
  Placement placement_;
};

}  // namespace

void place_on_board(Draft& draft, const std::vector<PlacementSpec>& placement) {
  if (!placement.empty()) Placer(draft).run(placement);
}

}  // namespace eagerx::gen
