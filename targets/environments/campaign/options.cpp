#include "targets/environments/campaign/options.hpp"

#include <runtime/host/base/number.hpp>
#include <string_view>

#include "targets/environments/client/command_line.hpp"
#include "targets/environments/options/campaign.hpp"

namespace eagerx::campaign {
namespace {

using client::number;
using client::refuse;
using host::read_number;

/// "pendulum.mass=0.1:0.2"
Variation variation(const std::string& text) {
  constexpr double kMost = 3.4e38;  // of float32
  const std::size_t equals = text.find('='), colon = text.find(':', equals);
  Variation result{text.substr(0, equals)};
  const bool is_complete = equals != std::string::npos && equals != 0 && colon != std::string::npos;
  const std::string_view all = text;
  if (!is_complete ||
      !read_number(all.substr(equals + 1, colon - equals - 1), -kMost, kMost, result.low) ||
      !read_number(all.substr(colon + 1), -kMost, kMost, result.high)) {
    refuse("`" + text + "` is not NAME=LOW:HIGH, such as pendulum.mass=0.1:0.2");
  }
  if (result.low > result.high) refuse("`" + text + "`: the lower bound comes first");
  return result;
}

target::Fault fault(const std::string& text) {
  const auto result = target::parse_fault(text);
  if (!result) {
    throw client::Problem(client::kUsage, "`" + text + "` is not a fault",
                          std::string("write ") + target::kFaultForms);
  }
  return *result;
}

/// A setter for each option's value.
std::vector<client::Setter> setters(Options& o) {
  using Text = const std::string&;
  constexpr std::uint32_t kMostRuns = 100'000'000, kMostSteps = 1'000'000'000;
  return {
      {"--runs", [&](Text v) { o.runs = number<std::uint32_t>(v, 1, kMostRuns); }},
      {"--vary", [&](Text v) { o.variations.push_back(variation(v)); }},
      {"--faults", [&](Text v) { o.faults.push_back(fault(v)); }},
      {"--steps", [&](Text v) { o.steps = number<std::uint32_t>(v, 1, kMostSteps); }},
      {"--seed", [&](Text v) { o.seed = number<std::uint64_t>(v, 0, UINT64_MAX); }},
      {"--threads", [&](Text v) { o.threads = number<unsigned>(v, 1, 1024); }},
      {"--worst", [&](Text v) { o.worst = number<std::size_t>(v, 0, 1000); }},
      {"--csv", [&](Text v) { o.csv = v; }},
      {"--checkpoint", [&](Text v) { o.checkpoint = v; }},
      {"--resume", [&](Text v) { o.resume = v; }},
      {"--replay", [&](Text v) { o.replay = v; }},
      {"--json", [&](Text) { o.json = true; }},
      {"--quiet", [&](Text) { o.is_quiet = true; }},
      {"--check", [&](Text) { o.only_checks = true; }},
      {"--describes", [&](Text v) { o.describes = v; }},
      {"--help", [&](Text) { o.wants_help = true; }},
  };
}

std::vector<client::Option> table(Options& options) {
  return client::options_of(options::kCampaign, setters(options));
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  const auto check = [&] {
    if (!options.checkpoint.empty() && !options.resume.empty())
      refuse("`--resume` continues in its file: leave out `--checkpoint`");
    if (options.library.empty() && !options.only_checks) refuse("LIBRARY is missing");
  };
  client::parse({"campaign", table(options), &options.library, check}, argc, argv);
  return options;
}

std::string help_text() {
  Options unused;
  return "usage: eagerx-campaign LIBRARY [options]\n"
         "Runs many episodes of LIBRARY, which `eagerx-gen build GRAPH.yaml --target environments` "
         "makes, and counts successes.\n"
         "`eagerx-gen campaign GRAPH.yaml` does both.\n\n" +
         client::help_of(table(unused)) +
         "Exit codes: 0 done, 1 a problem of the graph, 2 wrong usage, 3 cannot read or write, 130 "
         "interrupted.\n";
}

}  // namespace eagerx::campaign
