// The commands that make and run programs. Each has a file of its name, with its options and its
// work.
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
Command check_command();
Command info_command();
/// Prints how two graphs, or two variants of one, differ; kProblems if they do.
Command diff_command();
Command explain_command();
Command import_command();
Command schema_command();
Command new_command();
Command size_command();
Command identify_command();
/// Looks into weight files: `policy info`, `test`, `golden`, `compare`.
Command policy_command();
/// The keys between two machines.
Command key_command();
/// Opens the reference.
Command docs_command();
/// Writes `pages` below a folder.
Command pages_command(std::vector<CommandLinePage> (*pages)());

}  // namespace eagerx::gen
