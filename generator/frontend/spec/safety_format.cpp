// The table of `safety:` in the graph file.
#include "generator/frontend/spec/graph_spec.hpp"

namespace eagerx::gen {

const std::vector<SafetyDefault>& safety_defaults() {
  static const std::vector<SafetyDefault> kDefaults = {
      {"late", ComputedNumber(std::int64_t{1})},
      {"max_lateness", ComputedNumber(std::int64_t{0})},
      {"missed", ComputedNumber(std::int64_t{2})},
      {"recover", ComputedNumber(std::int64_t{3})},
      {"limits", "clip"},
      {"not_finite", "safe"},
      {"link_timeout", ComputedNumber(0.01)},
      {"heartbeat_timeout", ComputedNumber(0.5)},
      {"nodes", "reset"}};
  return kDefaults;
}

namespace {

/// The safe value of an output: `0.0`, `none`, or all that can be said of it.
FormatPtr safe_output_format(const FormatPtr& values) {
  const FormatPtr number = format::number("a number");
  const FormatPtr hold =
      format::one_of("a time in seconds, or `always`",
                     {format::time("a time in seconds"), format::keyword({"always"})});
  const FormatPtr settings = format::record(
      "safety.outputs",
      {{"value", values, false, "the safe value (default: zero, moved into the limits)"},
       {"hold", hold, false,
        "seconds for which the last good output stays first, or `always` (default 0)"},
       {"ramp", number, false,
        "maximum change per second to the safe value and back (default: at once)"},
       {"low", values, false, "lower limit of the output (default: the bound of its space)"},
       {"high", values, false, "upper limit of the output (default: the bound of its space)"}});
  return format::one_of(
      "a safe value, `none`, or a mapping such as `{value: 0.0, ramp: 10}`",
      {format::list("a list of numbers", number, 1), number, format::keyword({"none"}), settings});
}

}  // namespace

FormatPtr safety_format() {
  constexpr double kMost = 1'000'000;
  const FormatPtr count = format::integer("a number of instants", 1, kMost);
  const FormatPtr time = format::time("a time in seconds");
  const FormatPtr values =
      format::one_of("a number, or a list with one number for each element",
                     {format::list("a list of numbers", format::number("a number"), 1),
                      format::number("a number")});
  Format actuators = *format::file_map("actuators");  // their names have a dot: object.actuator
  actuators.item = values;
  return format::record(
      "safety",
      {{"actions", format::map("actions", values), false,
        "safe value of each action (default: zero, moved into its space)"},
       {"actuators", std::make_shared<const Format>(std::move(actuators)), false,
        "safe value of each `object.actuator` of real hardware (default: the safe value of the "
        "action that is connected to it, else zero, moved into its space)"},
       {"outputs",
        format::one_of(
            "`none`, or a mapping from observations to safe values",
            {format::map("outputs", safe_output_format(values)), format::keyword({"none"})}),
        false,
        "graphs without an engine: value of an observation while a measurement is missing, not "
        "finite or late; `none`: no actuator uses it (default: zero, moved into its space)"},
       {"frozen", format::map("frozen", format::integer("a number of steps", 2, kMost)), false,
        "graphs without an engine: consecutive steps with exactly the same value of an action, "
        "which is a measurement, before safe outputs take over (default: unlimited)"},
       {"nodes", format::keyword({"reset", "hold"}), false,
        "graphs without an engine: nodes after a safe output. reset: they start as after a reset; "
        "hold: they continue where they stopped (default reset)"},
       {"late", count, false,
        "consecutive instants later than `max_lateness` before the safe action takes over (default "
        "1)"},
       {"max_lateness", time, false,
        "maximum lateness of an instant in real time, in seconds (default 0: one period)"},
       {"missed", count, false,
        "consecutive instants without a valid value of a sensor before the safe action takes over "
        "(default 2)"},
       {"recover", format::integer("a number of instants", 0, kMost), false,
        "consecutive good instants before the agent is back; 0: in the next episode (default 3)"},
       {"limits", format::keyword({"clip", "safe"}), false,
        "action out of its space. clip: it is moved into its space; safe: the safe action takes "
        "over (default clip)"},
       {"not_finite", format::keyword({"safe", "hold"}), false,
        "NaN or infinity in an action or in the observation before it. safe: the safe action takes "
        "over; hold: first the last good action is repeated for `missed` - 1 instants (default "
        "safe)"},
       {"link_timeout", time, false, "maximum time of a link to answer, in seconds (default 0.01)"},
       {"heartbeat_timeout", time, false,
        "programs for Linux that drive real hardware: seconds without a heartbeat before another "
        "process kills the program and applies the safe values; 0: never (default 0.5)"}});
}

}  // namespace eagerx::gen
