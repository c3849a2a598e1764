// eagerx-gen campaign: many runs are the work of eagerx-campaign (targets/environments/campaign).
#include "targets/environments/options/campaign.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "generator/cli/arguments.hpp"
#include "generator/cli/become.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/environments.hpp"
#include "generator/cli/paths.hpp"

namespace eagerx::gen {
namespace {

/// As a shell reads it back.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+:,=@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// What runs one episode of the same graph in its program for Linux.
std::string command_of_one_run(const GenerateOptions& options) {
  std::string text = "eagerx-gen run " + quoted(options.graph);
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += std::string(" ") + name + " " + quoted(value);
  };
  add("--policy", options.agent_policy);
  add("--variant", options.variant);
  add("--engine", options.engine);
  add("--rate", options.rate_hz ? options.rate_hz->to_string() : "");
  add("--engine-rate", options.engine_rate_hz ? options.engine_rate_hz->to_string() : "");
  for (const std::string& path : options.paths) add("--path", path);
  return text;
}

constexpr const char* kAlone = "eagerx-campaign";

/// What mpirun tells its processes; 0 of 1 for one that it has not started.
struct Rank {
  long number = 0, size = 1;
};
Rank rank_of_this() {
  using Names = std::array<const char*, 2>;
  constexpr std::array kNames = {Names{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},  // Open MPI
                                 Names{"PMI_RANK", "PMI_SIZE"}};                         // MPICH
  for (const Names& names : kNames) {
    const char* const number = std::getenv(names[0]);
    const char* const size = std::getenv(names[1]);
    if (number != nullptr && size != nullptr)
      return {std::strtol(number, nullptr, 10), std::strtol(size, nullptr, 10)};
  }
  return {};
}

/// Rank 0 builds the library, and the others get it from there.
int become_rank(const Rank& rank, const GenerateOptions& options, std::vector<std::string> words) {
  constexpr const char* kProgram = "eagerx-campaign-mpi";
  const std::string program = helper_program(kProgram);
  std::error_code error;
  if (!std::filesystem::exists(program, error)) {
    if (rank.number == 0)
      complain(
          "error: this eagerx-gen was built without MPI\n"
          "help: `toolchains/install-packages mpi`, and build it with `cmake -DEAGERX_MPI=ON`\n");
    return kInputOutput;
  }
  if (rank.number == 0)
    return become_with_environments({kProgram, kAlone}, options, std::move(words));
  words.insert(words.begin(), "the library of rank 0");
  return become(program, words);
}

struct CampaignOptions : EnvironmentsOptions {};

int perform(const CampaignOptions& options) {
  GenerateOptions campaign = options;
  campaign.purpose = Purpose::campaign;
  std::vector<std::string> words = options.of_program;
  words.insert(words.end(), {"--replay", command_of_one_run(options)});
  if (const Rank rank = rank_of_this(); rank.size > 1)
    return become_rank(rank, campaign, std::move(words));
  return become_with_environments({kAlone, kAlone}, campaign, std::move(words));
}

Command table(CampaignOptions& options) {
  return {
      .name = "campaign",
      .about = "run many episodes with the agent in the loop and count successes",
      .examples =
          {{"10,000 episodes: how often it succeeds, and what repeats the worst ones",
            "eagerx-gen campaign pendulum.yaml --runs 10000"},
           {"with masses drawn from a range; a row for each run",
            "eagerx-gen campaign pendulum.yaml --vary pendulum.mass=0.1:0.2 --csv runs.csv"},
           {"with a sensor that falls silent for 10 steps",
            "eagerx-gen campaign pendulum.yaml --faults angle=silent+10"},
           {"a long one that can be interrupted",
            "eagerx-gen campaign robot.yaml --runs 1000000 --checkpoint robot.campaign"},
           {"and goes on", "eagerx-gen campaign robot.yaml --runs 1000000 --resume robot.campaign"},
           {"on four processes, for an eagerx-gen with MPI",
            "mpirun -n 4 eagerx-gen campaign robot.yaml --runs 1000000"}},
      .arguments = joined({{graph(options), agent_policy(options)},
                           handed_on(eagerx::options::kCampaign, options),
                           on_environments(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command campaign_command() {
  return with_options<CampaignOptions>(table);
}

}  // namespace eagerx::gen
