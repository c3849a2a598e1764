#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <targets/linux-sim/nearest.hpp>
#include <targets/linux-sim/options.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

using target::Agent;

/// Strict: the whole text is one number of this type, at least `low`.
template <class T>
bool parse_number(std::string_view text, T low, T& value) {
  T parsed{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  if (error != std::errc() || end != text.data() + text.size() || !(parsed >= low)) return false;
  value = parsed;
  return true;
}

bool set_episodes(Options& options, std::string_view value) {
  return parse_number(value, std::uint32_t{1}, options.plan.episodes);
}
bool set_steps(Options& options, std::string_view value) {
  return parse_number(value, std::uint64_t{1}, options.plan.steps);
}
bool set_seed(Options& options, std::string_view value) {
  return parse_number(value, std::uint64_t{0}, options.plan.seed);
}
bool set_environment(Options& options, std::string_view value) {
  return parse_number(value, std::uint32_t{0}, options.plan.environment);
}
bool set_agent(Options& options, std::string_view value) {
  if (value.ends_with(".csv")) {
    options.agent = Agent::csv;
    options.action_file = value;
    return true;
  }
  if (value.starts_with("dds")) {
    dds::Network network;
    if (!dds::parse_network(value.substr(3), network) || !network.interface.empty()) return false;
    options.agent = Agent::dds;
    options.agent_domain = network.domain;
    return true;
  }
  constexpr std::string_view kSocket = "fd:";
  if (value.starts_with(kSocket)) {
    options.agent = Agent::outside;
    return parse_number(value.substr(kSocket.size()), 0, options.agent_socket);
  }
  Agent agent{};
  if (!target::agent_of(value, agent)) return false;
  // `csv` alone is the file that the graph names.
  if (agent == Agent::csv && options.action_file.empty()) return false;
  options.agent = agent;
  return true;
}
bool set_agent_timeout(Options& options, std::string_view value) {
  constexpr double kLongest = 1e6;
  return parse_number(value, 0.001, options.agent_timeout_s) && options.agent_timeout_s <= kLongest;
}
bool set_csv(Options& options, std::string_view value) {
  options.csv = value;
  return !value.empty();
}
bool set_trace(Options& options, std::string_view value) {
  options.trace = value;
  return !value.empty();
}
bool set_trace_time(Options& options, std::string_view) {
  return options.trace_time = true;
}
bool set_trace_scenes(Options& options, std::string_view) {
  return options.trace_scenes = true;
}
bool set_replay(Options& options, std::string_view value) {
  options.replay = value;
  return !value.empty();
}
bool set_replay_given(Options& options, std::string_view value) {
  options.replay_given = value;
  return !value.empty();
}
bool set_identify(Options& options, std::string_view value) {
  options.identify = value;
  return !value.empty();
}
bool set_identify_out(Options& options, std::string_view value) {
  options.identify_out = value;
  return !value.empty();
}
bool set_identify_sensors(Options& options, std::string_view value) {
  options.identify_sensors = value;
  return !value.empty();
}
bool set_identify_horizon(Options& options, std::string_view value) {
  constexpr double kLongest = 1e6;
  return parse_number(value, 1e-6, options.identify_horizon_s) &&
         options.identify_horizon_s <= kLongest;
}
bool set_identify_delay(Options& options, std::string_view value) {
  constexpr double kLongest = 10.0;
  return parse_number(value, 0.0, options.identify_delay_s) && options.identify_delay_s <= kLongest;
}
bool set_real_time_factor(Options& options, std::string_view value) {
  constexpr double kSlowest = 1e-6;
  constexpr double kFastest = 1e6;
  double factor = 0.0;
  if (!parse_number(value, 0.0, factor) || factor > kFastest) return false;
  if (factor > 0.0 && factor < kSlowest) return false;
  options.real_time_factor = factor;
  options.real_time_given = true;
  return true;
}
bool set_render(Options& options, std::string_view value) {
  options.rendering.to = value;
  return !value.empty();
}
bool set_size(Options& options, std::string_view value) {
  constexpr int kLeast = 16, kMost = 4096;
  const std::size_t x = value.find('x');
  Rendering& to = options.rendering;
  return x != std::string_view::npos && parse_number(value.substr(0, x), kLeast, to.width) &&
         parse_number(value.substr(x + 1), kLeast, to.height) && to.width <= kMost &&
         to.height <= kMost;
}
bool set_publish(Options& options, std::string_view value) {
  return parse_destination(value, options.publish.emplace_back());
}
bool set_publish_only(Options& options, std::string_view value) {
  options.publish_only.emplace_back(value);
  return !value.empty();
}
bool set_publish_rate(Options& options, std::string_view value) {
  constexpr double kFastest = 1e9;
  return parse_number(value, 1e-6, options.publish_rate_hz) && options.publish_rate_hz <= kFastest;
}
bool set_publish_key(Options& options, std::string_view value) {
  options.publish_key = value;
  return !value.empty();
}
bool set_link(Options& options, std::string_view value) {
  options.link = value;
  return !value.empty();
}
bool set_baud(Options& options, std::string_view value) {
  return parse_number(value, std::uint32_t{1}, options.baud);
}
bool set_link_timeout(Options& options, std::string_view value) {
  constexpr double kLongest = 1e6;
  return parse_number(value, 0.0, options.link_timeout_s) && options.link_timeout_s <= kLongest;
}
bool set_csv_states(Options& options, std::string_view) {
  return options.csv_states = true;
}
bool set_until(Options& options, std::string_view value) {
  options.until = value;
  return !value.empty();
}
bool set_measure(Options& options, std::string_view value) {
  options.measures.emplace_back(value);
  return !value.empty();
}
bool set_summary(Options& options, std::string_view) {
  return options.summary = true;
}
bool set_state(Options& options, std::string_view value) {
  options.settings.emplace_back(value);
  return true;
}
bool set_fault(Options& options, std::string_view value) {
  options.faults.emplace_back(value);
  return true;
}
bool set_strict_spaces(Options& options, std::string_view) {
  return options.strict_spaces = true;
}
bool set_hash(Options& options, std::string_view) {
  return options.hash = true;
}
bool set_self_test(Options& options, std::string_view) {
  return options.self_test = true;
}
bool set_quiet(Options& options, std::string_view) {
  return options.quiet = true;
}
bool set_help(Options& options, std::string_view) {
  return options.help = true;
}
bool set_version(Options& options, std::string_view) {
  return options.version = true;
}

/// One option: the parser and the help are both made from this table.
struct Option {
  std::string_view name;
  std::string_view value;  // what stands for its value in the help; empty: takes none
  std::string_view wants;  // what its value must be, for errors
  std::string_view about;
  bool (*set)(Options&, std::string_view);
  bool split = false;  // only for programs of which a part runs elsewhere
};

constexpr std::array kOptions{
    Option{"--episodes", "N", "a whole number from 1 to 4294967295", "episodes to run",
           set_episodes},
    Option{"--steps", "N", "a whole number from 1 to 18446744073709551615", "steps in each episode",
           set_steps},
    Option{"--seed", "N", "a whole number from 0 to 18446744073709551615",
           "seed of everything that is random", set_seed},
    Option{"--environment", "K", "a whole number from 0 to 4294967295",
           "number of the environment; each one has random numbers of its own", set_environment},
    Option{
        "--agent", "AGENT",
        "`policy`, `zero`, `random`, a file ending in `.csv`, `fd:N`, or `dds[:DOMAIN]` with a "
        "domain from 0 to 232",
        "policy, zero, random, FILE.csv, or another process: dds[:DOMAIN], or fd:N, the one at the "
        "other end of socket N",
        set_agent},
    Option{"--agent-timeout", "S", "a number from 0.001 to 1000000",
           "end the run after so many seconds without an action of `--agent dds` (10)",
           set_agent_timeout},
    Option{"--csv", "FILE", "a file name or `-`", "write observations and actions, one row a step",
           set_csv},
    Option{"--csv-states", "", "", "add columns with the states that each episode begins with",
           set_csv_states},
    Option{"--trace", "FILE", "a file name or `-`", "write every message, one line each",
           set_trace},
    Option{"--trace-time", "", "", "add the time of sending to each message of the trace",
           set_trace_time},
    Option{"--trace-scenes", "", "",
           "add what the graph's `render:` shows, to play it back in `eagerx-gen report`",
           set_trace_scenes},
    Option{"--replay", "LOG", "a file name", "repeat the run of a trace and compare the messages",
           set_replay},
    Option{"--replay-given", "LIST", "names between commas",
           "messages to take from LOG: actions, sensors, none or channels (actions,sensors)",
           set_replay_given},
    Option{"--identify", "LOG", "a file name",
           "find the parameters and delays that a trace was made with", set_identify},
    Option{"--identify-out", "FILE", "a file name", "write the result as YAML for the graph",
           set_identify_out},
    Option{"--identify-sensors", "LIST", "names between commas", "channels to fit (all sensors)",
           set_identify_sensors},
    Option{"--identify-horizon", "S", "seconds from 0.000001 to 1000000",
           "length of the pieces that the trace is cut into (0.5)", set_identify_horizon},
    Option{"--identify-delay", "S", "seconds from 0 to 10",
           "longest delay of an actuator to try (0.1)", set_identify_delay},
    Option{"--hash", "", "", "print the hash of the trace of all episodes", set_hash},
    Option{"--real-time-factor", "X", "0 or a number from 0.000001 to 1000000",
           "simulated seconds a second; 0: as fast as possible", set_real_time_factor},
    Option{
        "--render", "TO", "`window`, a film, pictures such as `frames/%04d.png`, `hash` or `asked`",
        "show what the graph's `render:` says: window, FILM.mp4, frames/%04d.png, hash, or asked "
        "(pictures for an agent that asks)",
        set_render},
    Option{"--size", "WxH", "such as `480x480`, from 16x16 to 4096x4096",
           "size of the pictures in pixels (480x480)", set_size},
    Option{
        "--publish", "KIND",
        "`foxglove:[HOST:]PORT`, `udp:HOST:PORT`, `teleplot:HOST:PORT`, `mcap:FILE`, or "
        "`dds[:DOMAIN][@INTERFACE]` with a domain from 0 to 232",
        "let others see the messages while it runs: foxglove:[HOST:]PORT, udp:HOST:PORT "
        "(PlotJuggler), teleplot:HOST:PORT, mcap:FILE or dds[:DOMAIN][@INTERFACE] (ROS 2); may be "
        "repeated",
        set_publish},
    Option{"--publish-only", "CHANNEL", "the name of a channel, such as `pendulum/theta`",
           "publish only this channel of the trace (all); may be repeated", set_publish_only},
    Option{"--publish-rate", "HZ", "a number from 0.000001 to 1000000000",
           "publish at most so many messages of a channel in a simulated second", set_publish_rate},
    Option{"--publish-key", "FILE", "a file name",
           "who has the key in FILE may change the run over foxglove:", set_publish_key},
    Option{"--link", "LINE", "a serial line, HOST:PORT or unix:PATH",
           "where the board is: a serial line (ours alone), HOST:PORT or unix:PATH", set_link,
           true},
    Option{"--baud", "N", "a whole number from 1 to 4294967295", "speed of a serial line", set_baud,
           true},
    Option{"--link-timeout", "S", "a number from 0 to 1000000",
           "end the run after so many seconds without an answer of the board", set_link_timeout,
           true},
    Option{"--set", "STATE=VALUE", "such as `pendulum.mass=0.1` or `pendulum.mass=uniform:0.1,0.2`",
           "value of a state at each reset, or how it is drawn: uniform:LOW,HIGH and so on; "
           "VALUE@STEP "
           "of a tunable parameter: from that step on; may be repeated",
           set_state},
    Option{"--fault", "NAME=KIND@STEP", "such as `angle=silent@40` or `angle[0]=offset:0.1@40+5`",
           "spoil what the agent sees or gives: silent, nan, offset:X or value:X of an observation "
           "or an action, from a step on, with +STEPS for so many; may be repeated",
           set_fault},
    Option{"--until", "CONDITION", "a condition such as `abs(pendulum.theta) > 1`",
           "end an episode after the first step at which this holds", set_until},
    Option{"--measure", "NUMBER", "an expression such as `abs(pendulum.theta)`",
           "tell mean, deviation and worst of this over all steps; may be repeated", set_measure},
    Option{"--summary", "", "", "tell mean, deviation, least and most over all episodes",
           set_summary},
    Option{"--strict-spaces", "", "", "end the run with the first message that is out of its space",
           set_strict_spaces},
    Option{"--self-test", "", "", "only compare the policy's answers with known ones",
           set_self_test},
    Option{"--quiet", "", "", "no summary and no progress bar", set_quiet},
    Option{"--help", "", "", "show this text", set_help},
    Option{"--version", "", "", "show graph, engine and version", set_version},
};

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
  constexpr std::size_t kLongestTypo = 3;
  const auto* nearest =
      std::min_element(kOptions.begin(), kOptions.end(), [&](const Option& a, const Option& b) {
        return edit_distance(name, a.name) < edit_distance(name, b.name);
      });
  if (edit_distance(name, nearest->name) > kLongestTypo) return "`--help` lists all options";
  return "did you mean `" + std::string(nearest->name) + "`?";
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
    const auto* option = std::find_if(kOptions.begin(), kOptions.end(), [&](const Option& each) {
      return each.name == name && (options.split || !each.split);
    });
    if (option == kOptions.end()) {
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
  if (options.agent != Agent::dds &&
      std::find(given.begin(), given.end(), "--agent-timeout") != given.end())
    return UsageError{"`--agent-timeout` does nothing without `--agent dds`", "leave it out"};
  if (const auto idle = find_idle_option(given)) return *idle;
  if (!options.publish_key.empty() &&
      std::ranges::count(options.publish, Destination::Kind::foxglove, &Destination::kind) == 0)
    return UsageError{"`--publish-key` does nothing without `--publish foxglove:`", "leave it out"};
  return options;
}

std::string_view agent_name(const Options& options) {
  return options.agent == Agent::dds ? "dds" : target::name_of(options.agent);
}

std::string options_help(const Options& defaults) {
  constexpr std::size_t kColumn = 26;
  std::string text;
  for (const Option& option : kOptions) {
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
later ends it at once. Ctrl-Z makes actuators safe first. Nothing can be done about SIGKILL and SIGSTOP.

Exit codes: 0 done or interrupted, 1 problem in a file of actions, failed self-test, diverged from the log, out of a space
that is strict or a reward that is not finite, 2 wrong usage, 3 cannot read or write.
)";
}

}  // namespace eagerx::linux_sim
