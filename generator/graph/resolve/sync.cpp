#include "generator/graph/resolve/sync.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

std::string engines_with_a_clock(const Library& library) {
  std::vector<std::string> ids;
  for (const auto& [id, entity] : library.all_entities()) {
    if (entity.kind == EntityKind::engine && entity.asynchronous) ids.push_back(id);
  }
  if (ids.empty()) return "leave `sync` out";
  return fmt::format("leave `sync` out, or choose an engine with a clock: {}", join(ids, ", "));
}

}  // namespace

void check_sync(UnresolvedGraph& draft) {
  const auto& sync = draft.spec.sync;
  if (!sync || sync->value) return;
  draft.graph.asynchronous = true;
  const Entity* const engine = draft.engine();
  if (engine != nullptr && !engine->asynchronous) {
    auto& problem = draft.diagnostics.error(
        "E0338", sync->span, fmt::format("`{}` cannot run asynchronously", engine->id.value));
    problem.label = "it counts time in ticks and has no clock";
    problem.help = engines_with_a_clock(draft.library);
  }
  if (draft.graph.has_reset_nodes()) {
    draft.diagnostics
        .error("E0338", sync->span, "a graph with reset nodes cannot run asynchronously")
        .help = "leave `sync` out";
  }
  if (draft.graph.placement) {
    auto& problem = draft.diagnostics.error("E0338", sync->span,
                                            "a part of this graph is a separate program, and "
                                            "programs share no clock");
    problem.notes.push_back({"placed here", draft.graph.placement->span(), ""});
    problem.help = "leave `sync` out";
  }
}

}  // namespace eagerx::gen
