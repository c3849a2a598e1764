// eagerx-gen-tools: all commands. Users call eagerx-gen, which starts this program for the commands
// that it does not have.
#include <algorithm>

#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/program.hpp"
#include "generator/support/command_line/bugs.hpp"
#include "generator/tools/commands/tool_commands.hpp"

namespace eagerx::gen {
namespace {

std::vector<CommandLinePage> pages();

CommandLine command_line() {
  return program_command_line(
      {generate_command(),  build_command(),    run_command(),    train_command(),
       campaign_command(),  pil_command(),      check_command(),  info_command(),
       diff_command(),      graph_command(),    report_command(), explain_command(),
       import_command(),    schema_command(),   new_command(),    size_command(),
       replay_command(),    identify_command(), trace_command(),  plot_command(),
       monitor_command(),   policy_command(),   key_command(),    docs_command(),
       linearize_command(), design_command(),   trim_command(),   fix_command(),
       rename_command(),    lsp_command(),      serve_command(),  pages_command(pages)});
}

std::vector<CommandLinePage> pages() {
  return command_line_pages(command_line());
}

}  // namespace
}  // namespace eagerx::gen

int main(int argc, char** argv) {
  return eagerx::gen::reporting_bugs("eagerx-gen", [&] {
    return eagerx::gen::run_command_line(
        eagerx::gen::command_line(),
        std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  });
}
