// Rows of tables of options that several commands have.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "generator/driver/pipeline/options.hpp"
#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"

namespace eagerx::gen {

using Arguments = std::vector<Argument>;

Arguments joined(std::initializer_list<Arguments> parts);

Argument graph(GraphOptions& options);
/// Variant, engine, scalar, targets and split, which override the graph.
Arguments selection(GraphOptions& options);
Argument split(GraphOptions& options);
Argument variant(GraphOptions& options);
Argument engine(GraphOptions& options);
Arguments rates(GraphOptions& options);
Argument agent_policy(GraphOptions& options);
/// Nodes that are cut out of the graph, as a library.
Argument cut_out_nodes(GraphOptions& options, std::string about);
/// The options of building the programs of a graph.
Arguments on_building(GenerateOptions& options);
Argument warnings(GraphOptions& options);
/// Folders of the user's own entities.
Argument library(LibraryOptions& options);
Argument quiet(MessageOptions& options);
Arguments diagnostics(MessageOptions& options);

/// An option that the program which is started understands: it becomes some of its `words`.
Argument handed_on(const std::string& name, std::string about, std::string type,
                   std::vector<std::string>& words);

/// The problem with more than one `--target`, or "".
std::string check_one_target(const GraphOptions& options);

/// The command that `table` describes. Its options live as long as the command, and start as
/// `initial`.
template <class Options>
Command with_options(Command (*table)(Options& options), Options initial = {}) {
  auto options = std::make_shared<Options>(std::move(initial));
  Command command = table(*options);
  command.options = std::move(options);
  return command;
}

}  // namespace eagerx::gen
