// eagerx-gen train: the environments are a library that is generated and built here; learning is
// the work of eagerx-train (targets/environments/train), which knows nothing of graphs.
#include "generator/cli/arguments.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/environments.hpp"

namespace eagerx::gen {

int train_command(const Options& options) {
  Options training = options;
  training.purpose = Purpose::training;
  return become_with_environments({"eagerx-train", "eagerx-train"}, training,
                                  options.program_options);
}

Command train_commands(Options& options) {
  const auto option = [&options](const char* name, const char* about, const char* type) {
    return handed_on(name, about, type, options);
  };
  return {
      .name = "train",
      .about = "train a policy on the graph, whose `task:` says what is good",
      .examples =
          {{"until it succeeds: writes policy.safetensors", "eagerx-gen train pendulum.yaml"},
           {"with another seed, and a picture of the learning curve",
            "eagerx-gen train pendulum.yaml --seed 2 --curve curve.svg -o swing_up.safetensors"},
           {"a long one that can be interrupted",
            "eagerx-gen train robot.yaml --steps 50000000 --checkpoint robot.checkpoint"},
           {"and goes on",
            "eagerx-gen train robot.yaml --steps 50000000 --resume robot.checkpoint"},
           {"fine-tune for another graph what was learnt on this one",
            "eagerx-gen train real_robot.yaml --from robot.checkpoint -o real.safetensors"}},
      .arguments = joined(
          {{graph(options),
            writes(option("-o,--output", "the policy (default: policy.safetensors)", "FILE"),
                   "policy.safetensors"),
            option("--algorithm", "ppo (default); there is no other", "NAME"),
            option("--steps", "steps of all environments, at most (default: 5000000)", "N"),
            option("--until-return", "do not end before the mean return of 100 episodes is X", "X"),
            option("--seed",
                   "where random numbers start: another seed gives another policy (default: 1)",
                   "N"),
            option("--threads",
                   "how many threads; the policy is the same for any number (default: one for each "
                   "core)",
                   "N"),
            option("--hidden", "widths of the hidden layers (default: 64,64)", "N,N"),
            option("--discount", "weight of a reward one step later (default: 0.99)", "X"),
            writes(option("--checkpoint",
                          "write here, each minute and at the end, what --resume and --from need",
                          "FILE")),
            reads(option("--resume", "go on from a checkpoint: the policy is that of one long run",
                         "FILE"),
                  "--checkpoint"),
            reads(option("--from",
                         "begin with what a checkpoint has learnt, also on another graph with the "
                         "same observations and actions",
                         "FILE")),
            writes(option("--csv", "write the learning curve as a table", "FILE")),
            writes(option("--curve", "write the learning curve as a picture (SVG)", "FILE"))},
           on_environments(options)}),
      .run = [&options] { return train_command(options); }};
}

}  // namespace eagerx::gen
