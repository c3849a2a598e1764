// eagerx-gen monitor: shows the messages of a running program.
#include "generator/tools/monitor/monitor.hpp"

#include <cstdlib>
#include <optional>
#include <utility>

#include "generator/driver/build/built.hpp"
#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/support/files/files.hpp"
#include "generator/tools/commands/tool_commands.hpp"

namespace eagerx::gen {
namespace {

struct MonitorCommandOptions : GraphOptions {  // the graph empty: only what the stream says
  MonitorOptions monitor;
  std::string layout;  // a file; empty: the graph's
};

Argument seconds(std::string name, double& value, std::string about) {
  return checked(
      {std::move(name), std::move(about), "S",
       [&value](const auto& values) { value = std::strtod(values.front().c_str(), nullptr); }},
      [](const std::string& text) {
        char* end = nullptr;
        const double number = std::strtod(text.c_str(), &end);
        return !text.empty() && *end == '\0' && number > 0.0 && number < 1e9;
      },
      "is not a number of seconds above 0");
}

/// The text of the file, or nothing; then the reason has been printed.
std::optional<std::string> read_layout(const std::string& path) {
  constexpr std::size_t kMostBytes = 1 << 20;
  LoadedFile file = load_file(path, kMostBytes);
  if (file.status == LoadedFile::Status::loaded) return std::move(file.bytes);
  complain("error: cannot read `{}`: {}\n", path,
           file.status == LoadedFile::Status::too_large ? "it is too large" : file.reason);
  return std::nullopt;
}

int perform(const MonitorCommandOptions& options) {
  MonitorOptions monitor = options.monitor;
  if (!options.layout.empty()) {
    const auto layout = read_layout(options.layout);
    if (!layout) return kInputOutput;
    monitor.layout = *layout;
  }
  constexpr std::string_view kSerial = "serial:";
  if (monitor.source.starts_with(kSerial))
    remember_input(monitor.source.substr(kSerial.size()), monitor.source);
  Run run;
  if (options.graph.empty()) {
    const bool may_write = are_different({}, {}, run.diagnostics);
    return may_write ? watch(monitor, nullptr) : finish(run, options);
  }
  auto facts = make(run, options) ? facts_of_program(run, options) : std::nullopt;
  if (facts && !are_different({}, {}, run.diagnostics)) facts.reset();
  const int code = finish(run, options);
  if (!facts || code != kDone) return code;
  if (monitor.layout.empty()) monitor.layout = facts->telemetry;
  const WatchedGraph graph{&*run.plan, options.graph, facts->hash};
  return watch(monitor, &graph);
}

Command table(MonitorCommandOptions& options) {
  MonitorOptions& monitor = options.monitor;
  Argument record = checked(writes(text("--record", monitor.record,
                                        "also record the messages in a file, .mcap (Foxglove) or, "
                                        "from a trace or a board, .trace",
                                        "FILE")),
                            is_recording, "ends in none of .mcap, .trace, .log");
  Argument forward = checked(
      texts(
          "--forward", monitor.forward,
          "also forward the messages to udp:HOST:PORT (PlotJuggler), teleplot:HOST:PORT, "
          "foxglove:[HOST:]PORT (Foxglove connects there) or dds[:DOMAIN] (ROS 2); may be repeated",
          "KIND"),
      is_destination,
      "is none of udp:HOST:PORT, teleplot:HOST:PORT, foxglove:[HOST:]PORT, dds[:DOMAIN]");
  return {.name = "monitor",
          .about = "show the messages of a running program in the terminal",
          .examples = {{"a program that runs with --publish udp:127.0.0.1:9870",
                        "eagerx-gen monitor udp:9870 --graph pendulum.yaml"},
                       {"the telemetry of a board",
                        "eagerx-gen monitor serial:/dev/ttyUSB0 --graph pendulum.yaml"},
                       {"a growing trace", "eagerx-gen monitor run.log"},
                       {"record for Foxglove, too",
                        "eagerx-gen monitor udp:9870 --graph pendulum.yaml --record run.mcap"},
                       {"a board's telemetry in Foxglove",
                        "eagerx-gen monitor serial:/dev/ttyUSB0 --graph pendulum.yaml --forward "
                        "foxglove:8765"},
                       {"print once, for a script", "eagerx-gen monitor udp:9870 --once"}},
          .arguments = joined(
              {{required(reads(
                    text("source", monitor.source,
                         "source of the messages: udp:[HOST:]PORT, foxglove:[HOST:]PORT, "
                         "serial:DEVICE, or a file that may grow, a trace or a recording (.mcap)",
                         "SOURCE"))),
                reads(text("--graph", options.graph,
                           "graph of the program, for planned rates, limits and safe actions; "
                           "messages of other graphs are refused",
                           "GRAPH.yaml")),
                reads(text(
                    "--layout", options.layout,
                    "file telemetry.json next to a board's program, which describes its messages",
                    "FILE")),
                flag("--once", monitor.once, "print one table as lines, then exit"),
                flag("--lines", monitor.lines,
                     "print tables as lines instead of a screen, as for a pipe"),
                std::move(record), std::move(forward),
                seconds("--every", monitor.every_s, "seconds between tables (default: 1)"),
                seconds("--timeout", monitor.timeout_s,
                        "seconds to wait for a message before exiting (default: 10)")},
               selection(options),
               rates(options),
               {agent_policy(options), library(options)},
               diagnostics(options)}),
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command monitor_command() {
  return with_options<MonitorCommandOptions>(table);
}

}  // namespace eagerx::gen
