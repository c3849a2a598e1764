// eagerx-train LIBRARY: trains a policy on the environments of a graph.
#include <csignal>
#include <runtime/host/base/interrupt.hpp>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/seeds.hpp"
#include "targets/environments/train/sweep.hpp"
#include "targets/environments/train/training.hpp"

namespace eagerx::train {
namespace {

int run(int argc, char** argv) {
  try {
    const Options options = parse_options(argc, argv);
    if (options.wants_help) {
      print(help_text());
      return kDone;
    }
    options.cases.empty() ? check_files(options) : check_files_of_sweep(options);
    if (options.only_checks) return kDone;
    const Library library(options.library);
    const host::Interrupt& interrupt =
        host::watch_interrupts({SIGINT, SIGTERM}, host::Second::ends);
    if (!options.cases.empty()) return train_sweep(options, library, interrupt);
    if (options.seeds > 1) return train_seeds(options, library, interrupt);
    return Training(options, library).run(interrupt);
  } catch (const std::exception& error) {
    return client::tell(error);
  }
}

}  // namespace
}  // namespace eagerx::train

int main(int argc, char** argv) {
  return eagerx::train::run(argc, argv);
}
