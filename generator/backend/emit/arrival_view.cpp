#include "generator/backend/emit/arrival_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

std::string lacks_messages(const Plan& plan, const ProgramNames& names, std::size_t node) {
  std::vector<std::string> terms;
  for (const auto& input : plan.graph->nodes[node].inputs) {
    if (input.window == 0) continue;
    const std::string empty = fmt::format("in.{}.empty()", input.name);
    terms.push_back(input.skip ? fmt::format("{}.count() > 0 && {}", names.nodes[node].sent, empty)
                               : empty);
  }
  if (terms.size() == 1) return terms.front();
  for (auto& term : terms) {
    if (term.find("&&") != std::string::npos) term = fmt::format("({})", term);
  }
  return fmt::format("{}", join(terms, " || "));
}

View arrivals_view(const Plan& plan, const ProgramNames& names) {
  const Graph& graph = *plan.graph;
  if (!graph.asynchronous) return View(false);
  View view = object();
  view.set("environment_sent", names.nodes[Graph::kEnvironment].sent);
  view.set("clock", names.nodes[Graph::kEngine].member.expression() + ".now_ns()");
  std::vector<std::string> missing;
  for (const auto& input : graph.environment().inputs) {
    if (input.window > 0 && !input.skip)
      missing.push_back(fmt::format("seen.{}.received() == 0", input.name));
  }
  view.set("missing", missing.empty() ? "false" : fmt::format("{}", join(missing, " || ")));
  View senders = list();
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    std::uint64_t capacity = 1;
    for (const auto& ring : plan.rings)
      if (ring.node == n) capacity = std::max(capacity, ring.capacity);
    View sender = object();
    sender.set("type", fmt::format("eagerx::Sent<{}>", capacity));
    sender.set("sender", names.nodes[n].sent);
    senders.push_back(sender);
  }
  view["senders"] = std::move(senders);
  return view;
}

}  // namespace eagerx::gen
