// eagerx-gen trace and plot: convert a log for other tools, and plot it.
#include "generator/tools/trace/trace.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "generator/driver/build/write.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/tools/campaign/plot.hpp"
#include "generator/tools/commands/tool_commands.hpp"
#include "generator/tools/page/units.hpp"

namespace eagerx::gen {
namespace {

/// A log, and the file that is made of it.
struct LogOptions : MessageOptions {
  std::string log, output;
};

struct PlotOptions : LogOptions {
  std::vector<std::string> channels;     // of a campaign: another table
  GraphOptions graph;                    // that has the units; its file may be empty
  std::optional<std::uint64_t> episode;  // without: all
};

int finish(const LogOptions& options, const TraceResult& result) {
  if (!result.problem.empty()) complain("{}\n", result.problem);
  if (!result.note.empty() && !options.quiet) complain("note: {}\n", result.note);
  if (!result.problem.empty()) return result.readable ? kProblems : kInputOutput;
  if (options.output == "-") {
    say_text(result.bytes);
    return kDone;
  }
  Run run;
  if (write_file(options.output, result.bytes, run.diagnostics) && !options.quiet)
    say("{}: {}\n", options.output, result.summary);
  return gen::finish(run, options);
}

/// Characters of a line, and whether they may be others than ASCII.
std::size_t columns_of_terminal() {
  constexpr std::size_t kColumns = 80, kMost = 200;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kColumns;
  return std::min<std::size_t>(size.ws_col, kMost);
}
bool has_braille() {
  for (const char* const name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* const value = std::getenv(name);
    if (value == nullptr || *value == 0) continue;
    const std::string_view text(value);
    return text.find("UTF-8") != std::string_view::npos ||
           text.find("utf8") != std::string_view::npos;
  }
  return false;
}

int perform(const LogOptions& options) {
  return finish(options, convert_log(options.log, *trace_format_of(options.output)));
}

bool is_table(const std::string& path) {
  return path.ends_with(".csv");
}

/// Units and names of the channels of the graph.
void ask_graph(Run& run, const GraphOptions& options, PlotRequest& request) {
  if (options.graph.empty() || !make(run, options)) return;
  for (const GraphNode& node : run.graph->nodes) {
    for (const Output& output : node.outputs) {
      const std::string channel = node.name + "/" + output.name;
      request.units[channel] = unit_of(*run.graph, node, output);
      for (const std::string& port : node.ports_of(output))
        request.ports.push_back({port, channel});
      for (const std::string& port : run.graph->aliases_of(node, output))
        request.ports.push_back({port, channel});
    }
  }
}

int perform(const PlotOptions& options) {
  if (is_table(options.log)) {
    std::vector<std::string> tables = {options.log};
    tables.insert(tables.end(), options.channels.begin(), options.channels.end());
    return finish(options, campaign::plot_campaigns(tables));
  }
  Run run;
  PlotRequest request{options.log, options.channels, {}};
  ask_graph(run, options.graph, request);
  if (run.diagnostics.has_errors()) return gen::finish(run, options);
  if (options.episode) request.episode = static_cast<std::uint32_t>(*options.episode);
  return finish(options, options.output == "-"
                             ? plot_log_as_text(request, columns_of_terminal(), has_braille())
                             : plot_log_as_svg(request));
}

Command table(LogOptions& options) {
  Argument output = checked(
      required(writes(text("-o,--output", options.output,
                           "file to write, whose ending selects the format: .csv, .json (Perfetto, "
                           "chrome://tracing), .mcap (Foxglove) or .npz (NumPy)",
                           "FILE"))),
      [](const std::string& path) { return trace_format_of(path).has_value(); },
      "ends in none of .csv, .json, .mcap, .npz");
  return {.name = "convert",
          .about = "convert a trace to CSV, or for NumPy, Foxglove or Perfetto",
          .examples = {{"a table with a row for each instant",
                        "eagerx-gen trace convert run.log -o run.csv"},
                       {"for Foxglove", "eagerx-gen trace convert run.log -o run.mcap"}},
          .arguments = {required(reads(text("log", options.log,
                                            "trace, which a program writes with --trace", "LOG"))),
                        std::move(output), quiet(options)},
          .run = [&options] { return perform(options); }};
}

std::string check(const PlotOptions& options) {
  if (!is_table(options.log))
    return options.channels.empty() ? "name at least one channel of the log" : "";
  if (options.channels.size() > 1 ||
      (options.channels.size() == 1 && !is_table(options.channels.front())))
    return "after the table of a campaign there may be one other, to be compared with it; channels "
           "of a run are in the log that it writes with --trace";
  if (options.output == "-") return "a campaign is drawn as a picture: -o FILE.svg";
  return options.episode ? "--episode is for logs" : "";
}

Command table(PlotOptions& options) {
  constexpr std::uint64_t kLastEpisode = 999'999'999;
  Argument output = checked(
      required(writes(text("-o,--output", options.output,
                           "picture to write (.svg), or - to plot in the terminal", "FILE"))),
      [](const std::string& path) { return path == "-" || path.ends_with(".svg"); },
      "is neither .svg nor -");
  return {
      .name = "plot",
      .about = "plot channels of a trace over time, or the runs of a campaign",
      .examples = {{"a picture", "eagerx-gen plot run.log theta voltage -o run.svg"},
                   {"with units at the axes",
                    "eagerx-gen plot run.log theta --graph pendulum.yaml -o run.svg"},
                   {"in the terminal", "eagerx-gen plot run.log theta -o -"},
                   {"returns of a campaign, and success over the varied states",
                    "eagerx-gen plot runs.csv -o runs.svg"},
                   {"two variants, run by run", "eagerx-gen plot plain.csv fast.csv -o both.svg"}},
      .arguments = {required(reads(text("log", options.log,
                                        "trace, or a table written with `campaign --csv`",
                                        "LOG|RUNS.csv"))),
                    reads(texts("channel", options.channels,
                                "channels to plot: names or unique parts of names; theta,goal for "
                                "one plot, pose[3] for one element. For a campaign: table of "
                                "another campaign with the same --seed, to compare with",
                                "CHANNEL|RUNS.csv")),
                    std::move(output),
                    reads(text("--graph", options.graph.graph,
                               "graph to take units and names of channels from", "GRAPH.yaml")),
                    variant(options.graph), library(options.graph),
                    whole("--episode", options.episode, "plot only this episode, counted from 0", 0,
                          kLastEpisode),
                    quiet(options)},
      .check = [&options] { return check(options); },
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command trace_command() {
  return {
      .name = "trace",
      .about = "convert traces, which programs write with --trace, for other tools",
      .examples = {{"convert a trace for NumPy", "eagerx-gen trace convert run.log -o run.npz"}},
      .commands = {with_options<LogOptions>(table)}};
}

Command plot_command() {
  return with_options<PlotOptions>(table);
}

}  // namespace eagerx::gen
