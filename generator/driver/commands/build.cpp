// eagerx-gen build: builds the programs of a graph.
#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <runtime/host/base/handover.hpp>
#include <runtime/host/base/hash.hpp>
#include <string_view>

#include "generator/driver/build/built.hpp"
#include "generator/driver/build/emitted.hpp"
#include "generator/driver/build/exec.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/image_budget.hpp"
#include "generator/driver/commands/image_time.hpp"
#include "generator/driver/commands/margin_budget.hpp"
#include "generator/driver/commands/program_options.hpp"
#include "generator/driver/commands/start_parts.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::string image_of(const Run& run, const Target& target, const std::string& build) {
  std::string file = target.image.empty()
                         ? "{name}" + std::string(target.system.empty() ? ".elf" : "")
                         : target.image;
  constexpr std::string_view kName = "{name}";
  const std::size_t at = file.find(kName);
  if (at != std::string::npos) file.replace(at, kName.size(), run.graph->name);
  return build + "/" + file;
}

std::vector<std::string> command_to_start(const Run& run, const BuiltProgram& program) {
  const Target& target = *program.target;
  if (target.run.empty()) return {};
  if (!target.language.empty()) {
    std::vector<std::string> command = target.run;
    std::ranges::replace(command, std::string("{image}"), program.image);
    return command;
  }
  if (target.toolchain.empty()) return {program.image};
  return {(fs::path(run.root) / "targets" / "run").string(),
          is_own(run, target) ? folder_of(run, target) : target.id.value, program.image};
}

bool is_compiled(const Target& target) {
  return target.language.empty() || ranges::any_of(target.partner, [](const auto& item) {
           return item.second == "CMakeLists.txt";
         });
}

void expect_graph(const BuiltProgram& program) {
  if (program.graph_hash)
    setenv(host::kExpectedGraph, host::hex_text(*program.graph_hash).c_str(), 1);
}

namespace {

/// Another name for a file that is open from now on, so that it is this one whatever becomes of its
/// name before an emulator has opened it.
std::string opened(const std::string& image) {
  const int file = open(image.c_str(), O_RDONLY);
  return file < 0 ? image : fmt::format("/proc/self/fd/{}", file);
}

}  // namespace

int exec_built(const Run& run, const BuiltProgram& program, const std::vector<std::string>& words) {
  std::vector<std::string> command = command_to_start(run, program);
  if (command.front() != program.image) {
    if (program.target->is_board()) command.back() = opened(command.back());
    command.insert(command.end() - 1, {"--time-limit", "0"});  // as long as the user wants
  }
  expect_graph(program);
  setenv("UBSAN_OPTIONS", "print_stacktrace=1", 0);  // of `--sanitize`, as the user has it if set
  command.insert(command.end(), words.begin(), words.end());
  return exec(command.front(), {command.begin() + 1, command.end()});
}

namespace {

/// The programs of a generated graph, as they will be; the last one is what a user starts.
struct Planned {
  BuiltProgram program;
  Tree tree;
  bool is_compiled = true;
};
std::vector<Planned> planned(const Run& run, const GenerateOptions& options,
                             const Generated& generated) {
  const std::string& folder = generated.folder;
  const bool split = run.graph->placement.has_value();
  std::vector<Planned> result;
  const auto add = [&](const Target& target, const std::string& source, bool several) {
    Tree tree = tree_of(run, options, target, source, several);
    const bool compiled = is_compiled(target);
    if (!compiled) tree.build = tree.source;
    BuiltProgram program{&target, tree.build, image_of(run, target, tree.build), nullptr,
                         generated.graph_hash};
    result.push_back({std::move(program), std::move(tree), compiled});
  };
  if (split) {
    for (const PlacedPart& part : run.graph->placement->parts) {
      add(*part.target, folder + "/" + part.name, false);
      result.back().program.part = &part;
    }
  }
  for (const Target* target : generated.targets)
    add(*target, split ? folder + "/" + kHubFolder : folder, generated.targets.size() > 1);
  return result;
}

/// "swing", with its target if that is not this machine.
std::string title(const Run& run, const Planned& item) {
  const Target& target = *item.program.target;
  if (item.program.part != nullptr && item.program.part->name != "board")
    return fmt::format("part `{}` of {} for {}", item.program.part->name, run.graph->name,
                       target.id.value);
  return target.toolchain.empty() ? run.graph->name
                                  : fmt::format("{} for {}", run.graph->name, target.id.value);
}

/// Whether any of them can be built with sanitizers.
bool check_sanitized(Run& run, const std::vector<Planned>& items) {
  const auto is_native = [](const Planned& item) {
    return item.program.target->id.value == "linux-sim";
  };
  if (ranges::any_of(items, is_native)) return true;
  run.diagnostics
      .usage_error("E0516", fmt::format("`{}` has no programs with sanitizers",
                                        items.back().program.target->id.value))
      .help = "leave out `--target`: on Linux the same graph has the same bits";
  return false;
}

/// Whether it can be run here; that is asked before it is built.
bool check_start(Run& run, const BuiltProgram& program) {
  if (!command_to_start(run, program).empty()) return true;
  const std::string& target = program.target->id.value;
  run.diagnostics.error("E0515", {}, fmt::format("nothing here can run a program for `{}`", target))
      .help = program.target->toolchain.empty() ? "it is not a program: `eagerx-gen build` makes it"
                                                : "`eagerx-gen build` makes the image, which you "
                                                  "bring to the board yourself; for an emulator, "
                                                  "add `run:` to the target's manifest";
  return false;
}

}  // namespace

