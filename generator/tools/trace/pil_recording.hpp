// Messages that a simulation recorded at a cut of its graph, for the library of the cut-out nodes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

struct PilRecording {
  std::string words;  // as targets/common/pil.hpp reads them
  std::uint64_t steps = 0;
  std::uint32_t episodes = 0;
};

/// The recording in the log `path`, for a graph with a `cut`. nullopt: see `problem`.
std::optional<PilRecording> recording_of(const std::string& path, const Graph& graph,
                                         std::string& problem);

}  // namespace eagerx::gen
