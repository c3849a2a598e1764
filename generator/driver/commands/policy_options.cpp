#include "generator/driver/commands/policy_options.hpp"

#include <utility>

#include "generator/driver/commands/commands.hpp"

namespace eagerx::gen {
const std::vector<Saying>& sayings() {
  static const std::vector<Saying> kSayings = {
      {"--normalize", "statistics of the observations: VecNormalize.save, npz or JSON", "FILE",
       &PolicyFile::normalize, FileUse::reads},
      {"--activation", "activation of the hidden layers, if the file does not say it", "NAME",
       &PolicyFile::activation},
      {"--output-activation",
       "what follows the last layer (such as none or tanh), if the file does not say it", "NAME",
       &PolicyFile::output_activation},
      {"--layers",
       "layers of the actor in their order, if names of the file do not tell it: fc1,fc2,mu, or "
       "fc1,relu,fc2,relu,mu,tanh",
       "NAMES", &PolicyFile::layers},
      {"--input-sizes", "of TorchScript with several inputs: how many numbers each has: 3,27",
       "SIZES", &PolicyFile::input_sizes},
      {"--actor", "of a file with several actors: how the names of its tensors begin", "NAME",
       &PolicyFile::actor},
      {"--output", "which output of an ONNX file is the action", "NAME", &PolicyFile::output_name},
  };
  return kSayings;
}

Arguments one_policy(PolicyOptions& options) {
  Arguments all = {required(reads(text("file", options.policy.file, "the weight file", "FILE")))};
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
      whole("--rows", options.rows, "how many observations to draw (default: 1000)", 1, kMostRows),
      whole("--seed", options.seed, "where random numbers start (default: 1)", 0, kMostSeed),
      reads(
          text("--observations", options.observations,
               "take these instead of drawn ones: columns obs0, obs1 …, of a policy with a memory "
               "also episode_start",
               "FILE.csv|npz"))};
}

std::string check_asked(const AskedOptions& options) {
  if (options.observations.empty() || (!options.rows && !options.seed)) return {};
  return "--rows and --seed are for drawn observations, not for --observations";
}

Command policy_command() {
  return {.name = "policy",
          .about = "look into a trained policy",
          .examples = {{"layers, size and what it expects", "eagerx-gen policy info swing_up.onnx"},
                       {"its error on known answers",
                        "eagerx-gen policy test swing_up.onnx answers.csv"}},
          .commands = {policy_info_command(), policy_test_command(), policy_golden_command(),
                       policy_compare_command()}};
}

}  // namespace eagerx::gen
