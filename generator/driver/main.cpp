// eagerx-gen: the commands that make and run programs. All others are in eagerx-gen-tools, in the
// same folder, so that the main program builds in half the time.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "generator/driver/build/exec.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/program.hpp"
#include "generator/support/command_line/bugs.hpp"
#include "generator/support/command_line/output.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Those of generator/tools/commands, which without eagerx-gen-tools are said to be missing.
constexpr std::array<std::string_view, 15> kToolsCommands = {
    "pil",  "linearize", "design", "trim",   "graph", "report", "replay", "trace",
    "plot", "monitor",   "fix",    "rename", "lsp",   "serve",  "pages"};

CommandLine command_line() {
  return program_command_line({generate_command(), build_command(), run_command(), train_command(),
                               campaign_command(), check_command(), info_command(), diff_command(),
                               explain_command(), import_command(), schema_command(), new_command(),
                               size_command(), identify_command(), policy_command(), key_command(),
                               docs_command()});
}

/// The first word that is no option; empty if there is none.
std::string_view first_word(const std::vector<std::string>& arguments) {
  const auto found =
      ranges::find_if(arguments, [](const std::string& word) { return !word.starts_with('-'); });
  return found == arguments.end() ? std::string_view() : *found;
}

/// Whether this program surely does what the other one would: the word is one of its commands, or a
/// file.
bool does(const CommandLine& line, std::string_view word) {
  return ranges::contains(line.top.commands, word, &Command::name) ||
         word.find_first_of("./") != std::string_view::npos;
}

int run(const std::vector<std::string>& arguments) {
  const CommandLine line = command_line();
  const std::string_view word = first_word(arguments);
  if (does(line, word)) return run_command_line(line, arguments);
  std::error_code error;
  const fs::path tools = fs::read_symlink("/proc/self/exe", error).parent_path() / kToolsProgram;
  if (fs::exists(tools, error)) return exec(tools.string(), arguments);
  if (!ranges::contains(kToolsCommands, word)) return run_command_line(line, arguments);
  complain(
      "error: `{}` needs {}, which is not in this program's folder\nhelp: build it, too: cmake "
      "--build BUILD --target {}\n",
      word, kToolsProgram, kToolsProgram);
  return kInputOutput;
}

}  // namespace
}  // namespace eagerx::gen

int main(int argc, char** argv) {
  return eagerx::gen::reporting_bugs("eagerx-gen", [&] {
    return eagerx::gen::run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  });
}
