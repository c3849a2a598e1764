#include "generator/driver/pipeline/pipeline.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "generator/driver/pipeline/paths.hpp"
#include "generator/frontend/compose/compose.hpp"
#include "generator/frontend/compose/variants.hpp"
#include "generator/frontend/outline/fixes.hpp"
#include "generator/frontend/tables/tables.hpp"
#include "generator/support/diagnostics/pages.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/files.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The folders that a graph names, whatever else is in it.
std::vector<Spanned<std::string>> library_folders(const YamlValue& graph, const std::string& path) {
  std::vector<Spanned<std::string>> folders;
  const YamlValue* library = graph.find("library");
  if (library == nullptr) return folders;
  for (const auto& folder : library->items) {
    if (!folder.is_scalar()) continue;
    // One without a name is none, and not the graph's own.
    folders.push_back(
        {folder.text.empty() ? "" : (fs::path(path).parent_path() / folder.text).string(),
         folder.span});
  }
  return folders;
}

/// Those of the command line, of the graph, and what is installed.
void read_library(Run& run, const LibraryOptions& options,
                  const std::vector<Spanned<std::string>>& of_graph = {}) {
  run.root = data_root();
  if (run.root.empty()) {
    run.diagnostics.io_error("E0301", {}, "cannot find the folder with models and templates").help =
        "install eagerx-gen with `cmake --install`, or set EAGERX_HOME to that folder";
    return;
  }
  std::vector<Spanned<std::string>> folders, installed;
  for (const auto& path : options.paths) folders.push_back({path, {}});
  folders.insert(folders.end(), of_graph.begin(), of_graph.end());
  for (const char* part : {"models", "targets"})
    installed.push_back({(fs::path(run.root) / part).string(), {}});
  run.library = load_library(folders, run.sources, run.diagnostics, installed);
  const fs::path models = absolute_path(fs::path(run.root) / "models").lexically_normal();
  for (auto& [id, entity] : run.library.entities)
    entity.own = entity.include_root != models.parent_path().string();
}

/// Library, compose, spec: of a graph in our own form. Each looks for problems, whatever the one
/// before it found.
bool read_own_graph(Run& run, const GraphOptions& options) {
  const std::size_t errors_before = run.diagnostics.error_count();
  const auto is_right = [&] { return run.diagnostics.error_count() == errors_before; };
  read_library(run, options, library_folders(run.tree, options.graph));
  FlatGraph flat{run.tree, GraphForm::written, {}, {}};
  if (is_right()) flat = compose(run.tree, run.library, run.sources, run.diagnostics);
  const bool composed = is_right();
  run.spec = read_graph_spec(flat.root, options.graph, run.diagnostics, flat.form);
  run.flat = std::move(flat.root);
  run.composites = std::move(flat.ends);
  if (run.spec) run.spec->composites = std::move(flat.composites);
  return run.spec && composed;
}

}  // namespace

void load(Run& run, const LibraryOptions& options) {
  read_library(run, options);
  run.library.read_all();
}

YamlValue read_graph_file(Run& run, const std::string& path) {
  Diagnostics strict;
  YamlValue tree = read_yaml_file(path, run.sources, strict);
  if (strict.has_errors() && !strict.has_io_errors()) {
    // A file of EAGERx may have Python's tags; in a graph they are mistakes.
    const std::string& text = run.sources.text(strict.all().front().span.file);
    if (text.find("\ngui_state:") != std::string::npos)
      return read_yaml_text(path, text, run.sources, run.diagnostics, Tags::accept);
  }
  run.diagnostics = std::move(strict);
  return tree;
}

std::optional<ImportedGraph> import_file(Run& run, const YamlValue& tree,
                                         const GraphOptions& options) {
  load(run, options);
  if (run.diagnostics.has_errors()) return std::nullopt;
  return import_graph(
      tree, options.graph, run.library,
      {options.engine, options.engine_rate_hz, options.rate_hz, options.keep_processes},
      run.diagnostics);
}

