#include "targets/environments/train/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "targets/environments/client/command_line.hpp"
#include "targets/environments/options/train.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/presets.hpp"

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
    if (!problem.help.empty()) throw;
    throw Problem(problem.code, name + ": " + problem.what(),
                  "`eagerx-gen help train-settings` lists settings and ranges");
  }
}

void give(Options& options, const std::string& name, const std::string& text) {
  set(options.settings, name, text);
  options.given.push_back(name + "=" + text);
}

/// "clip" of "clip=0.1"
std::string setting_name(const std::string& word) {
  return word.substr(0, word.find('='));
}

/// A setter for each option's value.
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
         o.algorithm_given = true;
       }},
      {"--steps", [&](Text v) { o.steps = number<std::uint64_t>(v, 1, kMostSteps); }},
      {"--until-return",
       [&](Text v) { settings.until_return = number<double>(v, -kMostReturn, kMostReturn); }},
      {"--seed", [&](Text v) { settings.seed = number<std::uint64_t>(v, 0, kMostSeed); }},
      {"--seeds", [&](Text v) { o.seeds = number<std::uint64_t>(v, 1, 1000); }},
      {"--threads", [&](Text v) { o.threads = number<unsigned>(v, 1, 1024); }},
      {"--hidden", [&](Text v) { give(o, "net_arch", v); }},
      {"--gamma", [&](Text v) { give(o, "gamma", v); }},
      {"--preset", [&](Text v) { o.preset = v; }},
      {"--setting",
       [&](Text v) {
         set_named(settings, v);
         o.given.push_back(v);
       }},
      {"--checkpoint", [&](Text v) { o.checkpoint = v; }},
      {"--resume", [&](Text v) { o.resume = v; }},
      {"--case",
       [&](Text v) {
         o.cases.push_back({v, {}});
       }},
      {"--results", [&](Text v) { o.results = v; }},
      {"--failure-replay", [&](Text v) { o.failure_replay = v; }},
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

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// The names of "a=1 b=2": "a b".
std::string names_of(const std::string& words) {
  std::vector<std::string> names = words_of(words);
  std::ranges::transform(names, names.begin(), setting_name);
  return fmt::format("{}", fmt::join(names, " "));
}

void set_case(Case& one) {
  for (const std::string& word : words_of(one.words)) {
    set_named(one.settings, word);
    check_algorithm(one.settings, setting_name(word));
  }
  try {
    check(one.settings);
  } catch (const Problem& problem) {
    Problem more(problem.code, fmt::format("{} ({})", problem.what(), one.words), problem.help);
    more.about = problem.about;
    throw more;
  }
}

/// Sets what the words of each case say. All have the same names, because they are columns.
void set_cases(Options& options) {
  for (Case& one : options.cases) {
    if (names_of(one.words) != names_of(options.cases.front().words))
      refuse("--case: all name the same settings");
    one.settings = options.settings;
    try {
      set_case(one);
    } catch (const Problem& problem) {
      throw in_words_of(problem, options, one.words);
    }
  }
}

void check_settings(const Options& options) {
  try {
    for (const std::string& word : options.given)
      check_algorithm(options.settings, setting_name(word));
    if (options.cases.empty()) check(options.settings);
  } catch (const Problem& problem) {
    throw in_words_of(problem, options);
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
      refuse(fmt::format("--sweep takes no {}: --results continues by itself", name));
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
      refuse("--resume continues one training and --from begins another: give one of them");
    if (!options.resume.empty() && !options.replay.empty())
      refuse("--resume continues a training that has its logs already: leave --replay out");
    apply_preset(options);
    check_settings(options);
    check_sweep(options);
    if (options.library.empty() && !options.only_checks) refuse("LIBRARY is missing");
  };
  client::parse({"train", table(options), &options.library, check_all}, argc, argv);
  return options;
}

Problem in_words_of(Problem problem, const Options& options, const std::string& words) {
  std::vector<std::string> given = options.given, found;
  const auto more = words_of(words);
  given.insert(given.end(), more.begin(), more.end());
  for (const std::string& name : problem.about) {
    const auto last = std::find_if(given.rbegin(), given.rend(), [&](const std::string& word) {
      return setting_name(word) == name;
    });
    if (options.only_checks && last != given.rend()) found.push_back(*last);
  }
  problem.about = std::move(found);
  return problem;
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
