// eagerx-gen pil: processor in the loop. A simulation of the whole graph records the messages that
// cross the cut, and the library of the cut-out nodes must answer the same, on Linux or on a board.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <runtime/host/base/handover.hpp>
#include <runtime/host/base/hash.hpp>

#include "generator/driver/build/built.hpp"
#include "generator/driver/build/library_project.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/check_targets.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/process.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/trace/pil_recording.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct PilOptions : GenerateOptions {
  std::vector<std::string> of_simulation;  // words for its program
};

/// Runs the simulation; the log that it has written, or nothing.
std::optional<std::string> record(const PilOptions& options, const std::string& folder, int& code) {
  GenerateOptions whole = options;
  whole.of.clear();
  whole.targets.clear();
  whole.purpose = Purpose::recording;
  whole.output = folder + "/simulation";
  Run run;
  const auto programs = build_graph(run, whole, code);
  // In a folder that is ours whatever else the user has.
  std::string log = folder + "/simulation/build/recorded.log";
  if (programs && run.graph->has_reset_nodes()) {
    run.diagnostics.error("E0517", run.graph->span,
                          "the simulation has reset nodes, and a library has no reset routine");
  } else if (programs) {
    std::vector<std::string> command = {absolute_path(programs->back().image).string(), "--quiet",
                                        "--trace", log};
    command.insert(command.end(), options.of_simulation.begin(), options.of_simulation.end());
    ProcessOptions expecting;
    if (const auto hash = programs->back().graph_hash)
      expecting.environment.emplace_back(host::kExpectedGraph, host::hex_text(*hash));
    const auto result = run_process(command, expecting);
    if (!result || result->exit_code != 0) {
      auto& problem = run.diagnostics.error("E0517", {}, "the simulation did not end well");
      if (result) problem.notes.push_back({result->output, {}, ""});
    }
  }
  // Warnings of the graph are those of the library, too.
  if (programs && !run.diagnostics.has_errors()) return log;
  code = std::max(code, finish(run, whole));
  return std::nullopt;
}

/// Whether its programs can be stepped with what is in memory.
bool check_pil_target(Run& run, const Target& target) {
  const bool good = !target.run.empty() && (target.system == "linux" || target.is_board());
  if (good) return true;
  run.diagnostics
      .error("E0515", {}, fmt::format("nothing here can run a program for `{}`", target.id.value))
      .help = "take linux-sim, or a board with an emulator: `eagerx-gen info` lists them";
  return false;
}

/// Whether the library can be made, before the simulation is built. What is wrong has been said.
bool can_be_made(const PilOptions& options, int& code) {
  Run run;
  const auto targets = make(run, options) ? check_targets(run, options) : std::nullopt;
  const bool good = targets && check_pil_target(run, *targets->front());
  if (!good) code = finish(run, options);
  return good;  // then warnings are said with the library
}

std::optional<BuiltProgram> build_pil(Run& run, const PilOptions& options,
                                      const std::string& folder, const std::string& log,
                                      int& code) {
  GenerateOptions library = options;
  library.output = folder + "/library";
  const auto generated = make(run, library) ? generate_graph(run, library, code) : std::nullopt;
  if (!generated) return std::nullopt;
  const Target& target = *run.library.find_target(wanted_targets(options).front());
  std::string why;
  const auto recording = recording_of(log, *run.graph, why);
  if (!recording || recording->steps == 0) {
    run.diagnostics.error("E0517", {}, recording ? "the simulation has no steps to compare" : why);
    return std::nullopt;
  }
  return build_library_project(run, options, target, "pil", folder,
                               {{"recorded.bin", recording->words}});
}

int perform(const PilOptions& options) {
  int code = kDone;
  if (!can_be_made(options, code)) return code;
  std::string folder = options.output;
  if (folder.empty())
    folder = folder_for_options("generated/" + fs::path(options.graph).stem().string() + "-pil",
                                options);
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  const auto log = record(options, folder, code);
  if (!log) return std::max(code, int{kProblems});
  Run run;
  const auto pil = build_pil(run, options, folder, *log, code);
  code = std::max(finish(run, options), code);
  return pil && code == kDone ? exec_built(run, *pil, {}) : code;
}

Command table(PilOptions& options) {
  const auto option = [&options](const char* name, const char* about) {
    return handed_on(name, about, "N", options.of_simulation);
  };
  return {
      .name = "pil",
      .about =
          "processor in the loop: step a library of nodes with the recorded inputs of a "
          "simulation, and compare each output bit by bit",
      .examples = {{"on this machine", "eagerx-gen pil robot.yaml --of controller"},
                   {"on an emulated board",
                    "eagerx-gen pil robot.yaml --of controller --target mps2-an386 --steps 200"}},
      .arguments =
          joined({{graph(options),
                   required(cut_out_nodes(options, "nodes, composites or arrays of the library")),
                   option("--steps", "steps of an episode of the simulation"),
                   option("--episodes", "number of episodes (default: 1)"),
                   option("--seed", "seed of random numbers"),
                   folder(text("-o,--output", options.output,
                               "folder for the simulation, the library and the recorded messages "
                               "(default: generated/<graph file>-pil, followed by the name of "
                               "another target, a variant, engine or policy)",
                               "DIR"))},
                  {variant(options), engine(options),
                   texts("--target", options.targets,
                         "target that runs the library (default: linux-sim)", "NAME")},
                  rates(options),
                  {agent_policy(options), library(options), warnings(options)},
                  diagnostics(options)}),
      .check = [&options] { return check_one_target(options); },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command pil_command() {
  return with_options<PilOptions>(table);
}

}  // namespace eagerx::gen
