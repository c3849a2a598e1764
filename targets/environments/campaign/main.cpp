// eagerx-campaign LIBRARY: many episodes of a graph with its agent in the loop.
#include <csignal>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/interrupt.hpp>

#include "targets/environments/campaign/campaign.hpp"
#include "targets/environments/campaign/plan.hpp"
#include "targets/environments/client/description.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

const host::Interrupt& interrupts() {
  return host::watch_interrupts({SIGINT, SIGTERM}, host::Second::ends);
}

/// Whether a campaign fits a graph whose library is not built yet. Throws Problem.
void check_graph(const Options& options) {
  make_plan(client::read_description(options.describes), options.seed, options.runs, options.steps,
            options.variations, options.faults);
}

/// Rank 0 alone looks at options and files. What it shares are its words and the library, which
/// need not be on the machines of the others; nothing, if there is nothing to do.
int run_first(int argc, char** argv, Ranks& ranks) {
  const Options options = parse_options(argc, argv);
  if (options.wants_help) client::print(help_text());
  if (!options.wants_help) check_files(options);
  if (options.only_checks && !options.describes.empty()) check_graph(options);
  const bool is_all = options.wants_help || options.only_checks;
  ranks.share(is_all ? std::string() : environments::words_of(argc, argv));
  if (is_all) return client::kDone;
  ranks.share(ranks.size() == 1 ? std::string() : client::read_file(options.library));
  return run_campaign(options, client::Library(options.library), ranks, interrupts());
}

int run_other(Ranks& ranks) {
  const std::string words = ranks.share({});
  if (words.empty()) return client::kDone;
  const auto argv = environments::command_line("eagerx-campaign", words);
  const Options options = parse_options(static_cast<int>(argv.size()), argv.data());
  const client::Library library(environments::file_of(ranks.share({})));
  return run_campaign(options, library, ranks, interrupts());
}

int run(int argc, char** argv) {
  std::unique_ptr<Ranks> ranks;
  try {
    ranks = environments::make_ranks(argc, argv);
    return ranks->is_first() ? run_first(argc, argv, *ranks) : run_other(*ranks);
  } catch (const std::exception& error) {
    const int code = client::tell(error);
    if (ranks && ranks->size() > 1) ranks->abort(code);  // the others wait for this one
    return code;
  }
}

}  // namespace
}  // namespace eagerx::campaign

int main(int argc, char** argv) {
  eagerx::host::open_standard_files();
  return eagerx::campaign::run(argc, argv);
}
