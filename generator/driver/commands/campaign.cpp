// eagerx-gen campaign: many runs of a graph, by eagerx-campaign (targets/environments/campaign).
#include "targets/environments/options/campaign.hpp"

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/environments.hpp"
#include "generator/driver/commands/one_run.hpp"
#include "generator/driver/commands/ranks.hpp"

namespace eagerx::gen {
namespace {

struct CampaignOptions : EnvironmentsOptions {};

int perform(const CampaignOptions& options) {
  GenerateOptions campaign = options;
  campaign.purpose = Purpose::campaign;
  return exec_in_ranks("eagerx-campaign", campaign, [&](std::vector<std::string>& words) {
    words = options.of_program;
    words.insert(words.end(), {"--replay", command_on_graph(options)});
    return int{kDone};
  });
}

Command table(CampaignOptions& options) {
  return {.name = "campaign",
          .about = "run many episodes of a graph with its agent, and measure how often it succeeds",
          .examples =
              {{"run 10,000 episodes, and print the success rate and commands that repeat the "
                "worst runs",
                "eagerx-gen campaign pendulum.yaml --runs 10000"},
               {"sample the mass from a range, and write a row for each run",
                "eagerx-gen campaign pendulum.yaml --vary pendulum.mass=0.1:0.2 --csv runs.csv"},
               {"interrupt an observation for 10 steps",
                "eagerx-gen campaign pendulum.yaml --faults angle=silent+10"},
               {"write checkpoints during a long training",
                "eagerx-gen campaign robot.yaml --runs 1000000 --checkpoint robot.campaign"},
               {"continue from the checkpoint",
                "eagerx-gen campaign robot.yaml --runs 1000000 --resume robot.campaign"},
               {"use four processes (eagerx-gen built with MPI)",
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