bool build_program(Run& run, const Tree& tree, const Target& target, const std::string& name,
                   bool quiet, const std::string& cmake_target) {
  Diagnostics building;
  if (build_tree(tree, name, quiet, building, cmake_target)) return true;
  Diagnostics entities;
  const auto is_of_compiler = [](const Diagnostic& each) { return each.code == "E0514"; };
  if (ranges::any_of(building.all(), is_of_compiler)) compile_entities(run, {&target}, entities);
  const auto tell = [&](const Diagnostics& from, auto&& wanted) {
    bool reported = false;
    for (const Diagnostic& each : from.all()) {
      if (!wanted(each)) continue;
      (each.io ? run.diagnostics.io_error("", {}, "") : run.diagnostics.error("", {}, "")) = each;
      reported = true;
    }
    return reported;
  };
  const auto is_code = [](const Diagnostic& each) {
    return each.code == "E0510" || each.code == "E0511";
  };
  // Code that breaks a promise of the runtime builds for Linux, but not for a board.
  const auto is_promise = [&](const Diagnostic& each) {
    return each.code == "E0512" && target.system.empty();
  };
  if (!tell(entities, is_code) && !tell(entities, is_promise))
    tell(building, [](const Diagnostic&) { return true; });
  return false;
}

std::optional<std::vector<BuiltProgram>> build_graph(Run& run, GenerateOptions options, int& code,
                                                     std::vector<std::string>* to_run) {
  if (!make(run, options)) return std::nullopt;
  return build_made_graph(run, std::move(options), code, to_run);
}

std::optional<std::vector<BuiltProgram>> build_made_graph(Run& run, GenerateOptions options,
                                                          int& code,
                                                          std::vector<std::string>* to_run) {
  if (options.output.empty())
    options.output = folder_for_options("generated/" + run.graph->name, options);
  const auto generated = generate_graph(run, options, code);
  if (!generated) return std::nullopt;
  const std::vector<Planned> items = planned(run, options, *generated);
  if (options.sanitize && !check_sanitized(run, items)) {
    code = kWrongUsage;
    return std::nullopt;
  }
  if (to_run != nullptr) {
    const Planned& last = items.back();
    if (!check_start(run, last.program)) return std::nullopt;
    std::vector<BuiltProgram> all;
    all.reserve(items.size());
    for (const Planned& item : items) all.push_back(item.program);
    if (!check_parts(run, all, *to_run)) return std::nullopt;
    if (!check_program_options(run, *last.program.target, *to_run)) {
      code = kWrongUsage;
      return std::nullopt;
    }
  }
  std::vector<BuiltProgram> programs;
  for (const Planned& item : items) {
    if (item.is_compiled &&
        !build_program(run, item.tree, *item.program.target, title(run, item), options.quiet))
      return std::nullopt;
    programs.push_back(item.program);
  }
  return programs;
}

namespace {

struct BuildOptions : GenerateOptions {};

int perform(const BuildOptions& options) {
  Run run;
  int code = kDone;
  const auto programs = build_graph(run, options, code);
  if (programs) check_built_budget(run, options, *programs);
  if (programs) check_margin_budget(run, options);
  if (programs && !options.quiet) {
    note_built_time(run, options, *programs);
    for (const BuiltProgram& program : *programs) say("{}\n", program.image);
  }
  return std::max(finish(run, options), code);
}

Command table(BuildOptions& options) {
  return {
      .name = "build",
      .about =
          "generate and build the program of a graph, and check the image of a board against the "
          "graph's `budget:`",
      .examples = {{"a program for Linux, in generated/pendulum/build",
                    "eagerx-gen build pendulum.yaml"},
                   {"an image for a board", "eagerx-gen build pendulum.yaml --target stm32f405"}},
      .arguments = on_building(options),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command build_command() {
  return with_options<BuildOptions>(table);
}

}  // namespace eagerx::gen
