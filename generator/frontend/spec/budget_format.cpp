// `telemetry:` and `budget:` of the table of the graph file.
#include "generator/frontend/spec/graph_spec.hpp"

namespace eagerx::gen {
namespace {

FormatPtr age_format() {
  return format::one_of(
      "a time in seconds, or a list of `{from: …, to: …, at_most: …}`",
      {format::time("a time in seconds", true),
       format::list(
           "a list of limits of ages",
           format::record(
               "a limit of an age",
               {{"from", format::port("`object.sensor` or `actions.NAME`"), false,
                 "where data begin (default: every sensor; without an engine every action)"},
                {"to", format::port("`object.actuator` or `observations.NAME`"), false,
                 "where they are used (default: every actuator; without an engine every "
                 "observation)"},
                {"at_most", format::time("a time in seconds", true), true,
                 "largest age, in seconds, of the newest data of `from` at `to`"},
                {"agent", format::boolean(), false,
                 "false: ways through the agent do not count (default true)"}}),
           1)});
}

}  // namespace

FormatPtr telemetry_format() {
  constexpr double kMostBaud = 100'000'000;
  Format share = *format::decimal("a share of the line, above 0 and up to 1", 0.0, true);
  share.high = 1.0;
  return format::record(
      "`telemetry`",
      {{"channels",
        format::list("a list of ports",
                     format::port("a port such as `pendulum.theta` or `actions.voltage`"), 1),
        true, "whose messages a board sends: sensors, outputs of nodes, actions"},
       {"share", std::make_shared<const Format>(std::move(share)), false,
        "how much of the line's bandwidth they may take (default 0.5)"},
       {"rate", format::rate(), false,
        "most messages a second of a channel (default: as many as fit)"},
       {"baud", format::integer("a baud rate", 1, kMostBaud), false,
        "speed of the board's serial port, which its manifest must say, too (default 115200)"}});
}

FormatPtr budget_format() {
  const FormatPtr bytes = format::memory("a number of bytes, such as 64k");
  const FormatPtr part =
      format::record("a budget of memory", {{"flash", bytes, false, "bytes of code and constants"},
                                            {"ram", bytes, false, "bytes besides the stack"}});
  Format nodes = *format::file_map("nodes");  // engine nodes have names such as object/node
  nodes.item = part;
  return format::record("the budget",
                        {{"flash", bytes, false, "bytes of code and constants of the image"},
                         {"ram", bytes, false, "bytes of memory besides the stack"},
                         {"stack", bytes, false, "bytes of stack"},
                         {"instructions", format::integer("a number of instructions", 0), false,
                          "most instructions of a slot, the agent included"},
                         {"age", age_format(), false,
                          "largest age, in seconds, of the newest data of a sensor at an actuator "
                          "(without an engine: of an action in an observation), for all pairs or "
                          "for each"},
                         {"link", format::integer("a baud rate", 1), false,
                          "baud rate of a serial link between the engine and the rest"},
                         {"parts", format::integer("a baud rate", 1), false,
                          "baud rate of the serial line to each part of `placement:`"},
                         {"telemetry", format::integer("a baud rate", 1), false,
                          "how much of its line's baud rate `telemetry:` may take"},
                         {"nodes", std::make_shared<const Format>(std::move(nodes)), false,
                          "budgets of nodes, by their names"}});
}

}  // namespace eagerx::gen
