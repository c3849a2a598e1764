// eagerx-gen build and run.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/cli/become.hpp"
#include "generator/cli/built.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// So that two targets in turn do not write over each other, and nothing is built twice.
std::string default_folder(const Graph& graph, const Options& options) {
  std::string folder = "generated/" + graph.name;
  for (const std::string& target : options.targets) {
    if (target != "linux-sim") folder += "-" + target;
  }
  return folder;
}

bool build_one(Run& run, const Options& options, const Target& target, const std::string& folder,
               bool several, bool waits, std::vector<BuiltProgram>& programs) {
  const Tree tree = tree_of(run, options, target, folder, several);
  const std::string what = waits || several || !target.toolchain.empty()
                               ? fmt::format("{} for {}", run.graph->name, target.id.value)
                               : run.graph->name;
  programs.push_back({&target, tree.build, image_of(run, target, tree.build), waits});
  return build_tree(tree, what, options.quiet, run.diagnostics);
}

}  // namespace

std::string image_of(const Run& run, const Target& target, const std::string& build) {
  return build + "/" + run.graph->name + (target.system.empty() ? ".elf" : "");
}

std::vector<std::string> command_to_start(const Run& run, const BuiltProgram& program) {
  const Target& target = *program.target;
  if (target.toolchain.empty()) return {program.image};
  if (target.run.empty()) return {};
  return {(fs::path(run.root) / "targets" / "run").string(),
          is_own(run, target) ? folder_of(run, target) : target.id.value, program.image};
}

std::optional<std::vector<BuiltProgram>> build_graph(Run& run, Options options, int& code) {
  if (!make(run, options)) return std::nullopt;
  if (options.output.empty()) options.output = default_folder(*run.graph, options);
  const auto generated = generate_graph(run, options, code);
  if (!generated) return std::nullopt;
  const std::string& folder = generated->folder;
  const bool split = run.graph->placement.has_value();
  const bool several = generated->targets.size() > 1;
  std::vector<BuiltProgram> programs;
  bool good = !split || build_one(run, options, *run.graph->placement->board, folder + "/board",
                                  false, true, programs);
  for (const Target* target : generated->targets)
    good = good && build_one(run, options, *target, split ? folder + "/host" : folder, several,
                             false, programs);
  if (!good) return std::nullopt;
  return programs;
}

int build_command(const Options& options) {
  Run run;
  int code = kDone;
  const auto programs = build_graph(run, options, code);
  if (programs && !options.quiet) {
    for (const BuiltProgram& program : *programs) say("{}\n", program.image);
  }
  return std::max(finish(run, options), code);
}

int run_command(const Options& options) {
  Run run;
  int code = kDone;
  const auto programs = build_graph(run, options, code);
  std::vector<std::string> command;
  if (programs) {
    command = command_to_start(run, programs->back());
    if (command.empty()) {
      const Target& target = *programs->back().target;
      run.diagnostics
          .error("E0515", {},
                 fmt::format("nothing here can run a program for `{}`", target.id.value))
          .help = fmt::format(
          "bring `{}` to the board as its documentation says; for an emulator, "
          "add `run:` to the target's manifest",
          programs->back().image);
    }
  }
  code = std::max(finish(run, options), code);
  if (!programs || command.empty()) return code;
  if (command.front() != programs->back().image)
    command.insert(command.end() - 1, {"--time-limit", "0"});  // as long as the user wants
  command.insert(command.end(), options.program_options.begin(), options.program_options.end());
  return become(command.front(), {command.begin() + 1, command.end()});
}

}  // namespace eagerx::gen
