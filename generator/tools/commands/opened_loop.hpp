// The loop opened at a port: its margins, and the ages of data in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/commands/linear_program.hpp"
#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {

/// Adds margins and ages to the report of a system that was opened at `port`. False with E0520: no
/// derivative passes through it.
bool add_loop(Run& run, const PortElement& port, LinearReport& report);

/// Margins and curves of the loops opened at these ports, for the page; builds the program of
/// target linearize. Nothing with a problem, which has been reported; `code` is the exit code.
std::optional<Json> loops_json(const GenerateOptions& options,
                               const std::vector<std::string>& ports, int& code);

}  // namespace eagerx::gen
