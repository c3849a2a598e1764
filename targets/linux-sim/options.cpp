#include <algorithm>
#include <array>
#include <optional>
#include <runtime/host/base/nearest.hpp>
#include <targets/linux-sim/option_table.hpp>
#include <targets/linux-sim/options.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

using target::Agent;

/// The first option does nothing without the second.
constexpr std::array<std::array<std::string_view, 2>, 12> kNeeds{{
    {"--csv-states", "--csv"},
    {"--trace-time", "--trace"},
    {"--trace-scenes", "--trace"},
    {"--size", "--render"},
    {"--publish-only", "--publish"},
    {"--publish-rate", "--publish"},
    {"--publish-key", "--publish"},
    {"--replay-given", "--replay"},
    {"--identify-out", "--identify"},
    {"--identify-sensors", "--identify"},
    {"--identify-horizon", "--identify"},
    {"--identify-delay", "--identify"},
}};
/// With a log, the log decides on these, or nothing is written.
constexpr std::array<std::string_view, 2> kReadLogs{"--replay", "--identify"};
constexpr std::array<std::string_view, 13> kNotWithLogs{
    "--set",    "--fault", "--until",    "--measure",     "--summary",          "--csv",
    "--trace",  "--seed",  "--episodes", "--environment", "--real-time-factor", "--render",
    "--publish"};

std::string nearest_option(std::string_view name) {
  std::vector<std::string> names;
  for (const Option& option : all_options()) names.emplace_back(option.name);
  const std::string near = host::did_you_mean(name, names);
  return near.empty() ? "`--help` lists all options" : near;
}

std::string quoted(std::string_view text) {
  return "`" + std::string(text) + "`";
}

/// Options that would do nothing together with the others that are given.
std::optional<UsageError> find_idle_option(const std::vector<std::string_view>& given) {
  const auto has = [&](std::string_view name) {
    return std::find(given.begin(), given.end(), name) != given.end();
  };
  for (const auto& [option, other] : kNeeds) {
    if (has(option) && !has(other))
      return UsageError{quoted(option) + " does nothing without " + quoted(other), "leave it out"};
  }
  for (const std::string_view log : kReadLogs) {
    for (const std::string_view option : kNotWithLogs) {
      if (has(log) && has(option))
        return UsageError{quoted(option) + " does nothing with " + quoted(log), "leave it out"};
    }
  }
  if (has(kReadLogs[0]) && has(kReadLogs[1]))
    return UsageError{
        quoted(kReadLogs[0]) + " and " + quoted(kReadLogs[1]) + " are two things to do",
        "give one of them"};
  return std::nullopt;
}

}  // namespace

std::variant<Options, UsageError> parse_options(int count, const char* const* arguments,
                                                Options defaults) {
  Options options = std::move(defaults);
  std::vector<std::string_view> given;
  for (int i = 0; i < count; ++i) {
    const std::string_view argument = arguments[i];
    const std::size_t equals = argument.find('=');
    const std::string_view name = argument.substr(0, equals);
    const auto option = std::ranges::find_if(all_options(), [&](const Option& each) {
      return each.name == name && (options.split || !each.split);
    });
    if (option == all_options().end()) {
      if (name.starts_with("-")) {
        return UsageError{"unknown option " + quoted(name), nearest_option(name)};
      }
      return UsageError{"unexpected argument " + quoted(argument), "`--help` lists all options"};
    }
    given.push_back(option->name);
    std::string_view value;
    if (equals != std::string_view::npos) {
      if (option->value.empty())
        return UsageError{quoted(name) + " takes no value", "leave it out"};
      value = argument.substr(equals + 1);
    } else if (!option->value.empty()) {
      if (++i == count) {
        return UsageError{quoted(name) + " needs a value", "it is " + std::string(option->wants)};
      }
      value = arguments[i];
    }
    if (!option->set(options, value)) {
      return UsageError{quoted(value) + " is not a value of " + quoted(name),
                        "it is " + std::string(option->wants)};
    }
  }
  if (options.csv == "-" && options.trace == "-") {
    return UsageError{"both `--csv` and `--trace` want the standard output",
                      "give one of them a file"};
  }
  if (options.agent != kDdsAgent &&
      std::find(given.begin(), given.end(), "--agent-timeout") != given.end())
    return UsageError{"`--agent-timeout` does nothing without `--agent dds`", "leave it out"};
  if (const auto idle = find_idle_option(given)) return *idle;
  if (!options.publish_key.empty() &&
      std::ranges::count(options.publish, Destination::Kind::foxglove, &Destination::kind) == 0)
    return UsageError{"`--publish-key` does nothing without `--publish foxglove:`", "leave it out"};
  return options;
}

std::string_view agent_name(const Options& options) {
  if (options.agent == kDdsAgent) return "dds";
  return options.agent == kExternalAgent ? "external" : target::name_of(options.agent);
}

std::string options_help(const Options& defaults) {
  constexpr std::size_t kColumn = 26;
  std::string text;
  for (const Option& option : all_options()) {
    if (option.split && !defaults.split) continue;
    std::string line = "  " + std::string(option.name);
    if (!option.value.empty()) line += " " + std::string(option.value);
    line.resize(std::max(line.size() + 1, kColumn), ' ');
    line += option.about;
    if (option.name == "--episodes") line += " (" + std::to_string(defaults.plan.episodes) + ")";
    if (option.name == "--steps") line += " (" + std::to_string(defaults.plan.steps) + ")";
    if (option.name == "--seed") line += " (" + std::to_string(defaults.plan.seed) + ")";
    if (option.name == "--environment")
      line += " (" + std::to_string(defaults.plan.environment) + ")";
    if (option.name == "--agent") {
      line += " (" + std::string(target::name_of(defaults.agent));
      if (defaults.agent == Agent::csv) line += " " + defaults.action_file;
      line += ")";
    }
    if (option.name == "--baud") line += " (" + std::to_string(defaults.baud) + ")";
    if (option.name == "--link-timeout") line += " (5)";
    text += line + "\n";
  }
  return text + R"(
A FILE of actions has a row of numbers for each step, in the order above; every episode starts at its
first row. A first row with the names of the columns and lines that begin with # are skipped.
`-` writes to the standard output; the summary then goes to the standard error.
Outputs are files on a disk, none of them an input; what is in them stays until the run has begun.
Ctrl-C, and every other signal that would end the program but SIGKILL, ends the run after the current step, or after the
current slot of a reset that waits for something, with files complete and the summary; a second Ctrl-C more than a second
later ends it at once. Ctrl-Z makes actuators safe first. After SIGKILL, and if a program is stopped or hangs (`heartbeat_timeout:` of
`safety:`), another process makes them safe.

Exit codes: 0 done or interrupted, 1 problem in a file of actions, failed self-test, diverged from the log, out of a space
that is strict or a reward that is not finite, 2 wrong usage, 3 cannot read or write.
)";
}

}  // namespace eagerx::linux_sim
