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

/// With `mentions`, what they need of the library; else all of it.
void load_library_for(Run& run, const LibraryOptions& options,
                      const std::vector<Spanned<std::string>>& more,
                      std::optional<Mentions> mentions) {
  run.root = data_root();
  if (run.root.empty()) {
    run.diagnostics.io_error("E0301", {}, "cannot find the folder with models and templates").help =
        "install eagerx-gen with `cmake --install`, or set EAGERX_HOME to that folder";
    return;
  }
  std::vector<Spanned<std::string>> folders;
  for (const auto& path : options.paths) folders.push_back({path, {}});
  folders.insert(folders.end(), more.begin(), more.end());
  std::vector<Spanned<std::string>> installed;
  for (const char* part : {"models", "targets"})
    installed.push_back({(fs::path(run.root) / part).string(), {}});
  if (mentions) {
    run.library =
        load_mentioned(std::move(*mentions), folders, installed, run.sources, run.diagnostics);
    return;
  }
  folders.insert(folders.end(), installed.begin(), installed.end());
  run.library = load_library(folders, run.sources, run.diagnostics);
  const fs::path root = absolute_path(fs::path(run.root) / "models").lexically_normal();
  for (auto& [id, entity] : run.library.entities)
    entity.own = entity.include_root != root.parent_path().string();
}

/// What the graph and the command line mention.
Mentions mentions_of(const YamlValue& graph, const GraphOptions& options) {
  Mentions mentions;
  mentions.add(graph);
  mentions.add(options.engine);
  for (const std::string& target : wanted_targets(options)) mentions.add(target);
  for (const std::string& item : options.split)
    mentions.add(item.substr(item.find_last_of("=:") + 1));
  for (const std::string& id : entities_of_patterns(graph)) mentions.add(id);
  for (const std::string& id : entities_of_noise(graph)) mentions.add(id);
  return mentions;
}

/// How much of the library is read.
enum class Reading : std::uint8_t { mentioned, whole };

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

/// The spec of a graph in our own form, with the rates of the command line, and its library.
bool read_own_graph(Run& run, const GraphOptions& options, Reading reading) {
  const std::size_t errors_before = run.diagnostics.error_count();
  load_library_for(
      run, options, library_folders(run.tree, options.graph),
      reading == Reading::whole ? std::nullopt : std::optional(mentions_of(run.tree, options)));
  FlatGraph flat{run.tree, GraphForm::written, {}, {}};
  if (run.diagnostics.error_count() == errors_before)
    flat = compose(run.tree, run.library, run.sources, run.diagnostics);
  const bool composed = run.diagnostics.error_count() == errors_before;
  run.spec = read_graph_spec(flat.root, options.graph, run.diagnostics, flat.form);
  run.flat = std::move(flat.root);
  run.composites = std::move(flat.ends);
  if (run.spec) {
    run.spec->composites = std::move(flat.composites);
    if (options.rate_hz) run.spec->rate.value = *options.rate_hz;
    if (options.engine_rate_hz && run.spec->has_engine())
      run.spec->engine.rate->value.text = options.engine_rate_hz->to_string();
  }
  return run.spec && composed;
}

}  // namespace

void load(Run& run, const LibraryOptions& options) {
  load_library_for(run, options, {}, std::nullopt);
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
  load_library_for(run, options, {}, std::nullopt);
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

/// What `safety:` says of outputs and measurements is said of the library's, which the whole graph
/// has not.
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

/// `--policy FILE` in place of the graph's agent; the graph names files beside itself.
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

/// Files that the graph names and that only the compiler or the program reads.
void remember_named_files(const Run& run) {
  const auto header = [](const fs::path& root, const CppClass& type) {
    if (!type.include.empty()) remember_input((root / type.include).string());
  };
  for (const auto& [id, entity] : run.library.entities) {
    header(entity.include_root, entity.cpp);
    for (const ObjectEngine& engine : entity.object_engines)
      header(engine.include_root, engine.model);
  }
  const AgentSpec& agent = run.spec->agent;
  if (agent.kind == AgentSpec::Kind::csv)
    remember_input((fs::path(run.spec->path).parent_path() / agent.file.value).string());
}

/// From the tree of the graph's file on.
bool make_of_tree(Run& run, const GraphOptions& options, Reading reading) {
  if (is_saved_graph(run.tree)) {
    auto imported = import_file(run, run.tree, options);
    if (!imported) return false;
    run.spec = std::move(imported->spec);
  } else if (!read_own_graph(run, options, reading)) {
    return false;
  }
  take_policy(run, options);
  remember_named_files(run);
  if (!options.of.empty() || options.purpose == Purpose::recording) prepare_for_cut(run);
  if (options.purpose == Purpose::training) prepare_for_training(run);
  if (options.purpose == Purpose::campaign) prepare_for_campaign(run);
  if (options.purpose == Purpose::simulation || wants_whole_graph(run, options))
    run.spec->placement.clear();
  const std::size_t errors = run.diagnostics.error_count();
  run.tables = read_tables(*run.spec, run.sources, run.diagnostics);
  if (run.diagnostics.error_count() > errors) return false;  // lists that are not there
  // Before the graph is resolved, so that a bad file is told of along with everything else.
  run.policies = read_policies(*run.spec, run.library, run.diagnostics);
  run.graph = resolve(*run.spec, run.library, {options.engine, options.real, placement_of(options)},
                      run.diagnostics);
  if (!run.graph) return false;
  run.plan = make_plan(*run.graph, run.diagnostics);
  check_policies(*run.spec, *run.graph, run.policies, run.diagnostics);
  return !run.diagnostics.has_errors();
}

}  // namespace

std::vector<std::string> wanted_targets(const GraphOptions& options) {
  return options.targets.empty() ? std::vector<std::string>{"linux-sim"} : options.targets;
}

namespace {

bool make_of_tree(Run& run, const GraphOptions& options) {
  if (run.diagnostics.has_errors()) return false;
  const bool made = make_of_tree(run, options, Reading::mentioned);
  return run.library.was_too_small() ? make_again(run, options) : made;
}

}  // namespace

namespace {

/// Leaves what was read of the graph's file.
void start_again(Run& run) {
  Run whole;
  whole.sources = std::move(run.sources);
  whole.written = std::move(run.written);
  whole.tree = std::move(run.tree);
  run = std::move(whole);
}

void choose_variant(Run& run, const GraphOptions& options) {
  run.tree =
      choose_variant(run.written, options.graph, options.variant, run.sources, run.diagnostics);
}

}  // namespace

bool make(Run& run, const GraphOptions& options) {
  run.written = read_graph_file(run, options.graph);
  choose_variant(run, options);
  return make_of_tree(run, options);
}

bool make_spec(Run& run, const GraphOptions& options) {
  choose_variant(run, options);
  if (run.diagnostics.has_errors()) return false;
  const bool made = read_own_graph(run, options, Reading::mentioned);
  if (!run.library.was_too_small()) return made;
  start_again(run);
  return read_own_graph(run, options, Reading::whole);
}

bool make_of_text(Run& run, const GraphOptions& options, const std::string& text) {
  run.written = read_yaml_text(options.graph, text, run.sources, run.diagnostics);
  choose_variant(run, options);
  return make_of_tree(run, options);
}

bool make_again(Run& run, const GraphOptions& options) {
  start_again(run);
  return make_of_tree(run, options, Reading::whole);
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
