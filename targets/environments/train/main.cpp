// eagerx-train LIBRARY: trains a policy on the environments of a graph.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <string_view>
#include <thread>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/ranks/start.hpp"
#include "targets/environments/train/seeds.hpp"
#include "targets/environments/train/start.hpp"
#include "targets/environments/train/sweep.hpp"

namespace eagerx::train {
namespace {

const Interrupt& interrupts() {
  return host::watch_interrupts({SIGINT, SIGTERM}, host::Second::ends);
}

void check_all_files(const Options& options) {
  try {
    options.cases.empty() ? check_files(options) : check_files_of_sweep(options);
  } catch (const Problem& problem) {
    throw options.cases.empty() ? in_words_of(problem, options) : problem;
  }
}

/// Rank 0 alone looks at options and files, and prints.
int run_first(int argc, char** argv, Ranks& ranks) {
  const Options options = parse_options(argc, argv);
  if (!options.wants_help) check_all_files(options);
  if (options.wants_help || options.only_checks) {
    if (options.wants_help) print(help_text());
    give_nothing(ranks);
    return kDone;
  }
  give(ranks, argc, argv, options);
  if (!options.cases.empty()) return train_sweep(options, Library(options.library), interrupts());
  if (options.seeds > 1) return train_seeds(options, Library(options.library), interrupts());
  return train_together(ranks, options, interrupts());
}

/// Rank 0 reports for all, and then it ends all. If it does not, this one's problem is not its own.
int run_other(Ranks& ranks) {
  constexpr std::chrono::seconds kPatience(30);
  const Options options = take_job(ranks);
  if (options.library.empty()) return kDone;
  try {
    train_together(ranks, options, interrupts());
  } catch (const Problem&) {
    std::this_thread::sleep_for(kPatience);
    throw;
  }
  return kDone;
}

int run(int argc, char** argv) {
  std::unique_ptr<Ranks> ranks;
  try {
    ranks = environments::make_ranks(argc, argv);
    return ranks->is_first() ? run_first(argc, argv, *ranks) : run_other(*ranks);
  } catch (const std::exception& error) {
    const bool only_checks =
        std::find(argv, argv + argc, std::string_view("--check")) != argv + argc;
    const int code =
        client::tell(error, only_checks ? client::For::eagerx_gen : client::For::people);
    if (ranks && ranks->size() > 1) ranks->abort(code);  // the others wait for this one
    return code;
  }
}

}  // namespace
}  // namespace eagerx::train

int main(int argc, char** argv) {
  eagerx::host::open_standard_files();
  return eagerx::train::run(argc, argv);
}
