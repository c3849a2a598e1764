// eagerx-gen: its commands.
#include <algorithm>

#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/topics.hpp"
#include "generator/support/command_line/bugs.hpp"
#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {
namespace {

std::vector<CommandLinePage> pages();

CommandLine command_line() {
  return {
      .top = {.name = "eagerx-gen",
              .about = "Checks an EAGERx graph and writes a C++ program for it.",
              .commands = {generate_command(), build_command(),     run_command(),
                           train_command(),    campaign_command(),  pil_command(),
                           check_command(),    info_command(),      diff_command(),
                           graph_command(),    report_command(),    explain_command(),
                           import_command(),   schema_command(),    new_command(),
                           size_command(),     replay_command(),    identify_command(),
                           trace_command(),    plot_command(),      monitor_command(),
                           policy_command(),   key_command(),       docs_command(),
                           fix_command(),      rename_command(),    lsp_command(),
                           serve_command(),    pages_command(pages)}},
      .footer =
          "`eagerx-gen GRAPH.yaml` is short for `eagerx-gen generate GRAPH.yaml`. A graph may "
          "also be a file that EAGERx's Graph.save or BaseEnv.save wrote.\n"
          "Exit codes: 0 done, 1 problems found, 2 wrong usage, 3 cannot read or write, 4 a bug "
          "in eagerx-gen.",
      .version = "eagerx-gen " EAGERX_GEN_VERSION,
      .default_command = "generate",
      .topics = help_topics()};
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
