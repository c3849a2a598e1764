// eagerx-campaign LIBRARY: many episodes of a graph with its agent in the loop.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "targets/environments/campaign/campaign.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

volatile int interrupted = 0;

extern "C" void interrupt(int /*signal*/) {
  interrupted = 1;
  std::signal(SIGINT, SIG_DFL);  // the second one ends the program
}

int run(int argc, char** argv) {
  try {
    const Options options = parse_options(argc, argv);
    if (options.wants_help) {
      fmt::print("{}", help_text());
      return client::kDone;
    }
    check_files(options);
    if (options.only_checks) return client::kDone;
    const client::Library library(options.library);
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    return run_campaign(options, library, interrupted);
  } catch (const client::Problem& problem) {
    fmt::print(stderr, "error: {}\n", problem.what());
    if (!problem.help.empty()) fmt::print(stderr, "help: {}\n", problem.help);
    return problem.code;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return client::kProblems;
  }
}

}  // namespace
}  // namespace eagerx::campaign

int main(int argc, char** argv) {
  return eagerx::campaign::run(argc, argv);
}
