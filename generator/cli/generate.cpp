// eagerx-gen generate and check.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "generator/cli/built.hpp"
#include "generator/cli/next_steps.hpp"
#include "generator/cli/packages.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/standalone.hpp"
#include "generator/cli/write.hpp"
#include "generator/compile/compile.hpp"
#include "generator/cut/cut.hpp"
#include "generator/emit/emit.hpp"
#include "generator/info/info.hpp"
#include "generator/plausibility/plausibility.hpp"
#include "generator/quote/quote.hpp"
#include "generator/read/text.hpp"
#include "generator/resolve/needs.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// "1 node", "2 nodes"
std::string counted(std::uint64_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// Whether a board's serial port is the one that the telemetry is planned for.
void check_serial_port(Run& run, const Target& target) {
  const auto& telemetry = run.graph->telemetry;
  if (!telemetry || !target.is_board() || target.baud == telemetry->baud) return;
  auto& problem = run.diagnostics.error(
      "E0341", telemetry->baud_span,
      target.baud ? fmt::format("telemetry over {} baud, but the serial port of `{}` has {}",
                                telemetry->baud, target.id.value, *target.baud)
                  : fmt::format("the serial port of `{}` takes no telemetry", target.id.value));
  if (target.baud) {
    problem.help = fmt::format("write `telemetry: {{baud: {}, …}}`", *target.baud);
  } else {
    problem.notes.push_back({"its manifest says no `baud`", target.id.span, ""});
    problem.help =
        "write `baud:` into the manifest and uart_offer() beside uart_write(), as "
        "targets/README.md says under \"Add a board\"";
  }
}

/// Whether the graph, or the part of it that stays on Linux, can run there.
void check_target(Run& run, const Target& target) {
  check_serial_port(run, target);
  const bool split = run.graph->placement.has_value();
  check_system(*run.graph, split ? Part::host : Part::whole, target, run.library, run.diagnostics);
  if (target.system.empty() && run.spec->agent.kind == AgentSpec::Kind::csv) {
    run.diagnostics
        .error("E0337", run.spec->agent.file.span,
               fmt::format("the agent reads a file, but target `{}` has no operating system",
                           target.id.value))
        .help = "for boards an agent is `zero`, `random` or `{policy: FILE}`";
  }
  if (!split) return;
  const Placement& placement = *run.graph->placement;
  if (target.system != "linux") {
    run.diagnostics
        .error("E0335", placement.span,
               fmt::format("target `{1}` cannot run the part beside `{0}`: that part needs Linux",
                           placement.board->id.value, target.id.value))
        .help = "leave out `--target`, or name a target of Linux";
  }
}

/// Refuses a target that `eagerx-gen new` has made and nobody has filled in yet.
void check_filled(Run& run, const Target& target) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of(run, target), error)) {
    const std::string ending = entry.path().extension().string();
    const bool is_source =
        ending == ".yaml" || ending == ".cpp" || ending == ".hpp" || ending == ".cmake";
    if (is_source && entry.is_regular_file(error)) files.push_back(entry.path().string());
  }
  std::ranges::sort(files);
  std::vector<Diagnostic::Note> blanks;
  for (const std::string& file : files) {
    const std::string text = load_file(file, ReadLimits().max_bytes).bytes;
    if (text.find("FILL_IN") == std::string::npos && text.find("#error") == std::string::npos)
      continue;
    const FileId id = run.sources.add(file, text);
    const auto lines = std::ranges::count(text, '\n');
    for (std::uint32_t line = 1; line <= lines; ++line) {
      const std::string_view words = run.sources.line(id, line);
      for (const std::string_view mark : {"FILL_IN", "#error \"fill in"}) {
        const std::size_t at = words.find(mark);
        if (at == std::string_view::npos) continue;
        const Span place{id, line, static_cast<std::uint32_t>(at + 1),
                         static_cast<std::uint32_t>(mark.size())};
        blanks.push_back({mark == "FILL_IN" ? fmt::format("line {} is a blank", line)
                                            : "a function has to be written",
                          place, "here"});
      }
    }
  }
  if (blanks.empty()) return;
  auto& problem =
      run.diagnostics.error("E0340", target.id.span,
                            fmt::format("the target `{}` is not filled in: {} left",
                                        target.id.value, counted(blanks.size(), "blank")));
  problem.notes = std::move(blanks);
  problem.help = "targets/README.md of eagerx-gen explains them under \"Add a board\"";
}

