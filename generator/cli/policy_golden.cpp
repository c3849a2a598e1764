// eagerx-gen policy golden: known answers for whoever has none.
#include <fmt/core.h>

#include "generator/cli/pipeline.hpp"
#include "generator/cli/policy_file.hpp"
#include "generator/cli/write.hpp"
#include "generator/formats/golden.hpp"
#include "generator/network/observations.hpp"

namespace eagerx::gen {

int policy_golden_command(const Options& options) {
  Run run;
  const auto network = read_policy_file(options.policy, run.diagnostics);
  auto asked = network ? asked_rows(*network, options, run.diagnostics) : std::nullopt;
  if (!asked || !add_answers(*network, asked->rows, run.diagnostics)) return finish(run, options);
  const std::string about =
      fmt::format("answers of {} in float64; observations: {}", options.policy.file, asked->origin);
  const bool written = write_file(options.output, golden_csv(asked->rows, about), run.diagnostics);
  if (written && !options.quiet) {
    say("{}: {} rows\n", options.output, asked->rows.observations.size());
    say("observations   {}\n", asked->origin);
    if (network->has_memory()) say("episodes       as `episode_start` says\n");
    if (asked->rows.actions.empty()) {
      say("actions        left out: the file does not say their bounds\n");
    }
  }
  return finish(run, options);
}

}  // namespace eagerx::gen
