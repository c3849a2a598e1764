// eagerx-gen campaign: many runs are the work of eagerx-campaign (targets/environments/campaign).
#include "targets/environments/options/campaign.hpp"

#include <string_view>

#include "generator/cli/arguments.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/environments.hpp"
#include "generator/cli/ranks.hpp"

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

struct CampaignOptions : EnvironmentsOptions {};

int perform(const CampaignOptions& options) {
  GenerateOptions campaign = options;
  campaign.purpose = Purpose::campaign;
  return become_in_ranks("eagerx-campaign", campaign, [&](std::vector<std::string>& words) {
    words = options.of_program;
    words.insert(words.end(), {"--replay", command_of_one_run(options)});
    return int{kDone};
  });
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
