// eagerx-gen monitor: what a program sends while it runs.
#include "generator/monitor/monitor.hpp"

#include <cstdlib>
#include <utility>

#include "generator/cli/arguments.hpp"
#include "generator/cli/built.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"

namespace eagerx::gen {
namespace {

Argument seconds(std::string name, double& value, std::string about) {
  Argument argument{std::move(name), std::move(about), "S", [&value](const auto& values) {
                      value = std::strtod(values.front().c_str(), nullptr);
                    }};
  argument.check = [](const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    const bool is_right = !text.empty() && *end == '\0' && number > 0.0 && number < 1e9;
    return is_right ? std::string() : text + " is not a number of seconds above 0";
  };
  return argument;
}

}  // namespace

int monitor_command(const Options& options) {
  if (options.graph.empty()) return watch(options.monitor, nullptr);
  Run run;
  auto hash = make(run, options) ? graph_hash(run, options) : std::nullopt;
  if (hash && !are_different({}, {}, run.diagnostics)) hash.reset();
  const int code = finish(run, options);
  if (!hash || code != kDone) return code;
  const WatchedGraph graph{&*run.plan, options.graph, *hash};
  return watch(options.monitor, &graph);
}

Command monitor_commands(Options& options) {
  MonitorOptions& monitor = options.monitor;
  Argument record = writes(text("--record", monitor.record,
                                "also write the messages into a file .mcap (Foxglove), or of a "
                                "source with all messages .trace",
                                "FILE"));
  record.check = [](const std::string& path) {
    return is_recording(path) ? std::string() : path + " ends in none of .mcap, .trace, .log";
  };
  Argument forward = texts("--forward", monitor.forward,
                           "also send the messages on: udp:HOST:PORT (PlotJuggler) or "
                           "teleplot:HOST:PORT; may be repeated",
                           "KIND");
  forward.check = [](const std::string& to) {
    return is_destination(to) ? std::string()
                              : to + " is neither udp:HOST:PORT nor teleplot:HOST:PORT";
  };
  return {
      .name = "monitor",
      .about = "watch the messages of a program while it runs",
      .examples = {{"what a program sends that was started with --publish udp:127.0.0.1:9870",
                    "eagerx-gen monitor udp:9870 --graph pendulum.yaml"},
                   {"a trace that grows", "eagerx-gen monitor run.log"},
                   {"and recorded for Foxglove",
                    "eagerx-gen monitor udp:9870 --graph pendulum.yaml --record run.mcap"},
                   {"once, for a script", "eagerx-gen monitor udp:9870 --once"}},
      .arguments = joined(
          {{required(
                reads(text("source", monitor.source,
                           "udp:[HOST:]PORT, or the file of a trace, which may grow", "SOURCE"))),
            reads(text("--graph", options.graph,
                       "the graph of the program: planned rates, limits, safe actions; the stream "
                       "of another graph is refused",
                       "GRAPH.yaml")),
            flag("--once", monitor.once, "print one table of lines, then end"),
            flag("--lines", monitor.lines,
                 "print tables of lines instead of a screen; so does a pipe"),
            std::move(record), std::move(forward),
            seconds("--every", monitor.every_s,
                    "time between tables, of the first one from the first message on (default: 1)"),
            seconds("--timeout", monitor.timeout_s,
                    "how long to wait for a message before giving up (default: 10)")},
           selection(options),
           rates(options),
           {agent_policy(options), library(options)},
           diagnostics(options)}),
      .run = [&options] { return monitor_command(options); }};
}

}  // namespace eagerx::gen
