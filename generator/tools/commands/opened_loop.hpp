// A loop opened at a port: its margins, and the ages of its data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/commands/linear_program.hpp"
#include "generator/tools/linear/loop_curves.hpp"
#include "generator/tools/linear/write.hpp"

namespace eagerx::gen {

/// Adds margins and ages to the report of a system that was opened at `port`. False with E0520: no
/// derivative passes through it.
bool add_loop(Run& run, const PortElement& port, LinearReport& report);

/// The curves of a loop, with the step response that the program simulates. `words`: the program's
/// arguments that `report` belongs to; `size`: that of the step, 0: 5 % of the port's range, or
/// else 1. nullopt if the program cannot run; reports the reason.
std::optional<LoopCurves> loop_curves_of_program(Run& run, const std::string& image,
                                                 std::vector<std::string> words,
                                                 const PortElement& port, double size,
                                                 const LinearReport& report, int& code);

/// Margins and curves of a loop as the page's tab takes them.
Json loop_page_json(const LoopCurves& curves, const LinearReport& report);
/// Margins and curves of the loops opened at these ports, for the page; builds the program of
/// target linearize. Nothing with a problem, which has been reported; `code` is the exit code.
std::optional<Json> loops_json(const GenerateOptions& options,
                               const std::vector<std::string>& ports, int& code);

}  // namespace eagerx::gen
