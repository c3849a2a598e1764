// The commands of eagerx-gen. Each is in the file of its name, with its options and what it does.
#pragma once

#include <vector>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

Command generate_command();
/// The same, and builds the programs; prints their files.
Command build_command();
/// The same, and becomes the program, or the emulator with it: its exit code is the command's.
Command run_command();
/// Makes the graph's library of environments, and becomes the trainer with it.
Command train_command();
/// Makes the graph's library of environments, and becomes the program that runs many episodes.
Command campaign_command();
/// Steps a library that is cut out of a graph with what a simulation recorded, and compares.
Command pil_command();
Command check_command();
Command info_command();
/// Prints how two graphs, or two variants of one, differ; kProblems if they do.
Command diff_command();
/// Writes a picture of the graph.
Command graph_command();
/// Writes a page for a browser.
Command report_command();
Command explain_command();
Command import_command();
Command schema_command();
Command new_command();
Command size_command();
Command replay_command();
Command identify_command();
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
/// Looks into weight files: `policy info`, `test`, `golden`, `compare`.
Command policy_command();
/// What two machines trust each other by.
Command key_command();
/// Opens the reference.
Command docs_command();
/// Writes `pages` below a folder.
Command pages_command(std::vector<CommandLinePage> (*pages)());

}  // namespace eagerx::gen