std::vector<const Target*> find_targets(Run& run, const Options& options) {
  std::vector<const Target*> result;
  for (const auto& wanted : wanted_targets(options)) {
    if (const Target* found = run.library.find_target(wanted)) {
      result.push_back(found);
      check_target(run, *found);
      check_filled(run, *found);
      continue;
    }
    std::vector<std::string> known;
    for (const auto& [id, target] : run.library.all_targets()) known.push_back(id);
    auto& problem = run.diagnostics.error("E0316", {}, fmt::format("unknown target `{}`", wanted));
    const std::string near = nearest(wanted, known);
    problem.help = near.empty() ? fmt::format("there is {}", fmt::join(known, ", "))
                                : fmt::format("did you mean `{}`?", near);
  }
  if (run.graph->placement) {
    check_filled(run, *run.graph->placement->board);
    check_system(*run.graph, Part::board, *run.graph->placement->board, run.library,
                 run.diagnostics);
  }
  return result;
}

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

/// Everything that the output was made from, in the form that make and ninja read.
std::string depfile_text(const Run& run, const Options& options) {
  const auto escaped = [](const std::string& path) {
    return make_path(fs::absolute(path).lexically_normal().string());
  };
  const std::string target = options.depfile.ends_with(".d")
                                 ? options.depfile.substr(0, options.depfile.size() - 2)
                                 : options.depfile;
  std::vector<std::string> inputs = {options.graph};
  for (const auto& [id, entity] : run.library.entities) inputs.push_back(entity.path);
  inputs.insert(inputs.end(), run.tables.begin(), run.tables.end());
  if (run.policies.agent) inputs.push_back(run.graph->agent.path);
  for (const auto& file : run.graph->agent.other_files) inputs.push_back(file);
  const fs::path folder = fs::path(run.spec->path).parent_path();
  for (const auto& node : run.spec->nodes) {
    if (!node.policy) continue;
    for (const auto& file : {node.policy->normalize, node.policy->golden})
      if (file) inputs.push_back((folder / file->value).string());
  }
  std::error_code ignored;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(run.root) / "templates", ignored)) {
    if (entry.is_regular_file(ignored)) inputs.push_back(entry.path().string());
  }
  for (const auto& [id, item] : run.library.targets) {
    for (const auto& [file, output] : item.templates) inputs.push_back(file);
    for (const auto& [file, output] : item.partner) inputs.push_back(file);
  }
  std::sort(inputs.begin() + 1, inputs.end());
  std::string text = escaped(target) + ":";
  for (const auto& input : inputs) {
    if (is_make_path(input)) text += " \\\n  " + escaped(input);
  }
  return text + "\n";
}

/// Before the output: if it cannot be written, the output stays as it was.
bool write_depfile(Run& run, const Options& options) {
  return options.depfile.empty() ||
         write_file(options.depfile, depfile_text(run, options), run.diagnostics);
}

/// The program, or one of the two of a split graph.
std::optional<std::vector<GeneratedFile>> emit_part(Run& run, const EmitOptions& options) {
  return emit(*run.plan, run.policies.agent, node_policies(*run.spec, *run.graph, run.policies),
              options, run.diagnostics);
}

/// The two programs of a split graph, in the folders `host` and `board`.
std::optional<std::vector<GeneratedFile>> emit_parts(Run& run, const EmitOptions& options) {
  std::vector<GeneratedFile> files;
  const auto add = [&](Part part, const std::string& folder, std::uint64_t hash) {
    EmitOptions of_part = options;
    of_part.part = part;
    of_part.graph_hash = hash;
    of_part.output = options.output + "/" + folder;
    if (part == Part::board) of_part.targets = {run.graph->placement->board};
    auto made = emit_part(run, of_part);
    for (auto& file : made.value_or(std::vector<GeneratedFile>()))
      files.push_back({folder + "/" + file.path, std::move(file.text)});
    return made.has_value();
  };
  // What the hash is made of comes first, with 0 in its place.
  if (!add(Part::host, "host", 0) || !add(Part::board, "board", 0)) return std::nullopt;
  const std::uint64_t hash = hash_of(files);
  files.clear();
  add(Part::host, "host", hash);
  add(Part::board, "board", hash);
  return files;
}

