// A stream for scripts: a line for each channel.
#pragma once

#include <string>

#include "generator/tools/monitor/model.hpp"

namespace eagerx::gen {

/// The columns, separated by tabs, after `# `.
std::string lines_head();
/// A line that begins with `# `: graph, episode, step, time, and problems of the stream. Then a
/// line for each channel. `-` means unknown.
std::string lines_text(const Model& model);

}  // namespace eagerx::gen
