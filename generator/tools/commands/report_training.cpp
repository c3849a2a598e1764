#include "generator/tools/commands/report_training.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/number.hpp>
#include <utility>

#include "generator/backend/compile/compile.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/commands/one_run.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/process.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 500'000'000;  // of the table of an episode

/// The hash of a file, as a record has it; empty if it cannot be read.
std::string hash_of_file(const std::string& path) {
  const LoadedFile file = load_file(path, kMostBytes);
  return file.status == LoadedFile::Status::loaded ? host::hex_text(host::fnv1a(file.bytes)) : "";
}

/// The sum of the column `task.reward`, as a training makes it: of float32, in double.
std::optional<double> return_of(const std::string& table) {
  std::optional<std::size_t> column;
  double sum = 0.0;
  for (std::size_t at = 0; at < table.size();) {
    const std::size_t end = std::min(table.find('\n', at), table.size());
    std::size_t place = 0;
    for (std::size_t from = at; from <= end; ++place) {
      const std::size_t to = std::min(table.find(',', from), end);
      const std::string_view cell = std::string_view(table).substr(from, to - from);
      double value = 0.0;
      if (at == 0 && cell == "task.reward") column = place;
      if (at > 0 && column == place && host::read_number(cell, value))
        sum += static_cast<double>(static_cast<float>(value));
      from = to + 1;
    }
    at = end + 1;
  }
  return column ? std::optional(sum) : std::nullopt;
}

std::vector<std::string> options_of(const TrainingEpisode& episode) {
  return {"--seed",        std::to_string(episode.seed),
          "--environment", std::to_string(episode.environment),
          "--steps",       std::to_string(episode.steps)};
}

Json episode_json(const char* what, const TrainingEpisode& episode) {
  return Json{{"what", what},
              {"seed", std::to_string(episode.seed)},  // not exact as a number of JSON
              {"environment", episode.environment},
              {"return", episode.sum},
              {"steps", episode.steps},
              {"success", episode.success},
              {"command", fmt::format("{}", join(options_of(episode), " "))}};
}

/// The title of a trace on the page, whose bytes do not depend on the machine.
std::string title_of(const char* what, const TrainingEpisode& episode) {
  return fmt::format("{} episode, return {:.5g}", what, episode.sum);
}

/// Runs an episode; its trace is in `log`. Why it is not the one of the training, or nothing.
std::string run_again(const std::string& program, const TrainingEpisode& episode, bool has_scene,
                      const std::string& folder, const std::string& log) {
  const std::string table = folder + "/episode.csv";
  std::vector<std::string> command = {program, "--quiet", "--trace", log, "--csv", table};
  if (has_scene) command.emplace_back("--trace-scenes");
  const auto words = options_of(episode);
  command.insert(command.end(), words.begin(), words.end());
  const auto result = run_process(command);
  if (!result) return fmt::format("`{}` cannot be started", program);
  if (result->exit_code != 0) return fmt::format("the program fails: {}", result->output);
  const LoadedFile file = load_file(table, kMostBytes);
  const auto sum = return_of(file.bytes);
  if (!sum) return "the graph has no `task:` now";
  if (*sum == episode.sum) return {};
  return fmt::format(
      "run again, an episode has the return {} and had {} in the training: the graph, or what it "
      "is made of, has changed since then, or was trained with other options",
      *sum, episode.sum);
}

}  // namespace

std::optional<ReportedTraining> ReportedTraining::read(const std::string& path, SourceMap& sources,
                                                       Diagnostics& diagnostics) {
  auto record = read_training(path, sources, diagnostics);
  if (!record) return std::nullopt;
  return ReportedTraining(std::move(*record));
}

void ReportedTraining::choose_policy(GraphOptions& options) {
  const std::string file = options.agent_policy.empty() ? record_.policy : options.agent_policy;
  if (!record_.policy.empty()) {
    const std::string hash = hash_of_file(file);
    has_policy_ = !hash.empty() && hash == record_.policy_hash;
    if (has_policy_) options.agent_policy = file;
    if (hash.empty()) why_not_ = fmt::format("`{}`, its policy, cannot be read", file);
    if (!hash.empty() && !has_policy_)
      why_not_ = fmt::format("`{}` is not the policy that this training wrote", file);
  }
  if (!options.agent_policy.empty()) return;
  Run trial;  // the graph may name the policy that is not there yet
  if (!make(trial, options)) options.purpose = Purpose::training;
}

