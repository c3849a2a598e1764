// A stream for scripts: a line for each channel.
#pragma once

#include <string>

#include "generator/tools/monitor/model.hpp"

namespace eagerx::gen {

/// The columns, separated by tabs, behind `# `.
std::string lines_head();
/// A line that begins with `# `: graph, episode, step, time, and what was wrong with the stream.
/// Then a line for each channel. What is not known is `-`.
std::string lines_text(const Model& model);

}  // namespace eagerx::gen
