// eagerx-campaign LIBRARY: many episodes of a graph with its agent in the loop.
#include <csignal>
#include <runtime/host/base/interrupt.hpp>

#include "targets/environments/campaign/campaign.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

/// Rank 0 alone looks at options and files. What it shares is the library, which need not be on the
/// machines of the others; nothing, if there is nothing to do.
int run_ranks(int argc, char** argv, Ranks& ranks) {
  const std::string bytes = ranks.is_first() ? std::string() : ranks.share({});
  if (!ranks.is_first() && bytes.empty()) return client::kDone;
  Options options = parse_options(argc, argv);
  if (ranks.is_first()) {
    if (options.wants_help) client::print(help_text());
    if (!options.wants_help) check_files(options);
    const bool is_all = options.wants_help || options.only_checks;
    ranks.share(is_all || ranks.size() == 1 ? std::string() : client::read_file(options.library));
    if (is_all) return client::kDone;
  }
  const client::Library library(ranks.is_first() ? options.library : environments::file_of(bytes));
  return run_campaign(options, library, ranks,
                      host::watch_interrupts({SIGINT, SIGTERM}, host::Second::ends));
}

int run(int argc, char** argv) {
  std::unique_ptr<Ranks> ranks;
  try {
    ranks = environments::make_ranks(argc, argv);
    return run_ranks(argc, argv, *ranks);
  } catch (const std::exception& error) {
    const int code = client::tell(error);
    if (ranks && ranks->size() > 1) ranks->abort(code);  // the others wait for this one
    return code;
  }
}

}  // namespace
}  // namespace eagerx::campaign

int main(int argc, char** argv) {
  return eagerx::campaign::run(argc, argv);
}