namespace {

/// `--split a,b=TARGET` or `a,b=PART:TARGET`, which has no place in a file.
std::vector<PlacementSpec> placement_of(const GraphOptions& options) {
  std::vector<PlacementSpec> result;
  for (const auto& item : options.split) {
    const std::size_t equals = item.rfind('=');
    const std::string place = item.substr(equals + 1);
    const std::size_t colon = place.find(':');
    PlacementSpec spec;
    if (colon != std::string::npos) spec.part.value = place.substr(0, colon);
    spec.target.value = colon == std::string::npos ? place : place.substr(colon + 1);
    for (std::string& name : comma_separated(item.substr(0, equals))) {
      spec.name.value = std::move(name);
      result.push_back(spec);
    }
  }
  return result;
}

/// The trainer decides instead of the agent, whose policy may not be there yet, and on one machine.
void prepare_for_training(Run& run) {
  run.spec->agent = {};
  run.spec->placement.clear();
  if (run.spec->task) return;
  run.diagnostics
      .error("E0370", run.spec->name.span, "the graph has no `task:`, so there is nothing to learn")
      .help =
      "add one that says what is good, when an episode ends, and what success is: `task: {inputs: "
      "{th: pendulum.theta}, reward: {upright: {value: th^2, weight: -1.0}}, truncated: {after: "
      "5.0}, success: {upright: abs(th) < 0.15, over_last: 2.0}}`";
}

/// All on one machine, where success can be seen.
void prepare_for_campaign(Run& run) {
  run.spec->placement.clear();
  const AgentSpec& agent = run.spec->agent;
  if (agent.kind == AgentSpec::Kind::csv) {
    run.diagnostics
        .error("E0381", agent.file.span,
               "the agent is a file of actions, which many runs cannot all repeat")
        .help =
        "name a policy with `--policy FILE`, or in the graph: `agent: {policy: FILE}`; `zero` and "
        "`random` are agents, too";
  }
  if (run.spec->task && !run.spec->task->success.empty()) return;
  run.diagnostics
      .error("E0380", run.spec->task ? run.spec->task->span : run.spec->name.span,
             run.spec->task ? "the task has no `success:`, so there is nothing to count"
                            : "the graph has no `task:`, so there is no success to count")
      .help =
      run.spec->task
          ? "say when an episode is a success: `success: {upright: abs(th) < 0.15, over_last: 2.0}`"
          : "add one that says when an episode ends and what success is: `task: {inputs: {th: "
            "pendulum.theta}, reward: {upright: {value: th^2, weight: -1.0}}, truncated: {after: "
            "5.0}, success: {upright: abs(th) < 0.15, over_last: 2.0}}`";
}

/// `safety:` is about outputs and measurements of the library, which the whole graph does not have.
void prepare_for_cut(Run& run) {
  run.spec->placement.clear();
  if (!run.spec->safety) return;
  SafetySpec& safety = *run.spec->safety;
  run.safety_of_cut = safety;
  run.safety_of_cut->no_outputs = false;  // said of a simulation, on which nothing acts
  safety.outputs.clear();
  safety.outputs_span.reset();
  safety.no_outputs = !run.spec->has_engine();
  safety.frozen.clear();
  std::erase_if(safety.settings, [](const Setting& setting) { return setting.name == "nodes"; });
}

/// Whether everything is for a target that runs whole graphs only: a library of environments.
bool wants_whole_graph(const Run& run, const GraphOptions& options) {
  return ranges::all_of(wanted_targets(options), [&](const std::string& id) {
    const Target* target = run.library.find_target(id);
    return target != nullptr && target->system == "linux" && target->partner.empty();
  });
}

void take_rates(Run& run, const GraphOptions& options) {
  if (options.rate_hz) run.spec->rate.value = *options.rate_hz;
  if (!options.engine_rate_hz || !run.spec->has_engine()) return;
  run.spec->engine.rate->value = *options.engine_rate_hz;
  run.spec->engine.rate->is_option = true;
}

/// `--policy FILE` replaces the graph's agent; the graph names files relative to itself.
void take_policy(Run& run, const GraphOptions& options) {
  if (options.agent_policy.empty()) return;
  const Span span =
      run.spec->agent.span.file == FileId::none ? run.spec->name.span : run.spec->agent.span;
  const fs::path folder = absolute_path(run.spec->path).parent_path();
  AgentSpec agent;
  agent.kind = AgentSpec::Kind::policy;
  agent.span = span;
  agent.file = {absolute_path(options.agent_policy).lexically_relative(folder).string(), span};
  run.spec->agent = std::move(agent);
}

/// Files that manifests name and that only the compiler reads.
void remember_headers(const Run& run) {
  const auto header = [](const fs::path& root, const CppClass& type) {
    if (!type.include.empty()) remember_input((root / type.include).string());
  };
  for (const auto& [id, entity] : run.library.entities) {
    header(entity.include_root, entity.cpp);
    for (const ObjectEngine& engine : entity.object_engines)
      header(engine.include_root, engine.model);
  }
}

bool read_saved_graph(Run& run, const GraphOptions& options) {
  auto imported = import_file(run, run.tree, options);
  if (imported) run.spec = std::move(imported->spec);
  return imported.has_value();
}

/// Options of the command line that override the graph.
void take_options(Run& run, const GraphOptions& options) {
  take_rates(run, options);
  take_policy(run, options);
  const AgentSpec& agent = run.spec->agent;
  if (agent.kind == AgentSpec::Kind::csv)  // which only the program reads
    remember_input((fs::path(run.spec->path).parent_path() / agent.file.value).string());
  if (!options.of.empty() || options.purpose == Purpose::recording) prepare_for_cut(run);
  if (options.purpose == Purpose::training) prepare_for_training(run);
  if (options.purpose == Purpose::campaign) prepare_for_campaign(run);
  if (options.purpose == Purpose::simulation || wants_whole_graph(run, options))
    run.spec->placement.clear();
}

/// False if numbers of the graph are not there.
bool add_tables(Run& run) {
  const std::size_t errors_before = run.diagnostics.error_count();
  run.tables = read_tables(*run.spec, run.sources, run.diagnostics);
  return run.diagnostics.error_count() == errors_before;
}

bool choose_variant(Run& run, const GraphOptions& options) {
  run.tree =
      choose_variant(run.written, options.graph, options.variant, run.sources, run.diagnostics);
  return !run.diagnostics.has_errors();
}

/// All stages from the graph's tree on, in their order. One that has no result ends it; the others
/// add what they find to the diagnostics, so that everything is said in one run.
bool make_of_written(Run& run, const GraphOptions& options) {
  if (!choose_variant(run, options)) return false;
  const bool read =
      is_saved_graph(run.tree) ? read_saved_graph(run, options) : read_own_graph(run, options);
  if (!read) return false;
  take_options(run, options);
  if (!add_tables(run)) return false;
  run.policies = read_policies(*run.spec, run.library, run.diagnostics);
  run.graph = resolve(*run.spec, run.library, {options.engine, options.real, placement_of(options)},
                      run.diagnostics);
  remember_headers(run);
  if (!run.graph) return false;
  run.plan = make_plan(*run.graph, run.diagnostics);
  check_policies(*run.spec, *run.graph, run.policies, run.diagnostics);
  return !run.diagnostics.has_errors();
}

}  // namespace

