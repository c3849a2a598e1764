// eagerx-gen train: the environments are a library that is generated and built here; learning is
// the work of eagerx-train (targets/environments/train), which knows nothing of graphs.
#include <algorithm>

#include "generator/cli/become.hpp"
#include "generator/cli/built.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/paths.hpp"
#include "generator/process/process.hpp"

namespace eagerx::gen {
namespace {

std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

}  // namespace

int train_command(const Options& options) {
  const std::string trainer = helper_program("eagerx-train");
  std::vector<std::string> words = options.program_options;
  if (options.quiet) words.emplace_back("--quiet");
  // Before minutes of compiling.
  const auto checked = run_process(joined({trainer, "--check"}, words));
  if (checked && checked->exit_code != 0) {
    complain_text(checked->output);
    return checked->exit_code;
  }
  Options library = options;
  library.training = true;
  library.targets = {"environments"};
  Run run;
  int code = kDone;
  const auto built = build_graph(run, library, code);
  code = std::max(finish(run, options), code);
  if (!built) return code;
  const std::string file = built->back().image;
  return become(trainer, joined({file}, words));
}

}  // namespace eagerx::gen
