// The commands of eagerx-gen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/command_line/command_line.hpp"
#include "generator/command_line/output.hpp"
#include "generator/monitor/monitor.hpp"
#include "generator/read/rational.hpp"

namespace eagerx::gen {

/// What a graph is made for.
enum class Purpose : std::uint8_t {
  program,
  training,    // the whole graph, whatever its agent is
  campaign,    // the whole graph, with its agent
  simulation,  // the whole graph, with whatever agent
  recording,   // the whole graph, with its agent, for a library that is cut out of it
};

/// A weight file, and what is said besides it.
struct PolicyFile {
  std::string file;  // as the user wrote it
  std::string normalize, activation, output_activation, output_name, actor;
};

struct Options {
  std::string graph;
  std::string output;                               // empty: generated/<name of the graph>
  std::vector<std::string> targets;                 // empty: linux-sim
  std::string variant;                              // empty: the graph as it is written
  std::string engine, real;                         // empty: the graph's
  std::vector<std::string> split;                   // NAMES=BOARD; empty: the graph's placement
  std::vector<std::string> of;                      // nodes that are cut out; empty: all
  std::optional<Rational> engine_rate_hz, rate_hz;  // without: the graph's
  std::vector<std::string> paths;  // folders of the user's own entities and targets
  std::string depfile;
  std::vector<std::string> packages;         // kinds of packages that the output is to be as well
  bool library = false;                      // headers for a main loop of one's own, no program
  bool compile = false;                      // check: also the code of entities
  bool standalone = false;                   // the output has all headers it needs
  std::vector<std::string> program_options;  // run
  Purpose purpose = Purpose::program;
  std::string agent_policy;                            // a weight file; empty: the graph's agent
  std::string image, build, baseline, run_on;          // size
  bool graph_schema = false, manifest_schema = false;  // schema
  bool json_output = false;
  std::string program, log, second_log, given;      // replay, identify
  std::string sensors, horizon_s, longest_delay_s;  // identify
  std::vector<std::string> channels;                // plot
  std::string episode;                              // plot
  std::string second_graph, second_variant;         // diff
  std::string entity;                               // info, new
  bool flat = false;                                // info
  std::string kind;                                 // new
  std::string code;                                 // explain
  bool missing = false;                             // import
  bool engine_graph = false;                        // graph
  std::vector<std::string> logs, images;            // report
  std::size_t points = 0;                           // report; 0: as many as fit
  bool simulate = false;                            // report
  std::string live;                                 // report; empty: a file
  PolicyFile policy, second_policy;                 // policy
  std::string golden, observations;                 // policy
  std::size_t rows = 0;                             // policy; 0: not said
  std::optional<std::uint32_t> seed;                // policy
  std::optional<double> tolerance;                  // policy
  bool int8 = false, said_too_often = false;        // policy
  MonitorOptions monitor;                           // monitor
  std::string layout;                               // monitor
  bool json = false;                                // --diagnostics=json
  bool quiet = false;
  bool warnings_as_errors = false;
};

int generate_command(const Options& options);
/// The same, and builds the programs; prints their files.
int build_command(const Options& options);
/// The same, and becomes the program, or the emulator with it: its exit code is the command's.
int run_command(const Options& options);
/// Makes the graph's library of environments, and becomes the trainer with it.
int train_command(const Options& options);
/// Makes the graph's library of environments, and becomes the program that runs many episodes.
int campaign_command(const Options& options);
int check_command(const Options& options);
/// Prints how two graphs, or two variants of one, differ; kProblems if they do.
int diff_command(const Options& options);
int import_command(const Options& options);
int info_command(const Options& options);
/// Writes a picture of the graph.
int graph_command(const Options& options);
/// Writes a page for a browser.
int report_command(const Options& options);
int explain_command(const Options& options);
int schema_command(const Options& options);
int size_command(const Options& options);
int replay_command(const Options& options);
int identify_command(const Options& options);
int new_command(const Options& options);
int policy_command(const Options& options);
/// Writes observations with a policy's answers.
int policy_golden_command(const Options& options);
/// How far the answers of two policies are apart.
int policy_compare_command(const Options& options);
/// Steps a library that is cut out of a graph with what a simulation recorded, and compares.
int pil_command(const Options& options);
/// What these take.
Command policy_commands(Options& options);
/// Writes a log in the form of other tools.
int trace_command(const Options& options);
/// Draws channels of a log.
int plot_command(const Options& options);
/// Watches the messages of a program.
int monitor_command(const Options& options);
/// What these take.
Command generate_commands(Options& options);
Command build_commands(Options& options);
Command run_commands(Options& options);
Command train_commands(Options& options);
Command pil_commands(Options& options);
Command campaign_commands(Options& options);
Command trace_commands(Options& options);
Command plot_commands(Options& options);
Command monitor_commands(Options& options);
Command report_commands(Options& options);
Command docs_commands();
/// Writes `pages` below the folder `output`.
int pages_command(const Options& options, const std::vector<CommandLinePage>& pages);

}  // namespace eagerx::gen