std::vector<std::string> wanted_targets(const GraphOptions& options) {
  return options.targets.empty() ? std::vector<std::string>{"linux-sim"} : options.targets;
}

bool make(Run& run, const GraphOptions& options) {
  run.written = read_graph_file(run, options.graph);
  return make_of_written(run, options);
}

bool make_of_text(Run& run, const GraphOptions& options, const std::string& text) {
  run.written = read_yaml_text(options.graph, text, run.sources, run.diagnostics);
  return make_of_written(run, options);
}

bool make_spec(Run& run, const GraphOptions& options) {
  return choose_variant(run, options) && read_own_graph(run, options);
}

int finish(Run& run, const MessageOptions& options) {
  if (const auto why = flush_output()) report_output(*why, run.diagnostics);
  run.diagnostics.drop_repeats();
  run.diagnostics.sort_by_place();
  if (options.quiet) run.diagnostics.drop_notes();
  if (options.json) {
    place_fixes(run.diagnostics, run.sources);
    std::fputs(render_json(run.diagnostics, run.sources).c_str(), stderr);
  } else if (!run.diagnostics.all().empty()) {
    const bool terminal = isatty(STDERR_FILENO) == 1;
    std::fputs(render_text(run.diagnostics, run.sources, terminal).c_str(), stderr);
    if (terminal) std::fputs(pointer_to_pages(run.diagnostics).c_str(), stderr);
  }
  if (run.diagnostics.has_usage_errors()) return kWrongUsage;
  if (run.diagnostics.has_io_errors()) return kInputOutput;
  return run.diagnostics.has_errors() ? kProblems : kDone;
}

}  // namespace eagerx::gen
