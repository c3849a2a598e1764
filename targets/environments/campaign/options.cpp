#include "targets/environments/campaign/options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>

#include "targets/environments/client/problem.hpp"

namespace eagerx::campaign {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw client::Problem(client::kUsage, what, "`eagerx-gen campaign --help` lists the options");
}

/// Whether all of `text` is a number from `low` to `high`.
template <class T>
bool read(std::string_view text, T low, T high, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && value >= low && value <= high;
}

template <class T>
T number(std::string_view text, T low, T high) {
  T value{};
  if (!read(text, low, high, value))
    refuse("`" + std::string(text) + "` is not a number in its range");
  return value;
}

/// "pendulum.mass=0.1:0.2"
Variation variation(const std::string& text) {
  constexpr double kMost = 3.4e38;  // of float32
  const std::size_t equals = text.find('='), colon = text.find(':', equals);
  Variation result{text.substr(0, equals)};
  const bool is_complete = equals != std::string::npos && equals != 0 && colon != std::string::npos;
  const std::string_view all = text;
  if (!is_complete ||
      !read(all.substr(equals + 1, colon - equals - 1), -kMost, kMost, result.low) ||
      !read(all.substr(colon + 1), -kMost, kMost, result.high)) {
    refuse("`" + text + "` is not NAME=LOW:HIGH, such as pendulum.mass=0.1:0.2");
  }
  if (result.low > result.high) refuse("`" + text + "`: the lower bound comes first");
  return result;
}

target::Fault fault(const std::string& text) {
  const auto result = target::parse_fault(text);
  if (!result) {
    throw client::Problem(client::kUsage, "`" + text + "` is no fault",
                          std::string("write ") + target::kFaultForms);
  }
  return *result;
}

struct Option {
  const char* name;
  const char* value;
  const char* about;
  std::function<void(Options&, const std::string&)> set;
};

const auto& table() {
  constexpr std::uint32_t kMostRuns = 100'000'000, kMostSteps = 1'000'000'000;
  constexpr std::uint64_t kMostSeed = UINT64_MAX;
  static const std::array kTable = {
      Option{"--runs", "N", "episodes (default: 1000)",
             [](Options& o, const std::string& v) {
               o.runs = number<std::uint32_t>(v, 1, kMostRuns);
             }},
      Option{"--vary", "NAME=LOW:HIGH", "draw a state or a delay from a range, may be repeated",
             [](Options& o, const std::string& v) { o.variations.push_back(variation(v)); }},
      Option{"--faults", "NAME=KIND",
             "silent, nan, offset:X or value:X of an observation or an action, from a step that "
             "each run draws, may be repeated",
             [](Options& o, const std::string& v) { o.faults.push_back(fault(v)); }},
      Option{"--steps", "N", "end an episode after so many (default: what the task says, or 300)",
             [](Options& o, const std::string& v) {
               o.steps = number<std::uint32_t>(v, 1, kMostSteps);
             }},
      Option{"--seed", "N", "another one is another campaign (default: 1)",
             [](Options& o, const std::string& v) {
               o.seed = number<std::uint64_t>(v, 0, kMostSeed);
             }},
      Option{"--threads", "N", "the report does not depend on it (default: one for each core)",
             [](Options& o, const std::string& v) { o.threads = number<unsigned>(v, 1, 1024); }},
      Option{"--worst", "N", "name so many of the worst runs (default: 5)",
             [](Options& o, const std::string& v) { o.worst = number<std::size_t>(v, 0, 1000); }},
      Option{"--csv", "FILE", "write a table with a row for each run",
             [](Options& o, const std::string& v) { o.csv = v; }},
      Option{"--checkpoint", "FILE", "add finished runs to this file, for --resume",
             [](Options& o, const std::string& v) { o.checkpoint = v; }},
      Option{"--resume", "FILE", "go on from a checkpoint: the report is that of one long run",
             [](Options& o, const std::string& v) { o.resume = v; }},
      Option{"--replay", "WORDS", "what the command that repeats a run begins with",
             [](Options& o, const std::string& v) { o.replay = v; }},
  };
  return kTable;
}

/// A word without a value; false if it is none.
bool take_flag(Options& options, std::string_view word) {
  if (word == "--help" || word == "-h") return options.wants_help = true;
  if (word == "-q" || word == "--quiet") return options.is_quiet = true;
  if (word == "--json") return options.json = true;
  if (word == "--check") return options.only_checks = true;
  return false;
}

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (take_flag(options, word)) continue;
    if (!word.starts_with('-')) {
      if (!options.library.empty()) refuse("there is one LIBRARY only, `" + word + "` is another");
      options.library = word;
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const auto option = std::ranges::find(table(), name, &Option::name);
    if (option == table().end()) refuse("there is no option `" + word + "`");
    if (equals == std::string::npos && i + 1 == argc) refuse("`" + word + "` needs a value");
    option->set(options, equals == std::string::npos ? argv[++i] : word.substr(equals + 1));
  }
  if (options.wants_help) return options;
  if (!options.checkpoint.empty() && !options.resume.empty())
    refuse("`--resume` goes on in its file: leave out `--checkpoint`");
  if (options.library.empty() && !options.only_checks) refuse("LIBRARY is missing");
  return options;
}

std::string help_text() {
  constexpr std::size_t kColumn = 23;
  std::string text =
      "usage: eagerx-campaign LIBRARY [options]\n"
      "Runs many episodes of LIBRARY, which `eagerx-gen build GRAPH.yaml --target environments` "
      "makes, and counts successes.\n"
      "`eagerx-gen campaign GRAPH.yaml` does both.\n\n";
  for (const Option& option : table()) {
    std::string name = std::string("  ") + option.name + " " + option.value;
    name.resize(std::max(kColumn, name.size() + 1), ' ');
    text += name + option.about + "\n";
  }
  return text +
         "  --json               print the report as JSON\n"
         "  -q, --quiet          print problems only\n"
         "  --check              only look whether the options are right and the files can be "
         "written\n"
         "Exit codes: 0 done, 1 a problem of the graph, 2 wrong usage, 3 cannot read or write, 130 "
         "interrupted.\n";
}

}  // namespace eagerx::campaign
