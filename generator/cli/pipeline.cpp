#include "generator/cli/pipeline.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "generator/cli/paths.hpp"
#include "generator/emit/policy_contract.hpp"
#include "generator/policy/evaluate.hpp"
#include "generator/policy/int8.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

void load_library_for(Run& run, const Options& options,
                      const std::vector<Spanned<std::string>>& more) {
  run.root = data_root();
  if (run.root.empty()) {
    run.diagnostics.io_error("E0301", {}, "cannot find the folder with models and templates").help =
        "install eagerx-gen with `cmake --install`, or set EAGERX_HOME to that folder";
    return;
  }
  std::vector<Spanned<std::string>> folders;
  for (const auto& path : options.paths) folders.push_back({path, {}});
  folders.insert(folders.end(), more.begin(), more.end());
  folders.push_back({(fs::path(run.root) / "models").string(), {}});
  folders.push_back({(fs::path(run.root) / "targets").string(), {}});
  run.library = load_library(folders, run.sources, run.diagnostics);
}

/// Rounds the weights if the graph wants them in eight bits, and says what that costs. E0640.
void round_weights(Run& run, const GoldenRows* rows) {
  const AgentSpec& agent = run.spec->agent;
  const bool int8 = agent.weights && agent.weights->value == "int8";
  if (agent.max_error && !int8) {
    run.diagnostics.error("E0206", agent.max_error->span, "`max_error` goes with `weights: int8`");
  }
  if (!int8) return;
  Network rounded = with_int8_weights(*run.network);
  const RoundingError error = rounding_error(*run.network, rounded, rows);
  run.network = std::move(rounded);
  if (agent.max_error && !(error.largest <= agent.max_error->value)) {
    run.diagnostics
        .error("E0640", agent.max_error->span,
               fmt::format("with weights of eight bits the policy `{}` is farther off than {:g}",
                           run.network->file, agent.max_error->value))
        .help = fmt::format("its error against float32: {}", to_string(error));
    return;
  }
  run.diagnostics.note(agent.weights->span, fmt::format("weights of eight bits, error against "
                                                        "float32: {}",
                                                        to_string(error)));
}

/// Checks the policy against the rows that the graph names, and gives the program some to check.
void add_known_answers(Run& run, const fs::path& folder) {
  const auto& golden = run.spec->agent.golden;
  if (!golden) {
    run.network->self_test = self_test_rows(*run.network, nullptr);
    return round_weights(run, nullptr);
  }
  const std::string path = (folder / golden->value).string();
  const auto rows = read_golden(path, golden->value, golden->span, run.diagnostics);
  if (rows && compare(*run.network, *rows, golden->value, golden->span, run.diagnostics)) {
    run.network->self_test = self_test_rows(*run.network, &*rows);
    round_weights(run, &*rows);
  }
}

/// Before the graph is resolved, so that a bad file is told of along with everything else.
void read_network(Run& run) {
  const AgentSpec& agent = run.spec->agent;
  if (agent.kind != AgentSpec::Kind::policy) return;
  const fs::path folder = fs::path(run.spec->path).parent_path();
  PolicyRequest request;
  request.path = (folder / agent.file.value).string();
  request.name = agent.file.value;
  request.span = agent.file.span;
  if (agent.normalize) {
    request.normalize_path = (folder / agent.normalize->value).string();
    request.normalize_name = agent.normalize->value;
    request.normalize_span = agent.normalize->span;
  }
  if (agent.activation) request.activation = activation_of(agent.activation->value);
  run.network = read_policy(request, run.diagnostics);
  if (!run.network) return;
  if (agent.profile && agent.profile->value == "fast") run.network->profile = Profile::fast;
  add_known_answers(run, folder);
}

/// The spec of a graph in our own form, with the rates of the command line, and its library.
bool read_own_graph(Run& run, const Node& tree, const Options& options) {
  run.spec = read_graph_spec(tree, options.graph, run.diagnostics);
  std::vector<Spanned<std::string>> folders;
  if (run.spec) {
    for (const auto& folder : run.spec->library)
      folders.push_back(
          {(fs::path(options.graph).parent_path() / folder.value).string(), folder.span});
    if (options.rate_hz) run.spec->rate.value = *options.rate_hz;
    if (options.engine_rate_hz)
      run.spec->engine.rate->value.text = options.engine_rate_hz->to_string();
  }
  const std::size_t errors_before = run.diagnostics.error_count();
  load_library_for(run, options, folders);
  return run.spec && run.diagnostics.error_count() == errors_before;
}

}  // namespace

void load(Run& run, const Options& options) {
  load_library_for(run, options, {});
}

Node read_graph_file(Run& run, const std::string& path) {
  Diagnostics strict;
  Node tree = read_yaml_file(path, run.sources, strict);
  if (strict.has_errors() && !strict.has_io_errors()) {
    // A file of EAGERx may have Python's tags; in a graph they are mistakes.
    const std::string& text = run.sources.text(strict.all().front().span.file);
    if (text.find("\ngui_state:") != std::string::npos)
      return read_yaml_text(path, text, run.sources, run.diagnostics, Tags::accept);
  }
  run.diagnostics = std::move(strict);
  return tree;
}

std::optional<ImportedGraph> import_file(Run& run, const Node& tree, const Options& options) {
  load_library_for(run, options, {});
  if (run.diagnostics.has_errors()) return std::nullopt;
  return import_graph(tree, options.graph, run.library,
                      {options.engine, options.engine_rate_hz, options.rate_hz}, run.diagnostics);
}

namespace {

/// `--split a,b=BOARD`, which has no place in a file.
std::vector<PlacementSpec> placement_of(const Options& options) {
  std::vector<PlacementSpec> result;
  for (const auto& item : options.split) {
    const std::size_t equals = item.rfind('=');
    const std::string names = item.substr(0, equals);
    for (std::size_t begin = 0; begin <= names.size();) {
      const std::size_t end = std::min(names.find(',', begin), names.size());
      result.push_back({{names.substr(begin, end - begin), {}}, {item.substr(equals + 1), {}}});
      begin = end + 1;
    }
  }
  return result;
}

}  // namespace

bool make(Run& run, const Options& options) {
  const Node tree = read_graph_file(run, options.graph);
  if (run.diagnostics.has_errors()) return false;
  if (is_saved_graph(tree)) {
    auto imported = import_file(run, tree, options);
    if (!imported) return false;
    run.spec = std::move(imported->spec);
  } else if (!read_own_graph(run, tree, options)) {
    return false;
  }
  read_network(run);
  run.graph = resolve(*run.spec, run.library, {options.engine, options.real, placement_of(options)},
                      run.diagnostics);
  if (!run.graph) return false;
  run.plan = make_plan(*run.graph, run.diagnostics);
  if (run.network) check_policy(*run.graph, *run.network, run.diagnostics);
  return !run.diagnostics.has_errors();
}

int finish(Run& run, const Options& options) {
  run.diagnostics.sort_by_place();
  if (options.quiet) run.diagnostics.drop_notes();
  if (options.json) {
    std::fputs(render_json(run.diagnostics, run.sources).c_str(), stderr);
  } else if (!run.diagnostics.all().empty()) {
    std::fputs(render_text(run.diagnostics, run.sources, isatty(STDERR_FILENO) == 1).c_str(),
               stderr);
  }
  if (run.diagnostics.has_io_errors()) return kInputOutput;
  return run.diagnostics.has_errors() ? kProblems : kDone;
}

}  // namespace eagerx::gen
