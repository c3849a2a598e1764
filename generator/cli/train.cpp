// eagerx-gen train: the environments are a library that is generated and built here; learning is
// the work of eagerx-train (targets/environments/train), which knows nothing of graphs.
#include "generator/cli/commands.hpp"
#include "generator/cli/environments.hpp"

namespace eagerx::gen {

int train_command(const Options& options) {
  Options training = options;
  training.purpose = Purpose::training;
  return become_with_environments("eagerx-train", training, options.program_options);
}

}  // namespace eagerx::gen
