// eagerx-train LIBRARY: trains a policy on the environments of a graph.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
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
      return kDone;
    }
    check_files(options);
    if (options.only_checks) return kDone;
    const Library library(options.library);
    Training training(options, library);
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    return training.run(interrupted);
  } catch (const Problem& problem) {
    fmt::print(stderr, "error: {}\n", problem.what());
    if (!problem.help.empty()) fmt::print(stderr, "help: {}\n", problem.help);
    return problem.code;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return kProblems;
  }
}

}  // namespace
}  // namespace eagerx::train

int main(int argc, char** argv) {
  return eagerx::train::run(argc, argv);
}
