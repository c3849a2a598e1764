// Scenes of a trace for the page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/trace/log_file.hpp>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {

/// The film of an episode, of long ones every n-th scene, so that it has at most `most_bytes`
/// bytes; null if the log has none.
Json scenes_json(const trace_log::Log& log, std::uint32_t episode, std::size_t most_bytes);

}  // namespace eagerx::gen
