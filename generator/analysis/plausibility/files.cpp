// Files that only the program reads.
#include <fmt/format.h>

#include <filesystem>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/support/files/beside.hpp"

namespace eagerx::gen {

void check_files(const Judged& judged, Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  const AgentSpec& agent = judged.spec.agent;
  if (agent.kind != AgentSpec::Kind::csv) return;
  const std::string& name = agent.file.value;
  // It is looked for where the program is started: here, or most likely beside the graph.
  const fs::path beside = fs::path(judged.spec.path).parent_path() / name;
  std::error_code error;
  if (fs::exists(name, error) || fs::exists(beside, error)) return;
  const Help help = help_for_missing(beside.string(), name);
  diagnostics
      .warning("W0118", agent.file.span,
               fmt::format("there is no file `{}`, neither here nor beside the graph", name))
      .help = !help.empty() ? help
                            : "the program reads a row of numbers for each step, from the folder "
                              "that it is started in";
}

}  // namespace eagerx::gen
