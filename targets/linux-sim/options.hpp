// The command line of a linux-sim program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <targets/common/run.hpp>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/publish/destination.hpp>
#include <variant>
#include <vector>

namespace eagerx::linux_sim {

/// Exit codes, the same numbers as eagerx-gen's.
inline constexpr int kDone = 0;
inline constexpr int kBadActions = 1;
inline constexpr int kSelfTestFailed = 1;
inline constexpr int kDiverged = 1;
inline constexpr int kLeftSpace = 1;
inline constexpr int kNotFinite = 1;
inline constexpr int kBadUsage = 2;
inline constexpr int kBadFile = 3;

inline constexpr std::uint32_t kDefaultBaud = 115'200;

// Of `--reconnect`, in seconds.
inline constexpr double kLeastReconnectS = 0.001, kMostReconnectS = 1e6;

/// The values of `--render` and `--size`.
struct Rendering {
  std::string to;  // `window`, `hash`, a film or files; empty: nothing is shown
  int width = 480, height = 480;
};

struct Options {
  target::RunPlan plan;
  target::Agent agent = target::Agent::zero;
  bool self_test = false;
  std::string action_file;         // of Agent::csv
  std::uint32_t agent_domain = 0;  // of kDdsAgent
  double agent_timeout_s = 10.0;   // the same
  int agent_socket = -1;           // of kExternalAgent
  std::string csv;                 // empty: none; "-": standard output
  std::string trace;               // the same
  bool trace_time = false, trace_scenes = false;
  std::string replay;  // a log; empty: none
  std::string replay_given = "actions,sensors";
  std::string identify;          // a log; empty: none
  std::string identify_out;      // empty: standard output
  std::string identify_sensors;  // empty: all
  double identify_horizon_s = 0.5;
  double identify_delay_s = 0.1;
  double real_time_factor = 0.0;
  bool real_time_given = false;
  Rendering rendering;
  std::vector<Destination> publish;
  std::vector<std::string> publish_only;  // channels; empty: all
  double publish_rate_hz = 0.0;           // at most; 0: as they are
  std::string publish_key;                // a file; empty: none
  bool split = false;  // whether a part of the graph runs elsewhere: the next five exist
  std::vector<std::string> links;  // `PART=LINE`; of one part LINE alone
  std::vector<std::string> keys;   // `PART=FILE`, or FILE for all TCP lines
  std::uint32_t baud = kDefaultBaud;
  double link_timeout_s = 5.0;
  double reconnect_s = 0.0;  // how long a part that is lost is waited for; 0: not
  bool lockstep = false;     // with parts, also where delays would let the program continue
  bool strict_spaces = false;
  bool csv_states = false;
  std::string until;  // a condition; empty: none
  std::vector<std::string> measures;
  bool summary = false;
  std::vector<std::string> settings;  // of states: NAME=VALUE
  std::vector<std::string> faults;    // of what the agent sees and gives
  bool hash = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

/// The agent, as `--agent` has it.
std::string_view agent_name(const Options& options);

/// The problem of the command line, and its fix.
struct UsageError {
  std::string problem;
  std::string help;
};

/// Reads the arguments after the program's name on top of `defaults`. Later ones win.
std::variant<Options, UsageError> parse_options(int count, const char* const* arguments,
                                                Options defaults);

/// The lines of `--help` about options, exit codes and files.
std::string options_help(const Options& defaults);

}  // namespace eagerx::linux_sim
