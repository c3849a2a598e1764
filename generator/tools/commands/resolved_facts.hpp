// Facts about a graph without errors, for editors.
#pragma once

#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/tools/lsp/resolved.hpp"

namespace eagerx::gen {

/// Of a run with a plan. Ages from sensors to actuators only for graphs of at most
/// 300 nodes: they take longer than an editor waits.
lsp::Resolved resolved_facts(const Run& run);

}  // namespace eagerx::gen
