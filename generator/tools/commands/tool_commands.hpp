// The commands of eagerx-gen-tools. Each has a file of its name, except `fix` and `rename`
// (edit.cpp) and `plot` (trace.cpp).
#pragma once

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

/// Steps a library that is cut out of a graph with the recorded messages of a simulation, and
/// compares.
Command pil_command();
/// Prints the sampled loop of a graph as matrices, poles and margins.
Command linearize_command();
/// Computes gains for it.
Command design_command();
/// Prints an operating point of a graph.
Command trim_command();
/// Writes a picture of the graph.
Command graph_command();
/// Writes a page for a browser.
Command report_command();
Command replay_command();
/// Writes a log in the form of other tools.
Command trace_command();
/// Draws channels of a log.
Command plot_command();
/// Watches the messages of a program.
Command monitor_command();
/// Changes the text of a graph as the help of its errors says.
Command fix_command();
/// Gives an object or a node another name.
Command rename_command();
/// Serves an editor.
Command lsp_command();
/// Serves the page that edits a graph.
Command serve_command();

}  // namespace eagerx::gen
