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
               "an age limit",
               {{"from", format::port("`object.sensor` or `actions.NAME`"), false,
                 "source of the data (default: every sensor; without an engine every action)"},
                {"to", format::port("`object.actuator` or `observations.NAME`"), false,
                 "destination of the data (default: every actuator; without an engine every "
                 "observation)"},
                {"at_most", format::time("a time in seconds", true), true,
                 "maximum age, in seconds, of the newest data of `from` at `to`"},
                {"agent", format::boolean(), false,
                 "false: ignore paths through the agent (default true)"}}),
           1)});
}

FormatPtr above_zero(const char* what, Quantity quantity, std::optional<double> high = {}) {
  Format format = *format::decimal(what, 0.0, true);
  format.quantity = quantity;
  format.high = high;
  return std::make_shared<const Format>(std::move(format));
}

FormatPtr margin_format() {
  const FormatPtr one = format::record(
      "a margin of a loop",
      {{"at", format::port("a port such as `controller.u` or `motor.y[2]`"), true,
        "where the loop is opened"},
       {"phase", above_zero("a phase margin in degrees", Quantity::angle, 180.0), false,
        "smallest phase margin, in degrees"},
       {"gain", above_zero("a gain margin in dB", Quantity::gain), false,
        "smallest gain margin in dB, up and down"},
       {"delay", format::time("a time in seconds", true), false,
        "smallest delay margin, in seconds"},
       {"corners", format::boolean(), false,
        "at all combinations of the ends of sampled parameters (default false)"},
       {"trim", format::boolean(), false,
        "linearize at the operating point that `eagerx-gen trim` finds (default false)"}});
  return format::one_of("a margin `{at: …, phase: …, gain: …, delay: …}`, or a list of them",
                        {one, format::list("a list of margins", one, 1)});
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
        true, "sensors, outputs of nodes and actions to send"},
       {"share", std::make_shared<const Format>(std::move(share)), false,
        "share of the line's bandwidth to use (default 0.5)"},
       {"rate", format::rate(), false,
        "maximum messages per second of a channel (default: as many as fit)"},
       {"baud", format::integer("a baud rate", 1, kMostBaud), false,
        "speed of the board's serial port, which its manifest must list (default 115200)"}});
}

FormatPtr budget_format() {
  const FormatPtr bytes = format::memory("a number of bytes, such as 64k");
  const FormatPtr part =
      format::record("a budget of memory", {{"flash", bytes, false, "bytes of code and constants"},
                                            {"ram", bytes, false, "bytes besides the stack"}});
  Format nodes = *format::file_map("nodes");  // engine nodes have names such as object/node
  nodes.item = part;
  return format::record(
      "the budget",
      {{"flash", bytes, false, "bytes of code and constants of the image"},
       {"ram", bytes, false, "bytes of memory besides the stack"},
       {"stack", bytes, false, "bytes of stack"},
       {"instructions", format::integer("a number of instructions", 0), false,
        "maximum instructions of a slot, including the agent"},
       {"time", format::fraction("a share of the time, such as `80 %`"), false,
        "maximum share of the time until the next slot that a slot of a board may take, by the "
        "bound of its cycles"},
       {"slot", format::time("a time in seconds", true), false,
        "maximum time of a slot of a board, by the bound of its cycles, including the agent"},
       {"age", age_format(), false,
        "maximum age, in seconds, of the newest data of a sensor at an actuator (without an "
        "engine: of an action in an observation), for all pairs or for each"},
       {"link", format::integer("a baud rate", 1), false,
        "baud rate of a serial link between the engine and the rest"},
       {"parts", format::integer("a baud rate", 1), false,
        "baud rate of the serial line to each part of `placement:`"},
       {"telemetry", format::integer("a baud rate", 1), false,
        "baud rate that `telemetry:` may use of its line"},
       {"margin", margin_format(), false,
        "stability margins of the sampled loop, which `build` and `run` check"},
       {"nodes", std::make_shared<const Format>(std::move(nodes)), false,
        "budgets of nodes, by their names"}});
}

}  // namespace eagerx::gen
