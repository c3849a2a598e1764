#include "generator/cli/environments.hpp"

#include <algorithm>
#include <filesystem>

#include "generator/cli/become.hpp"
#include "generator/cli/built.hpp"
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

int become_with_environments(const Helper& helper, const Options& options,
                             std::vector<std::string> words) {
  const std::string program = helper_program(helper.program);
  std::error_code ignored;
  if (!std::filesystem::exists(program, ignored)) {
    complain(
        "error: there is no `{}`\nhelp: install the package of eagerx-gen again, or build all of "
        "it\n",
        program);
    return kInputOutput;
  }
  if (options.quiet) words.emplace_back("--quiet");
  const auto checked = run_process(joined({helper_program(helper.checker), "--check"}, words));
  if (checked && checked->exit_code != 0) {
    complain_text(checked->output);
    return checked->exit_code;
  }
  Options library = options;
  library.targets = {"environments"};
  Run run;
  int code = kDone;
  const auto built = build_graph(run, library, code);
  code = std::max(finish(run, options), code);
  if (!built) return code;
  return become(program, joined({built->back().image}, words));
}

}  // namespace eagerx::gen