bool ReportedTraining::check(const Graph& graph, Diagnostics& diagnostics) const {
  if (record_.graph.empty() || record_.graph == graph.name) return true;
  diagnostics
      .error("E0361", {},
             fmt::format("`{}` is a training of another graph: it is of `{}`, this graph is `{}`",
                         text_of(member(&record_.page, "name")), record_.graph, graph.name))
      .help = "give what a training of this graph has written";
  return false;
}

std::optional<Json> ReportedTraining::run_episodes(const Run& run, const GenerateOptions& options,
                                                   std::size_t points, int& code) {
  Json none = Json::list();
  if (!has_policy_ || record_.episodes.empty()) return none;
  const Graph& graph = *run.graph;
  if (graph.has_engine() && graph.engine().entity->asynchronous) {
    why_not_ = "the engine moves hardware: start the program yourself";
    return none;
  }
  GenerateOptions program = options;
  program.targets.clear();
  program.output.clear();
  program.purpose = Purpose::simulation;
  Run building;
  const auto built = build_graph(building, program, code);
  building.diagnostics = built ? Diagnostics() : std::move(building.diagnostics);
  code = std::max(finish(building, options), code);
  if (!built || code != kDone) return std::nullopt;

  const TemporaryFolder folder;
  const BestAndWorst shown = best_and_worst(record_.episodes);
  const bool has_scene =
      graph.render && graph.nodes[graph.render->node].inputs.front().space.dtype == Dtype::float32;
  std::vector<std::string> logs, titles;
  for (const auto& [what, episode] : {std::pair("best", shown.best), {"worst", shown.worst}}) {
    logs.push_back(folder.path() + "/" + what + ".log");
    titles.push_back(title_of(what, episode));
    why_not_ = run_again(absolute_path(built->back().image).string(), episode, has_scene,
                         folder.path(), logs.back());
    if (!why_not_.empty()) return none;
  }
  Diagnostics problems;
  const Json read = read_logs(logs, *run.plan, points, problems);
  if (problems.has_errors()) {
    why_not_ = problems.all().front().message;
    return none;
  }
  Json named = Json::list();
  for (std::size_t i = 0; i < logs.size(); ++i) {
    Json log = (*read.as<Json::List>())[i];
    log["name"] = titles[i];
    log["title"] = titles[i];
    named.push_back(std::move(log));
  }
  return named;
}

void ReportedTraining::leave_episodes_out(const std::string& why) {
  if (!record_.episodes.empty()) why_not_ = why;
}

Json ReportedTraining::page(const Graph& graph, const GraphOptions& options) const {
  Json page = record_.page;
  page["shown"] = Json::list();
  if (!record_.episodes.empty()) {
    const BestAndWorst shown = best_and_worst(record_.episodes);
    page["shown"].push_back(episode_json("best", shown.best));
    page["shown"].push_back(episode_json("worst", shown.worst));
  }
  page["why_not"] = why_not_;
  GraphOptions typed = options;
  if (typed.agent_policy.empty()) typed.agent_policy = record_.policy;
  page["run"] = command_on_graph(typed);
  page["next"] = Json::list();
  if (record_.policy.empty()) return page;
  const auto add = [&](const char* about, const char* command, const char* more) {
    page["next"].push_back(
        Json{{"about", about}, {"command", command_on_graph(typed, command) + more}});
  };
  if (graph.render) add("see it", "run", " --render window");
  add("how often it succeeds, and the worst runs", "campaign", " --runs 10000");
  add("the same program on an emulated board", "run", " --target mps2-an386 --steps 300 --hash");
  add("an image for a board", "build", " --target stm32f405");
  return page;
}

}  // namespace eagerx::gen