/// What an image takes is checked by `size`; what the plan says, before there is one.
void check_budget(Run& run) {
  if (!run.spec->budget) return;
  const YamlValue& budget = *run.spec->budget;
  if (budget.find("age") == nullptr && budget.find("link") == nullptr &&
      budget.find("telemetry") == nullptr)
    return;
  check_plan_budget(info_of(*run.plan, run.spec->budget, run.diagnostics), budget, run.diagnostics);
}

/// Whether the graph is as it is written: what is said of another variant says little of it.
bool is_as_written(const Options& options) {
  return options.engine.empty() && options.real.empty() && options.split.empty() &&
         options.of.empty() && options.targets.empty() && !options.engine_rate_hz &&
         !options.rate_hz;
}

std::set<std::string> names_in(const Graph& graph) {
  std::set<std::string> names;
  for (const auto& node : graph.nodes) names.insert(node.name);
  return names;
}

/// Everything besides the graph itself, for these targets.
void check_graph(Run& run, const std::vector<const Target*>& targets, const Options& options) {
  check_budget(run);
  // The compiler gets whole paths, an output is beside the library.
  check_headers(*run.plan, options.compile ? "/" : "", run.diagnostics);
  // Errors first: they may be why something looks odd.
  if (!run.diagnostics.has_errors())
    check_plausibility({*run.spec, *run.graph, *run.plan, targets}, run.diagnostics);
}

/// In place of a graph without problems the nodes of `--of`; false if they cannot be.
bool cut_out_nodes(Run& run, const Options& options) {
  check_graph(run, {}, options);
  if (run.diagnostics.has_errors()) return false;
  auto graph =
      cut_out(*run.graph, {options.of, run.composites, run.safety_of_cut}, run.diagnostics);
  if (!graph) return false;
  const std::set<std::string> inside = names_in(*graph);
  std::erase_if(run.policies.nodes, [&](const NodeNetwork& policy) {
    return !inside.contains(run.spec->nodes[policy.spec].name.value);
  });
  run.policies.agent.reset();
  run.graph = std::move(graph);
  run.plan = make_plan(*run.graph, run.diagnostics);
  if (run.plan) check_safe_outputs(*run.graph, run.diagnostics);
  return run.plan.has_value();
}

/// The targets, once there is what is generated for them. Nothing if there is a problem.
std::optional<std::vector<const Target*>> judged_targets(Run& run, const Options& options) {
  const bool cut = !options.of.empty();
  if (cut && !cut_out_nodes(run, options)) return std::nullopt;
  auto targets = find_targets(run, options);
  if (run.library.was_too_small()) {  // others are listed
    if (!make_again(run, options) || (cut && !cut_out_nodes(run, options))) return std::nullopt;
    targets = find_targets(run, options);
  }
  if (!cut) check_graph(run, targets, options);
  const bool complete = !run.diagnostics.has_errors() && is_as_written(options);
  allow_warnings(run.spec->allow, complete, run.diagnostics);
  if (options.warnings_as_errors) run.diagnostics.raise_warnings();
  return run.diagnostics.has_errors() ? std::nullopt : std::optional(std::move(targets));
}

}  // namespace

std::optional<Generated> generate_graph(Run& run, const Options& options, int& code) {
  Generated generated;
  auto targets = judged_targets(run, options);
  if (!targets) return std::nullopt;
  generated.targets = std::move(*targets);
  const std::string folder =
      options.output.empty() ? "generated/" + run.graph->name : options.output;
  generated.folder = folder;
  check_output_path(run, fs::absolute(folder).lexically_normal().string());
  check_headers(*run.plan, fs::absolute(folder).lexically_normal().string(), run.diagnostics);
  if (run.diagnostics.has_errors()) return std::nullopt;
  EmitOptions emit_options;
  emit_options.templates = (fs::path(run.root) / "templates").string();
  if (!options.library) emit_options.targets = generated.targets;
  emit_options.version = EAGERX_GEN_VERSION;
  emit_options.builtin_root = run.root;
  emit_options.output = fs::absolute(folder).lexically_normal().string();
  const bool standalone = is_standalone(options);
  const bool bare = is_bare(options);
  if (standalone) emit_options.header_folder = kHeaderFolder;
  const std::vector<Package> packages = read_packages(run, options);
  check_for_packages(run, options);
  emit_options.extra = templates_of(run, options, packages);
  emit_options.cmake = !bare;
  const bool split = run.graph->placement.has_value();
  if (split && standalone) {
    run.diagnostics
        .error("E0336", run.graph->placement->span, "a split graph has no standalone tree")
        .help = "leave out `--standalone` and `--package`";
  }
  if (split && options.library) {
    run.diagnostics.error("E0336", run.graph->placement->span, "a split graph has no library")
        .help = "leave out `--library`";
  }
  if (run.diagnostics.has_errors()) return std::nullopt;
  auto files = split ? emit_parts(run, emit_options) : emit_part(run, emit_options);
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
  const auto result = write_files(folder, std::move(*files), run.diagnostics);
  if (!result) return std::nullopt;
  generated.targets = emit_options.targets;
  generated.packages = packages;
  generated.written = result->written;
  generated.unchanged = result->unchanged;
  generated.kept = result->kept;
  return generated;
}

