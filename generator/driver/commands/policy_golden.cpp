// eagerx-gen policy golden: known answers for a policy that has none.
#include <fmt/core.h>

#include <utility>

#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/policy_file.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/policy/formats/golden.hpp"
#include "generator/policy/network/observations.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

struct PolicyGoldenOptions : PolicyOptions {
  AskedOptions asked;
  std::string output;
};

int perform(const PolicyGoldenOptions& options) {
  Run run;
  const auto network = read_policy_file(options.policy, run.diagnostics);
  auto asked = network ? asked_rows(*network, options.asked, run.diagnostics) : std::nullopt;
  if (!asked || !add_answers(*network, asked->rows, run.diagnostics)) return finish(run, options);
  const std::string about =
      fmt::format("answers of {} in float64; observations: {}", options.policy.file, asked->origin);
  const bool written = write_file(options.output, golden_csv(asked->rows, about), run.diagnostics);
  if (written && !options.quiet) {
    say("{}: {}\n", options.output, counted(asked->rows.observations.size(), "row"));
    say("observations   {}\n", asked->origin);
    if (network->has_memory()) say("episodes       as `episode_start` says\n");
    if (asked->rows.actions.empty()) {
      say("actions        left out: the file does not say their bounds\n");
    }
  }
  return finish(run, options);
}

Command table(PolicyGoldenOptions& options) {
  Argument output = required(
      writes(text("-o,--output-file", options.output, "the table to write", "GOLDEN.csv")));
  return {.name = "golden",
          .about = "write observations and the answers of a policy, computed in float64",
          .examples = {{"1000 random observations; the same for the same seed",
                        "eagerx-gen policy golden swing_up.onnx --rows 1000 -o golden.csv"},
                       {"observations of a run",
                        "eagerx-gen policy golden sac.zip --observations run.csv -o golden.csv"}},
          .arguments = joined({one_policy(options), asked(options.asked), {std::move(output)}}),
          .check = [&options] { return check_asked(options.asked); },
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command policy_golden_command() {
  return with_options<PolicyGoldenOptions>(table);
}

}  // namespace eagerx::gen
