#include "generator/cli/environments.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "generator/cli/become.hpp"
#include "generator/cli/built.hpp"
#include "generator/cli/paths.hpp"

namespace eagerx::gen {
namespace {

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The line for SettingPlaces is not for people.
std::string without_settings(const std::string& said) {
  return said.starts_with("settings: ") ? said.substr(said.find('\n') + 1) : said;
}

}  // namespace

Arguments handed_on(std::span<const eagerx::options::Row> rows, EnvironmentsOptions& options) {
  Arguments all;
  for (const eagerx::options::Row& row : rows) {
    if (row.who != eagerx::options::For::all) continue;
    Argument argument = handed_on(row.names, row.about, row.value, options.of_program);
    if (row.use == eagerx::options::Use::writes) argument = writes(argument, row.otherwise);
    if (row.use == eagerx::options::Use::reads) argument = reads(argument, row.goes_on);
    if (row.use == eagerx::options::Use::folder) argument = folder(argument);
    argument.repeated = row.repeated;
    all.push_back(std::move(argument));
  }
  return all;
}

Arguments on_environments(GenerateOptions& options) {
  return joined({{folder(text("--build", options.output,
                              "folder for the library of environments (default: generated/<graph "
                              "name>-environments)",
                              "DIR")),
                  variant(options), engine(options)},
                 rates(options),
                 {library(options), warnings(options)},
                 diagnostics(options)});
}

int become_with_environments(const Helper& helper, const GenerateOptions& options,
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
  const auto checked = run_process(with({helper_program(helper.checker), "--check"}, words));
  if (checked && checked->exit_code != 0) {
    const int explained = helper.explain ? helper.explain(*checked) : int{kDone};
    if (explained != kDone) return explained;
    complain_text(without_settings(checked->output));
    return checked->exit_code;
  }
  GenerateOptions library = options;
  library.targets = {"environments"};
  Run run;
  int code = kDone;
  const auto built = build_graph(run, library, code);
  code = std::max(finish(run, options), code);
  if (!built) return code;
  return become(program, with({built->back().image}, words));
}

}  // namespace eagerx::gen
