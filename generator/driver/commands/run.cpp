// eagerx-gen run: builds and runs the program of a graph.
#include <algorithm>
#include <filesystem>

#include "generator/driver/build/built.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/image_budget.hpp"
#include "generator/driver/commands/image_graph.hpp"
#include "generator/driver/commands/margin_budget.hpp"
#include "generator/driver/commands/start_parts.hpp"
#include "generator/support/files/files.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct RunOptions : GenerateOptions {
  std::vector<std::string> of_program;  // words for the program
};

/// The program knows which of its options name files, and which are outputs, and refuses those that
/// are one file. What it cannot know are the graph's own files: none of these is for it to open.
void spare_own_files(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t begin = word.starts_with("--") ? word.find('=') + 1 : 0;
    const std::string path = word.substr(begin);
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored)) remember_output(path, path);
  }
}

/// `--quiet` is for all that is printed: the build's lines, and the program's. A board has no
/// summary.
void pass_quiet(const Target& target, std::vector<std::string>& words) {
  if (!target.is_board() && std::ranges::find(words, "--quiet") == words.end())
    words.emplace_back("--quiet");
}

int perform(const RunOptions& options) {
  spare_own_files(options.of_program);
  Run run;
  int code = kDone;
  std::vector<std::string> words = options.of_program;
  const auto programs = build_graph(run, options, code, &words);
  if (programs) check_built_budget(run, options, *programs);
  if (programs) check_margin_budget(run, options);
  const bool started = programs && !run.diagnostics.has_errors() && code == kDone &&
                       check_image_graphs(run, *programs) && start_parts(run, *programs, words);
  code = std::max(finish(run, options), code);
  if (!started || code != kDone) return code;
  if (options.quiet) pass_quiet(*programs->back().target, words);
  return exec_built(run, programs->back(), words);
}

Command table(RunOptions& options) {
  return {.name = "run",
          .about =
              "generate, build and run the program of a graph; a board's image must be within the "
              "graph's `budget:`",
          .examples = {{"run on Linux, with options of the program after the graph",
                        "eagerx-gen run pendulum.yaml --seed 1 --steps 300"},
                       {"run in the emulator of a board",
                        "eagerx-gen run pendulum.yaml --target mps2-an386 --steps 300 --hash"},
                       {"run the controller on an emulated board, linked to the simulation",
                        "eagerx-gen run pendulum.yaml --split controller=mps2-an386 --hash"},
                       {"pass everything after `--` to the program",
                        "eagerx-gen run pendulum.yaml -- --help"}},
          .arguments = on_building(options),
          .rest =
              Argument{
                  "program-options",
                  "options of the program: those that eagerx-gen does not know, and everything "
                  "after `--`; on a board --steps, --seed, --episodes, --agent, --csv and --hash",
                  "PROGRAM OPTIONS", [&options](const auto& words) { options.of_program = words; }},
          .check = [&options] { return check_one_target(options); },
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command run_command() {
  return with_options<RunOptions>(table);
}

}  // namespace eagerx::gen
