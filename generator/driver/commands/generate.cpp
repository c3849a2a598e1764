// eagerx-gen generate: the program of a graph, or its library.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "generator/driver/build/built.hpp"
#include "generator/driver/build/depfile.hpp"
#include "generator/driver/build/emitted.hpp"
#include "generator/driver/build/folder.hpp"
#include "generator/driver/build/packages.hpp"
#include "generator/driver/build/part_package.hpp"
#include "generator/driver/build/standalone.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/check_targets.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/next_steps.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/files/missing_file.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Refuses what CMake, or the ninja that it writes rules for, cannot have in the path of a project.
void check_output_path(Run& run, const std::string& path) {
  for (const std::string_view part : {";", "\"", "\\", "|", "${", "$<", "\n", "\r"}) {
    if (path.find(part) == std::string::npos) continue;
    run.diagnostics
        .io_error("E0905", {},
                  fmt::format("CMake cannot build in `{}`: the path has `{}`", path, part))
        .help = "choose another folder with `--output`";
    return;
  }
}

bool keep_folder(Run& run, const GenerateOptions& options, const std::string& folder) {
  const auto waiting = [&] {
    if (!options.quiet) complain("waiting: another eagerx-gen builds in `{}`\n", folder);
  };
  if (KeptFolders::keep(folder, waiting)) return true;
  run.diagnostics
      .io_error("E0901", {},
                fmt::format("cannot write `{}`: {}", folder,
                            errno == EWOULDBLOCK ? "another eagerx-gen builds there"
                                                 : std::strerror(errno)))
      .help = help_for_deleted_folder(folder);
  return false;
}

}  // namespace

std::optional<Generated> generate_graph(Run& run, const GenerateOptions& options, int& code) {
  Generated generated;
  const bool is_part = !options.part.empty();
  if (is_part && !choose_language(run, options)) return std::nullopt;
  auto targets = check_targets(run, options);
  if (!targets) return std::nullopt;
  generated.targets = std::move(*targets);
  GraphOptions of_output = options;
  of_output.targets.clear();  // one folder has several of them
  const std::string folder = options.output.empty()
                                 ? folder_for_options("generated/" + run.graph->name, of_output) +
                                       (is_part ? "-" + options.part : "")
                                 : options.output;
  generated.folder = folder;
  check_output_path(run, absolute_path(folder).lexically_normal().string());
  check_headers(*run.plan, absolute_path(folder).lexically_normal().string(), run.diagnostics);
  if (run.diagnostics.has_errors()) return std::nullopt;
  EmitOptions emit_options = emit_options_for(
      run, options.makes_library() ? std::vector<const Target*>() : generated.targets,
      absolute_path(folder).lexically_normal().string());
  const bool standalone = is_standalone(options);
  const bool bare = is_bare(options);
  if (standalone) emit_options.header_folder = kHeaderFolder;
  emit_options.tables_as_text = standalone;
  const std::vector<Package> packages =
      is_part ? std::vector<Package>() : read_packages(run, options);
  check_names(run, packages);
  check_for_packages(run, options);
  emit_options.extra = templates_of(run, options, packages);
  emit_options.cmake = !bare;
  const bool split = run.graph->placement.has_value();
  if (split && standalone) {
    run.diagnostics
        .error("E0336", run.graph->placement->span(), "a split graph has no standalone tree")
        .help = "leave out `--standalone` and `--package`";
  }
  if (split && options.makes_library()) {
    run.diagnostics.error("E0336", run.graph->placement->span(), "a split graph has no library")
        .help = "leave out `--library`";
  }
  if (run.diagnostics.has_errors()) return std::nullopt;
  auto files = emit_program(run, emit_options);
  if (files && is_part) keep_part(options.part, *files);
  if (files && standalone &&
      !carry_along(run, emit_options.targets, emit_options.output, bare, *files))
    files.reset();
  if (files) place_headers(run, options, packages, emit_options.extra, *files);
  if (!files) {
    code = kProblems;
    return std::nullopt;
  }
  if (!are_different(folder, *files, run.diagnostics) || !write_depfile(run, options))
    return std::nullopt;
  generated.graph_hash = hash_in(*files);
  if (!keep_folder(run, options, folder)) return std::nullopt;
  const auto result = write_files(folder, std::move(*files), run.diagnostics);
  if (!result) return std::nullopt;
  generated.targets = emit_options.targets;
  generated.packages = packages;
  generated.written = result->written;
  generated.unchanged = result->unchanged;
  generated.kept = result->kept;
  return generated;
}

namespace {

int perform(const GenerateOptions& options) {
  Run run;
  int code = kDone;
  const auto generated = make(run, options) ? generate_graph(run, options, code) : std::nullopt;
  if (generated && !options.quiet) {
    say("{}: {} written, {} unchanged{}\n", generated->folder, counted(generated->written, "file"),
        generated->unchanged,
        generated->kept == 0 ? "" : fmt::format(", {} of yours left as they are", generated->kept));
    if (!options.part.empty()) {
      say("{}", next_steps_of_part(run, options.part, generated->folder));
    } else if (!is_bare(options)) {
      say("{}", next_steps(run, options, generated->targets, generated->folder));
    }
    say("{}", next_steps(run, options, generated->packages, generated->folder));
  }
  return std::max(finish(run, options), code);
}

Arguments outputs(GenerateOptions& options) {
  return {
      folder(text("-o,--output", options.output,
                  "output folder (default: generated/<graph name>, followed by the name of a "
                  "variant, engine or policy)",
                  "DIR")),
      flag("--library", options.library,
           "write a library for your own main loop instead of a program"),
      cut_out_nodes(options,
                    "write a library of only these nodes, composites or arrays, whose connections "
                    "to the rest become its actions and observations; may be repeated"),
      flag(
          "--standalone", options.standalone,
          "also copy the headers that the output includes, so that it compiles without eagerx-gen"),
      experimental(
          text("--part", options.part,
               "write only this part of a graph with `placement:`, in the language of `--package`",
               "PART")),
      texts("--package", options.packages,
            "write a standalone package for arduino, esp-idf, platformio or zephyr: with --library "
            "a controller for hardware, otherwise an episode of the simulation; may be repeated. "
            "With --part, the language: python or c",
            "NAME"),
      writes(text("--depfile", options.depfile,
                  "also write the dependencies of the output as a Makefile, whose target is FILE "
                  "without .d",
                  "FILE.d"))};
}

Command table(GenerateOptions& options) {
  return {.name = "generate",
          .about = "generate the program of a graph",
          .examples = {{"a program for Linux, in generated/pendulum",
                        "eagerx-gen generate pendulum.yaml"},
                       {"for a board, in a folder of your choice",
                        "eagerx-gen generate pendulum.yaml --target mps2-an386 -o out"},
                       {"a tree that compiles without eagerx-gen",
                        "eagerx-gen generate pendulum.yaml --standalone"},
                       {"a controller to flash with Arduino's tools",
                        "eagerx-gen generate controller.yaml --library --package arduino"},
                       {"part `vision` of a placed graph in Python, to fill in",
                        "eagerx-gen generate robot.yaml --part vision --package python -o vision"},
                       {"the controller of a graph that also has a plant, for your own main loop",
                        "eagerx-gen generate robot.yaml --library --of controller"}},
          .arguments = joined({{graph(options)},
                               outputs(options),
                               selection(options),
                               rates(options),
                               {agent_policy(options), library(options), warnings(options)},
                               diagnostics(options)}),
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command generate_command() {
  return with_options<GenerateOptions>(table);
}

}  // namespace eagerx::gen
