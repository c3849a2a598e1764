// Lines of a trace with scenes, which `--trace-scenes` writes.
#pragma once

#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <string_view>

namespace eagerx::trace_log {

/// So that an index of a number has 16 bits.
inline constexpr std::uint32_t kMostSceneRows = 4095;

/// `# scenes NUM/DEN` or `# scene EPISODE TICK ROWS INDEX=VALUE,…` into `log`. False: `what` is
/// wrong at `place`, which is a part of the line.
bool read_scene_line(std::string_view line, Log& log, std::string_view& place, std::string& what);

}  // namespace eagerx::trace_log
