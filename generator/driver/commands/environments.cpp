#include "generator/driver/commands/environments.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <runtime/host/base/handover.hpp>
#include <utility>

#include "generator/driver/build/built.hpp"
#include "generator/driver/build/described.hpp"
#include "generator/driver/build/exec.hpp"
#include "generator/driver/build/folder.hpp"
#include "generator/driver/pipeline/paths.hpp"

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

/// The exit code of the program's own check of its arguments; not kDone if it has reported a
/// problem.
int check_words(const Helper& helper, const std::vector<std::string>& words) {
  const auto checked = run_process(with({helper_program(helper.checker), "--check"}, words));
  if (!checked || checked->exit_code == 0) return kDone;
  const int explained = helper.explain ? helper.explain(*checked) : int{kDone};
  if (explained != kDone) return explained;
  complain_text(without_settings(checked->output));
  return checked->exit_code;
}

/// Nothing where the graph is too large for a command line: then the library says it.
std::vector<std::string> words_about(const Graph& graph) {
  constexpr std::size_t kMostBytes = 100'000;  // Linux takes 131,072 in a word
  std::string text = description_of(graph);
  if (text.empty() || text.size() > kMostBytes) return {};
  return {"--describes", std::move(text)};
}

}  // namespace

Arguments handed_on(std::span<const eagerx::options::Row> rows, EnvironmentsOptions& options) {
  Arguments all;
  for (const eagerx::options::Row& row : rows) {
    if (row.who != eagerx::options::For::all) continue;
    Argument argument = handed_on(row.names, row.about, row.value, options.of_program);
    if (row.use == eagerx::options::Use::writes) argument = writes(argument, row.otherwise);
    if (row.use == eagerx::options::Use::reads) argument = reads(argument, row.continues);
    if (row.use == eagerx::options::Use::folder) argument = folder(argument);
    argument.repeated = row.repeated;
    all.push_back(std::move(argument));
  }
  return all;
}

Arguments on_environments(GenerateOptions& options) {
  return joined(
      {{folder(text("--build", options.output,
                    "folder for the library of environments (default: generated/<graph "
                    "name>-environments, followed by the name of a variant, engine or policy)",
                    "DIR")),
        variant(options), engine(options)},
       rates(options),
       {library(options), warnings(options)},
       diagnostics(options)});
}

int exec_with_environments(const Helper& helper, const GenerateOptions& options,
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
  if (const int code = check_words(helper, words); code != kDone) return code;
  GenerateOptions library = options;
  library.targets = {"environments"};
  library.for_this_machine = !helper.is_shared && std::getenv("EAGERX_SIMD") == nullptr;
  Run run;
  int code = kDone;
  const bool is_made = make(run, library);
  const auto about =
      is_made && helper.looks_at_graph ? words_about(*run.graph) : std::vector<std::string>();
  if (!about.empty()) {
    const int refused = check_words(helper, with(about, words));
    if (refused != kDone) return std::max(finish(run, options), refused);
  }
  const auto built = is_made ? build_made_graph(run, library, code) : std::nullopt;
  code = std::max(finish(run, options), code);
  if (!built) return code;
  expect_graph(built->back());
  setenv(host::kOutputLocks, KeptFolders::hand_on().c_str(), 1);
  return exec(program, with({built->back().image}, words));
}

}  // namespace eagerx::gen
