#include <array>
#include <limits>
#include <runtime/host/base/number.hpp>
#include <targets/linux-sim/option_table.hpp>

namespace eagerx::linux_sim {
namespace {

using target::Agent;

template <class T>
bool at_least(std::string_view text, T low, T& value) {
  return host::read_number(text, low, std::numeric_limits<T>::max(), value);
}

bool set_episodes(Options& options, std::string_view value) {
  return at_least(value, std::uint32_t{1}, options.plan.episodes);
}
bool set_steps(Options& options, std::string_view value) {
  return at_least(value, std::uint64_t{1}, options.plan.steps);
}
bool set_seed(Options& options, std::string_view value) {
  return at_least(value, std::uint64_t{0}, options.plan.seed);
}
bool set_environment(Options& options, std::string_view value) {
  return at_least(value, std::uint32_t{0}, options.plan.environment);
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
    options.agent = kDdsAgent;
    options.agent_domain = network.domain;
    return true;
  }
  constexpr std::string_view kSocket = "fd:";
  if (value.starts_with(kSocket)) {
    options.agent = kExternalAgent;
    return at_least(value.substr(kSocket.size()), 0, options.agent_socket);
  }
  Agent agent{};
  if (!target::agent_of(value, agent)) return false;
  // `csv` alone is the file that the graph names.
  if (agent == Agent::csv && options.action_file.empty()) return false;
  options.agent = agent;
  return true;
}
bool set_agent_timeout(Options& options, std::string_view value) {
  return host::read_number(value, 0.001, 1e6, options.agent_timeout_s);
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
  return host::read_number(value, 1e-6, 1e6, options.identify_horizon_s);
}
bool set_identify_delay(Options& options, std::string_view value) {
  return host::read_number(value, 0.0, 10.0, options.identify_delay_s);
}
bool set_real_time_factor(Options& options, std::string_view value) {
  constexpr double kSlowest = 1e-6;
  double factor = 0.0;
  if (!host::read_number(value, 0.0, 1e6, factor)) return false;
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
  return x != std::string_view::npos &&
         host::read_number(value.substr(0, x), kLeast, kMost, to.width) &&
         host::read_number(value.substr(x + 1), kLeast, kMost, to.height);
}
bool set_publish(Options& options, std::string_view value) {
  return parse_destination(value, options.publish.emplace_back());
}
bool set_publish_only(Options& options, std::string_view value) {
  options.publish_only.emplace_back(value);
  return !value.empty();
}
bool set_publish_rate(Options& options, std::string_view value) {
  return host::read_number(value, 1e-6, 1e9, options.publish_rate_hz);
}
bool set_publish_key(Options& options, std::string_view value) {
  options.publish_key = value;
  return !value.empty();
}
bool set_link(Options& options, std::string_view value) {
  options.links.emplace_back(value);
  return !value.empty();
}
bool set_key(Options& options, std::string_view value) {
  options.keys.emplace_back(value);
  return !value.empty();
}
bool set_baud(Options& options, std::string_view value) {
  return at_least(value, std::uint32_t{1}, options.baud);
}
bool set_link_timeout(Options& options, std::string_view value) {
  return host::read_number(value, 0.0, 1e6, options.link_timeout_s);
}
bool set_reconnect(Options& options, std::string_view value) {
  return host::read_number(value, kLeastReconnectS, kMostReconnectS, options.reconnect_s);
}
bool set_lockstep(Options& options, std::string_view) {
  return options.lockstep = true;
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

constexpr std::array kOptions{
    Option{"--episodes", "N", "a whole number from 1 to 4294967295", "episodes to run",
           set_episodes},
    Option{"--steps", "N", "a whole number from 1 to 18446744073709551615", "steps in each episode",
           set_steps},
    Option{"--seed", "N", "a whole number from 0 to 18446744073709551615",
           "seed of everything that is random", set_seed},
    Option{"--environment", "K", "a whole number from 0 to 4294967295",
           "number of the environment; each one has random numbers of its own", set_environment},
    Option{"--agent", "AGENT",
           "`policy`, `zero`, `random`, a file ending in `.csv`, `fd:N`, or `dds[:DOMAIN]` with a "
           "domain from 0 to 232",
           "policy, zero, random, FILE.csv, or another process: dds[:DOMAIN], or fd:N, at the "
           "other end of socket N",
           set_agent},
    Option{"--agent-timeout", "S", "a number from 0.001 to 1000000",
           "end the run after S seconds without an action of `--agent dds` (10)",
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
           "add the scenes of the graph's `render:`, for playback in `eagerx-gen report`",
           set_trace_scenes},
    Option{"--replay", "LOG", "a file name", "repeat the run of a trace and compare the messages",
           set_replay},
    Option{"--replay-given", "LIST", "names between commas",
           "messages to take from LOG: actions, sensors, none or channels (actions,sensors)",
           set_replay_given},
    Option{"--identify", "LOG", "a file name", "estimate parameters and delays from a trace",
           set_identify},
    Option{"--identify-out", "FILE", "a file name", "write the result as YAML for the graph",
           set_identify_out},
    Option{"--identify-sensors", "LIST", "names between commas", "channels to fit (all sensors)",
           set_identify_sensors},
    Option{"--identify-horizon", "S", "seconds from 0.000001 to 1000000",
           "length of the pieces of the trace, each with its own initial state (0.5)",
           set_identify_horizon},
    Option{"--identify-delay", "S", "seconds from 0 to 10",
           "longest actuator delay to consider (0.1)", set_identify_delay},
    Option{"--hash", "", "", "print the hash of the trace of all episodes", set_hash},
    Option{"--real-time-factor", "X", "0 or a number from 0.000001 to 1000000",
           "simulated seconds a second; 0: as fast as possible", set_real_time_factor},
    Option{"--render", "TO",
           "`window`, a film, pictures such as `frames/%04d.png`, `hash` or `asked`",
           "draw the graph's `render:` to a window, FILM.mp4, frames/%04d.png, hash, or asked "
           "(pictures that the agent requests)",
           set_render},
    Option{"--size", "WxH", "such as `480x480`, from 16x16 to 4096x4096",
           "size of the pictures in pixels (480x480)", set_size},
    Option{"--publish", "KIND",
           "`foxglove:[HOST:]PORT`, `udp:HOST:PORT`, `teleplot:HOST:PORT`, `mcap:FILE`, or "
           "`dds[:DOMAIN][@INTERFACE]` with a domain from 0 to 232",
           "publish messages during the run: foxglove:[HOST:]PORT, udp:HOST:PORT (PlotJuggler), "
           "teleplot:HOST:PORT, mcap:FILE or dds[:DOMAIN][@INTERFACE] (ROS 2); may be repeated",
           set_publish},
    Option{"--publish-only", "CHANNEL", "the name of a channel, such as `pendulum/theta`",
           "publish only this channel of the trace (all); may be repeated", set_publish_only},
    Option{"--publish-rate", "HZ", "a number from 0.000001 to 1000000000",
           "publish at most HZ messages of a channel per simulated second", set_publish_rate},
    Option{"--publish-key", "FILE", "a file name",
           "clients with the key in FILE may change the run over foxglove:", set_publish_key},
    Option{"--link", "[PART=]LINE", "a serial line, HOST:PORT or unix:PATH",
           "line to the board or to a part: a serial line, HOST:PORT or unix:PATH; may be repeated",
           set_link, true},
    Option{"--key", "[PART=]FILE", "a file that `eagerx-gen key new` wrote",
           "key of TCP lines, or of the line to PART; TCP to other machines needs one; may be "
           "repeated",
           set_key, true},
    Option{"--baud", "N", "a whole number from 1 to 4294967295", "speed of a serial line", set_baud,
           true},
    Option{"--link-timeout", "S", "a number from 0 to 1000000",
           "end the run after S seconds without an answer of a part", set_link_timeout, true},
    Option{"--reconnect", "S", "a number from 0.001 to 1000000",
           "wait S seconds for a lost part, and continue with the next episode", set_reconnect,
           true},
    Option{
        "--lockstep", "", "",
        "wait for each message of a part at the time it is sent, without using the slack of delays",
        set_lockstep, true},
    Option{"--set", "STATE=VALUE", "such as `pendulum.mass=0.1` or `pendulum.mass=uniform:0.1,0.2`",
           "value of a state at each reset, or its distribution, such as uniform:LOW,HIGH; with "
           "VALUE@STEP, of a tunable parameter from that step on; may be repeated",
           set_state},
    Option{"--fault", "NAME=KIND@STEP", "such as `angle=silent@40` or `angle[0]=offset:0.1@40+5`",
           "disturb an observation or an action from a step on, with +STEPS for N steps: silent, "
           "nan, offset:X or value:X; may be repeated",
           set_fault},
    Option{"--until", "CONDITION", "a condition such as `abs(pendulum.theta) > 1`",
           "end an episode after the first step at which the condition holds", set_until},
    Option{"--measure", "NUMBER", "an expression such as `abs(pendulum.theta)`",
           "print mean, standard deviation and worst value of an expression over all steps; may be "
           "repeated",
           set_measure},
    Option{"--summary", "", "",
           "print mean, standard deviation, minimum and maximum over all episodes", set_summary},
    Option{"--strict-spaces", "", "", "end the run at the first message outside its space",
           set_strict_spaces},
    Option{"--self-test", "", "", "only compare the policy's answers with known answers",
           set_self_test},
    Option{"--quiet", "", "", "print no summary and no progress bar", set_quiet},
    Option{"--help", "", "", "print this text", set_help},
    Option{"--version", "", "", "print graph, engine and version", set_version},
};

}  // namespace

std::span<const Option> all_options() {
  return kOptions;
}

}  // namespace eagerx::linux_sim