std::optional<ProgramFacts> facts_of_program(Run& run, const Options& options) {
  // It is equal for all targets and outputs.
  auto targets = find_targets(run, options);
  if (run.library.was_too_small()) {  // others are listed
    if (!make_again(run, options)) return std::nullopt;
    targets = find_targets(run, options);
  }
  EmitOptions emit_options;
  emit_options.templates = (fs::path(run.root) / "templates").string();
  emit_options.targets = std::move(targets);
  emit_options.version = EAGERX_GEN_VERSION;
  emit_options.builtin_root = run.root;
  emit_options.output = fs::current_path().string();
  const auto files =
      run.graph->placement ? emit_parts(run, emit_options) : emit_part(run, emit_options);
  const auto hash = files ? hash_in(*files) : std::nullopt;
  if (!hash) return std::nullopt;
  ProgramFacts facts{*hash, {}};
  for (const GeneratedFile& file : *files) {
    if (file.path.ends_with("/telemetry.json")) facts.telemetry = file.text;
  }
  return facts;
}

int generate_command(const Options& options) {
  Run run;
  int code = kDone;
  const auto generated = make(run, options) ? generate_graph(run, options, code) : std::nullopt;
  if (generated && !options.quiet) {
    say("{}: {} files written, {} unchanged{}\n", generated->folder, generated->written,
        generated->unchanged,
        generated->kept == 0 ? "" : fmt::format(", {} of yours left as they are", generated->kept));
    if (!is_bare(options))
      say("{}", next_steps(run, options, generated->targets, generated->folder));
    say("{}", next_steps(run, options, generated->packages, generated->folder));
  }
  return std::max(finish(run, options), code);
}

void compile_entities(Run& run, const std::vector<const Target*>& targets,
                      Diagnostics& diagnostics) {
  const TemporaryFolder folder;
  if (folder.path().empty()) {
    diagnostics.io_error("E0901", {},
                         fmt::format("cannot make a temporary folder: {}", std::strerror(errno)));
    return;
  }
  EmitOptions emit_options;
  emit_options.templates = (fs::path(run.root) / "templates").string();
  emit_options.targets = targets;
  emit_options.version = EAGERX_GEN_VERSION;
  emit_options.builtin_root = run.root;
  emit_options.output = folder.path();
  const auto files = emit_part(run, emit_options);
  if (!files) return;
  const char* compiler = std::getenv("CXX");
  check_entities(*run.plan, *files, folder,
                 {compiler != nullptr && *compiler != '\0' ? compiler : "c++", run.root,
                  run.graph->include_roots, packages_of(*run.graph, Part::whole)},
                 run.sources, diagnostics);
}

bool check_text(Run& run, const Options& options, const std::string& text) {
  return make_of_text(run, options, text) && judged_targets(run, options);
}

int check_command(const Options& options) {
  Run run;
  const auto targets = make(run, options) ? judged_targets(run, options) : std::nullopt;
  if (targets && options.compile) compile_entities(run, *targets, run.diagnostics);
  const int code = finish(run, options);
  if (code == kDone && !options.quiet) {
    std::uint64_t messages = 0;
    const auto warnings = static_cast<std::uint64_t>(
        std::ranges::count(run.diagnostics.all(), Severity::warning, &Diagnostic::severity));
    for (const auto& ring : run.plan->rings) messages += ring.capacity;
    say("{}: {}, {}, {} with room for {}; {}\n", options.graph,
        counted(run.graph->nodes.size(), "node"), counted(run.plan->rates.size(), "rate"),
        counted(run.plan->rings.size(), "buffer"), counted(messages, "message"),
        warnings == 0 ? "no problems" : counted(warnings, "warning"));
  }
  return code;
}

}  // namespace eagerx::gen
