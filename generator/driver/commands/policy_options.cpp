#include "generator/driver/commands/policy_options.hpp"

#include <utility>

#include "generator/driver/commands/commands.hpp"

namespace eagerx::gen {
const std::vector<Saying>& sayings() {
  static const std::vector<Saying> kSayings = {
      {"--normalize", "statistics of the observations: a file of VecNormalize.save, npz or JSON",
       "FILE", &PolicyFile::normalize, FileUse::reads},
      {"--activation", "activation of the hidden layers, if the file does not contain it", "NAME",
       &PolicyFile::activation},
      {"--output-activation",
       "activation after the last layer (none, tanh, …), if the file does not contain it", "NAME",
       &PolicyFile::output_activation},
      {"--layers",
       "layers of the actor in order, if the file does not contain it: fc1,fc2,mu, or "
       "fc1,relu,fc2,relu,mu,tanh",
       "NAMES", &PolicyFile::layers},
      {"--input-sizes", "for TorchScript with several inputs: the size of each, such as 3,27",
       "SIZES", &PolicyFile::input_sizes},
      {"--actor", "for a file with several actors: the prefix of the tensors of one", "NAME",
       &PolicyFile::actor},
      {"--output", "output of an ONNX file that is the action", "NAME", &PolicyFile::output_name},
  };
  return kSayings;
}

Arguments one_policy(PolicyOptions& options) {
  Arguments all = {required(reads(text("file", options.policy.file, "policy file", "FILE")))};
  for (const Saying& saying : sayings()) {
    all.push_back(text(saying.names, options.policy.*saying.member, saying.about, saying.type));
    all.back().use = saying.use;
  }
  all.push_back(flag("--state-dependent-std", options.policy.state_dependent_std, kDeviations));
  return gen::joined({std::move(all), diagnostics(options)});
}

Arguments asked(AskedOptions& options) {
  constexpr std::uint64_t kMostRows = 1'000'000;
  constexpr std::uint64_t kMostSeed = 0xFFFFFFFF;
  return {
      whole("--rows", options.rows, "number of random observations (default: 1000)", 1, kMostRows),
      whole("--seed", options.seed, "seed of random numbers (default: 1)", 0, kMostSeed),
      reads(text("--observations", options.observations,
                 "file with observations to use instead of random ones: columns obs0, obs1 …, and "
                 "for a recurrent policy episode_start",
                 "FILE.csv|npz"))};
}

std::string check_asked(const AskedOptions& options) {
  if (options.observations.empty() || (!options.rows && !options.seed)) return {};
  return "--rows and --seed are for sampled observations, not for --observations";
}

Command policy_command() {
  return {.name = "policy",
          .about = "inspect, test and compare trained policies",
          .examples = {{"layers, size, inputs and outputs of a policy",
                        "eagerx-gen policy info swing_up.onnx"},
                       {"error of a policy on known answers",
                        "eagerx-gen policy test swing_up.onnx answers.csv"}},
          .commands = {policy_info_command(), policy_test_command(), policy_golden_command(),
                       policy_compare_command()}};
}

}  // namespace eagerx::gen
