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
        "how long the last good output stays first, in seconds, or `always` (default 0)"},
       {"ramp", number, false,
        "largest change a second on the way to the safe value and back (default: at once)"},
       {"low", values, false, "what leaves is never less (default: the bound of its space)"},
       {"high", values, false, "what leaves is never more (default: the bound of its space)"}});
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
        "graphs without an engine: what leaves as an observation while a measurement is missing, "
        "not finite or late; `none`: nothing acts on it (default: zero, moved into its space)"},
       {"frozen", format::map("frozen", format::integer("a number of steps", 2, kMost)), false,
        "graphs without an engine: number of steps in a row for which an action, which is a "
        "measurement, may have exactly the same value before safe outputs take over (default: for "
        "ever)"},
       {"nodes", format::keyword({"reset", "hold"}), false,
        "graphs without an engine: what the nodes do when a safe output is over. reset: they begin "
        "as after a reset; hold: they continue from where they stopped (default reset)"},
       {"late", count, false,
        "number of instants in a row later than `max_lateness` after which the safe action "
        "takes over (default 1)"},
       {"max_lateness", time, false,
        "how many seconds late an instant may be in real time (default 0: one period)"},
       {"missed", count, false,
        "number of instants in a row without a valid value of a sensor after which the safe "
        "action takes over (default 2)"},
       {"recover", format::integer("a number of instants", 0, kMost), false,
        "number of good instants in a row after which the agent is back; 0: in the next episode "
        "(default 3)"},
       {"limits", format::keyword({"clip", "safe"}), false,
        "clip: an action outside of its space is moved into it; safe: the safe action takes over "
        "(default clip)"},
       {"not_finite", format::keyword({"safe", "hold"}), false,
        "after a NaN or an infinite number in an action or in the observation before it. safe: the "
        "safe action takes over; hold: first the last good action is repeated for `missed` - 1 "
        "instants in a row (default safe)"},
       {"link_timeout", time, false,
        "longest time that a link may take to answer, in seconds (default 0.01)"},
       {"heartbeat_timeout", time, false,
        "seconds without a heartbeat of a program for Linux that drives real hardware after which "
        "another process kills it and applies the safe values; 0: never (default 0.5)"}});
}

}  // namespace eagerx::gen
