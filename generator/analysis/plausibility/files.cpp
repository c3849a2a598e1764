// Files that only the program reads.
#include <fmt/format.h>

#include <filesystem>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/support/files/missing_file.hpp"

namespace eagerx::gen {

void check_files(const CheckedGraph& checked, Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  const AgentSpec& agent = checked.spec.agent;
  if (agent.kind != AgentSpec::Kind::csv) return;
  const std::string& name = agent.file.value;
  // The program looks for it where it is started: here, or most likely in the folder of the graph.
  const fs::path next_to_graph = fs::path(checked.spec.path).parent_path() / name;
  std::error_code error;
  if (fs::exists(name, error) || fs::exists(next_to_graph, error)) return;
  const Help help = help_for_missing(next_to_graph.string(), name);
  diagnostics
      .warning("W0118", agent.file.span,
               fmt::format("there is no file `{}`, neither here nor next to the graph", name))
      .help = !help.empty() ? help
                            : "the program reads a row of numbers for each step, from the folder "
                              "that it is started in";
}

}  // namespace eagerx::gen
