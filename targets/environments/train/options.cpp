#include "targets/environments/train/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include "targets/environments/client/command_line.hpp"
#include "targets/environments/options/train.hpp"
#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

using client::number;
using client::refuse;

/// "clip=0.1"
void set_named(Settings& settings, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse("`" + text + "` is not NAME=VALUE");
  const std::string name = text.substr(0, equals);
  try {
    set(settings, name, text.substr(equals + 1));
  } catch (const Problem& problem) {
    throw Problem(problem.code,
                  problem.help.empty() ? name + ": " + problem.what() : problem.what(),
                  problem.help);
  }
}

/// What each option does with its value.
std::vector<client::Setter> setters(Options& o) {
  using Text = const std::string&;
  constexpr std::uint64_t kMostSteps = 1'000'000'000'000;
  constexpr std::uint64_t kMostSeed = (std::uint64_t{1} << 62U) - 1;  // above: evaluation
  constexpr double kMostReturn = 1e30;
  Settings& settings = o.settings;
  return {
      {"--output", [&](Text v) { o.output = v; }},
      {"--algorithm",
       [&](Text v) {
         if (v != "ppo" && v != "sac")
           refuse("there is no algorithm `" + v + "`, only ppo and sac");
         settings.algorithm = v;
       }},
      {"--steps", [&](Text v) { o.steps = number<std::uint64_t>(v, 1, kMostSteps); }},
      {"--until-return",
       [&](Text v) { settings.until_return = number<double>(v, -kMostReturn, kMostReturn); }},
      {"--seed", [&](Text v) { settings.seed = number<std::uint64_t>(v, 0, kMostSeed); }},
      {"--seeds", [&](Text v) { o.seeds = number<std::uint64_t>(v, 1, 1000); }},
      {"--threads", [&](Text v) { o.threads = number<unsigned>(v, 1, 1024); }},
      {"--hidden", [&](Text v) { set(settings, "layers", v); }},
      {"--discount", [&](Text v) { set(settings, "discount", v); }},
      {"--setting",
       [&](Text v) {
         set_named(settings, v);
         o.named.push_back(v.substr(0, v.find('=')));
       }},
      {"--checkpoint", [&](Text v) { o.checkpoint = v; }},
      {"--resume", [&](Text v) { o.resume = v; }},
      {"--case",
       [&](Text v) {
         o.cases.push_back({v, {}});
       }},
      {"--results", [&](Text v) { o.results = v; }},
      {"--hard-starts", [&](Text v) { o.hard_starts = v; }},
      {"--from", [&](Text v) { o.from = v; }},
      {"--replay", [&](Text v) { o.replay.push_back(v); }},
      {"--csv", [&](Text v) { o.csv = v; }},
      {"--curve", [&](Text v) { o.curve = v; }},
      {"--record", [&](Text v) { o.record = v; }},
      {"--tensorboard", [&](Text v) { o.tensorboard = v; }},
      {"--isa", [&](Text v) { o.kernels = v; }},
      {"--quiet", [&](Text) { o.is_quiet = true; }},
      {"--check", [&](Text) { o.only_checks = true; }},
      {"--help", [&](Text) { o.wants_help = true; }},
  };
}

/// The names of "a=1 b=2": "a b".
std::string names_of(const std::string& words) {
  std::string names;
  bool is_name = true;
  for (const char c : words) {
    if (c == '=') is_name = false;
    if (c == ' ') is_name = true;
    if (is_name) names += c;
  }
  return names;
}

/// Sets what the words of each case say. All have the same names, because they are columns.
void set_cases(Options& options) {
  for (Case& one : options.cases) {
    if (names_of(one.words) != names_of(options.cases.front().words))
      refuse("--case: all name the same settings");
    one.settings = options.settings;
    std::istringstream words(one.words);
    for (std::string word; words >> word;) {
      set_named(one.settings, word);
      check_algorithm(one.settings, word.substr(0, word.find('=')));
    }
    try {
      check(one.settings);
    } catch (const Problem& problem) {
      throw Problem(problem.code, fmt::format("{} ({})", problem.what(), one.words), problem.help);
    }
  }
}

void check_sweep(Options& options) {
  if (options.cases.empty()) return;
  const std::pair<const char*, const std::string*> others[] = {
      {"--checkpoint", &options.checkpoint},
      {"--resume", &options.resume},
      {"--curve", &options.curve},
      {"--record", &options.record},
      {"--tensorboard", &options.tensorboard}};
  for (const auto& [name, value] : others) {
    if (!value->empty())
      refuse(fmt::format("--sweep takes no {}: --results goes on by itself", name));
  }
  set_cases(options);
}

std::vector<client::Option> table(Options& options) {
  return client::options_of(options::kTrain, setters(options));
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  const auto check_all = [&] {
    if (!options.resume.empty() && !options.from.empty())
      refuse("--resume goes on with one training and --from begins another: give one of them");
    if (!options.resume.empty() && !options.replay.empty())
      refuse("--resume goes on with a training that has its logs already: leave --replay out");
    check(options.settings);
    for (const std::string& name : options.named) check_algorithm(options.settings, name);
    check_sweep(options);
    if (options.library.empty() && !options.only_checks) refuse("LIBRARY is missing");
  };
  client::parse({"train", table(options), &options.library, check_all}, argc, argv);
  return options;
}

std::string help_text() {
  Options unused;
  return "usage: eagerx-train LIBRARY [options]\n"
         "Trains a policy on the environments of LIBRARY, which `eagerx-gen generate GRAPH.yaml "
         "--target environments` makes.\n"
         "`eagerx-gen train GRAPH.yaml` does both.\n\n" +
         client::help_of(table(unused)) +
         "Exit codes: 0 done, 1 not successful or a problem of the graph, 2 wrong usage, 3 "
         "cannot read or write, 130 interrupted.\n";
}

}  // namespace eagerx::train
