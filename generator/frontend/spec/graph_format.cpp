// The table of the graph file. The parser, the messages and `eagerx-gen schema` all come from here.
#include "generator/frontend/spec/dtype.hpp"
#include "generator/frontend/spec/graph_spec.hpp"
#include "generator/frontend/spec/misplaced.hpp"

namespace eagerx::gen {
namespace {

FormatPtr number_or_reference(ReferenceRule references) {
  FormatPtr number = format::number("a number");
  if (references == ReferenceRule::refuse) return number;
  return format::one_of("a number or `$(config NAME)`", {number, format::text("`$(config NAME)`")});
}

FormatPtr bound_format(ReferenceRule references) {
  const FormatPtr item = number_or_reference(references);
  return format::one_of("a number, or a list with one number for each element",
                        {format::list("a list of numbers", item, 1), item});
}

/// Keys of a keyboard, and what each does while it is held.
FormatPtr render_keys_format() {
  const FormatPtr number = format::number("a number");
  return format::map(
      "keys",
      format::record(
          "what a key does",
          {{"parameter", format::port("a parameter such as `commands.value`"), true,
            "a parameter under `tunable:` that can change while the graph runs"},
           {"add",
            format::one_of("a number, or a list of numbers",
                           {format::list("a list of numbers", number, 1), number}),
            true, "what it adds, while it is held, to the value that a reset sampled, or to 0"}}));
}

FormatPtr part_format() {
  return format::one_of(
      "a board, or a part such as `{host: camera_pc}` or `{part: left, target: stm32f405}`",
      {format::record("where a part runs",
                      {{"part", format::name("a name"), false,
                        "name of the part (default: that of the machine or the board)"},
                       {"target", format::text("a target"), false,
                        "target of its program (default: linux-sim)"},
                       {"host", format::file_name("the name of a machine"), false,
                        "machine that runs it (default: this one)"},
                       {"key", format::text("a file of `eagerx-gen key new`"), false,
                        "key file (`--key`) for both ends of the line to `host`"}}),
       format::text("a board")});
}

Field processor_field() {
  return {"processor", processor_format(), false, "converts every message"};
}

/// `one`: a number that is sampled, or a delay.
std::vector<Field> random_fields(const FormatPtr& one) {
  const FormatPtr value = format::one_of("a number or a list of numbers",
                                         {format::list("a list of numbers", one, 1), one});
  const auto pair = [&](const char* what, const char* first, const char* second) {
    return format::record(what, {{first, value, true, first}, {second, value, true, second}});
  };
  return {{"value", value, false, "a constant value"},
          {"uniform",
           format::one_of("`space`, or a range such as `{low: 0.0, high: 1.0}`",
                          {pair("`uniform`", "low", "high"), format::keyword({"space"})}),
           false, "uniform between low and high, or in the whole space"},
          {"normal", pair("`normal`", "mean", "std"), false, "normally distributed"},
          {"log_uniform", pair("`log_uniform`", "low", "high"), false, "uniform in the logarithm"},
          {"choice", format::list("a list of values", value, 1), false,
           "one of these values, with equal probability"}};
}

FormatPtr selection(const std::string& what, std::vector<Field> settings,
                    std::vector<Elsewhere> elsewhere = {}) {
  const FormatPtr record =
      format::record("the settings of one of the " + what, std::move(settings));
  return format::one_of("a list of names, or a mapping from names to settings",
                        {format::list("a list of " + what, format::name("a name")),
                         format::map(what, knowing(record, std::move(elsewhere)))});
}

Field space_field() {
  return {"space", space_format(ReferenceRule::refuse, false), false,
          "dtype, shape and bounds of its messages"};
}

FormatPtr state_format(const std::vector<Field>& more) {
  const FormatPtr sampled = format::record("how a state gets its value",
                                           with(random_fields(format::number("a number")), more));
  return format::one_of("`uniform`, or a mapping such as `{value: 0.0}`",
                        {sampled, format::keyword({"uniform"})});
}

FormatPtr states_format() {
  Format states = *format::map("states", state_format({space_field(), processor_field()}));
  states.dotted_names = true;  // of a composite: `position.integral`
  return std::make_shared<const Format>(std::move(states));
}

Field type_field(const char* what) {
  return {"type", format::name(what), true, "the id of an entity as `eagerx-gen info` lists them"};
}
Field config_field() {
  return {"config", config_format(), false, "parameters of the entity"};
}
Field rate_field(bool required, const char* about) {
  return {"rate", format::rate(), required, about};
}
Field count_field() {
  return {"count", format::integer("a number of elements", 1, kLongestArray), false,
          "number of elements of an array: `leg[0]`, `leg[1]`, …"};
}
Field states_field() {
  return {"states", states_format(), false,
          "values of its states at a reset; states that are not named keep their values, which "
          "start as their defaults"};
}

/// The default of the connections from a sensor.
std::vector<Field> delay_settings() {
  std::vector<Field> fields;
  for (const Field& field : connection_settings()) {
    if (field.name == "delay" || field.name == "max_delay") fields.push_back(field);
  }
  return fields;
}

Field sensors_field() {
  const std::vector<Field> settings = {rate_field(false, "its rate in Hz"), space_field(),
                                       processor_field()};
  return {"sensors",
          selection("sensors", with(settings, delay_settings()),
                    {of_connections("OBJECT.SENSOR", "observations.NAME")}),
          false, "sensors to use (default: the connected ones) and their settings"};
}

Field actuators_field() {
  return {"actuators",
          selection("actuators", {rate_field(false, "its rate in Hz"), space_field()},
                    {of_connections("actions.NAME", "OBJECT.ACTUATOR")}),
          false, "actuators to use (default: the connected ones) and their settings"};
}

}  // namespace

std::vector<Field> connection_settings() {
  return {
      {"window", format::integer("a number of messages", 0, 1'000'000), false,
       "number of last messages that the receiver sees; 0: those since its last tick (default 1)"},
      {"delay",
       format::one_of(
           "a delay in seconds, or a mapping such as `{uniform: {low: 0, high: "
           "0.1}}`",
           {format::record("how a delay is sampled",
                           random_fields(format::number("a delay in seconds", Quantity::time))),
            format::time("a delay in seconds")}),
       false, "seconds from sending to receiving, or a distribution that every reset samples from"},
      {"max_delay", format::time("a delay in seconds"), false,
       "maximum delay that a reset may set (default: the maximum of the distribution)"},
      {"skip", format::boolean(), false,
       "read the message of the previous tick, which breaks a cycle"}};
}

FormatPtr distribution_format() {
  return state_format({});
}

FormatPtr object_format() {
  return format::record("an object",
                        {type_field("the id of an object"), count_field(), config_field(),
                         sensors_field(), actuators_field(), states_field()});
}

FormatPtr node_format() {
  return format::record(
      "a node",
      {{"type", format::name("the id of a node"), false,
        "the id of an entity as `eagerx-gen info` lists them"},
       {"policy", node_policy_format(), false,
        "a trained policy instead of a type: it reads the inputs in their order and computes the "
        "outputs"},
       rate_field(true, "its rate in Hz"),
       count_field(),
       config_field(),
       {"inputs",
        selection("inputs", with({space_field(), processor_field()}, connection_settings())), false,
        "inputs to use (default: all) and their settings"},
       {"outputs", selection("outputs", {space_field(), processor_field()}), false,
        "outputs to use (default: all) and their settings"},
       states_field()});
}

FormatPtr config_format() {
  return format::map("parameters", format::any("a value"));
}

FormatPtr processor_format() {
  const FormatPtr record = format::record(
      "a processor", {{"type", format::name("the name of a processor"), true, "its id"},
                      {"config", config_format(), false, "its parameters"}});
  const FormatPtr name = format::name("the name of a processor");
  const FormatPtr one = format::one_of(
      "the name of a processor, or a mapping with its `type` and `config`", {record, name});
  return format::one_of(
      "the name of a processor, a mapping with its `type` and `config`, or a list of them",
      {record, name, format::list("a list of processors", one, 1)});
}

FormatPtr space_format(ReferenceRule references, bool like) {
  const FormatPtr dimension = format::integer("a size of at least 1", 1, 1'000'000'000);
  const FormatPtr shape = references == ReferenceRule::refuse
                              ? dimension
                              : format::one_of("a size or `$(config NAME)`",
                                               {dimension, format::text("`$(config NAME)`")});
  std::vector<Field> fields = {
      {"dtype", format::keyword(dtype_names()), false, "type of an element, as numpy names it"},
      {"shape", format::list("a list of sizes, `[]` for a scalar", shape), false,
       "sizes, `[]` for a scalar"},
      {"low", bound_format(references), false, "lowest value"},
      {"high", bound_format(references), false, "highest value"}};
  if (like) {
    fields.push_back({"like", format::text("a port"), false, "port to take everything else from"});
  }
  return format::record("a space", std::move(fields));
}

FormatPtr connections_format() {
  return format::list(
      "a list of connections",
      format::record(
          "a connection",
          with({{"from",
                 format::port("`entity.port`, such as `pendulum.theta` or `actions.voltage`"), true,
                 "the sending port"},
                {"to", format::port("`entity.port`, such as `pendulum.u` or `observations.angle`"),
                 true,
                 "the receiving port; of a reset node also `node.feedthroughs.OUTPUT` and, from "
                 "`object.states.STATE`, `node.targets.TARGET`"},
                processor_field()},
               connection_settings())));
}

FormatPtr engine_nodes_format() {
  const FormatPtr rate = format::one_of(
      "a rate in Hz, or `$(sensors NAME rate)`, `$(actuators NAME rate)`, `$(config NAME)`",
      {format::rate(), format::text("a reference such as `$(sensors theta rate)`")});
  return format::map(
      "engine nodes",
      format::record("an engine node",
                     {type_field("the id of an engine node"),
                      {"rate", rate, true, "its rate in Hz"},
                      config_field(),
                      {"inputs", format::list("a list of inputs", format::name("a name")), false,
                       "inputs to use (default: all)"},
                      {"outputs", selection("outputs", {space_field(), processor_field()}), false,
                       "outputs to use (default: all) and their settings"}}));
}

namespace {

FormatPtr make_graph_format(GraphForm form) {
  const auto entities = [form](const char* what, const FormatPtr& item) {
    return form == GraphForm::flat ? format::inner_map(what, item) : format::map(what, item);
  };
  return format::record(
      "the graph",
      {{"name", format::name("a name"), true,
        "the name of the graph, of the C++ namespace and of the program"},
       {"rate", format::rate(), true,
        "the rate of the environment in Hz: one step is 1/rate seconds"},
       {"real", format::keyword({"float", "double"}), false,
        "floating-point type of engines and nodes (default float)"},
       {"reset_timeout", format::time("a time in seconds", true), false,
        "maximum time of reset nodes, in seconds of the graph (default 60)"},
       {"library", format::list("a list of folders", format::text("a folder")), false,
        "folders with your own entities, relative to this file"},
       {"engine",
        format::record("the engine", {type_field("the id of an engine"),
                                      rate_field(true, "its rate in Hz"),
                                      config_field(),
                                      states_field(),
                                      {"simulate_delays", format::boolean(), false,
                                       "false: every delay counts as 0 (default true)"},
                                      {"sync", format::boolean(), false,
                                       "false: inputs take the messages that have arrived when "
                                       "their node begins (default true: messages are counted)"}}),
        false, "engine that runs the objects; a graph without objects needs none"},
       {"objects", entities("objects", object_format()), false,
        "robots and other parts of the world, with sensors and actuators"},
       {"nodes", entities("nodes", node_format()), false, "filters, controllers, estimators"},
       {"actions",
        selection("actions",
                  {{"space", space_format(ReferenceRule::refuse, true), false,
                    "bounds of the action (default: those of the first port it is connected to)"}},
                  {of_connections("actions.NAME", "pendulum.u"), rate_of_steps()}),
        true, "what the agent decides at every step"},
       {"observations",
        selection(
            "observations",
            {{"space",
              knowing(space_format(ReferenceRule::refuse, false),
                      {{{"like"}, "leave it out: an observation has the space of its source"}}),
              false, "bounds of the observation (default: those of its source)"}},
            {of_connections("pendulum.theta", "observations.NAME"), rate_of_steps()}),
        true, "what the agent sees at every step"},
       {"connections", connections_format(), true, "messages from port to port"},
       {"agent", agent_format(), false, "source of the actions (default: zero)"},
       {"task", task_format(), false,
        "reward and end of an episode, for training and for measuring success"},
       {"render",
        format::record(
            "`render`",
            {{"source", format::port("a port such as `pendulum.scene` or `overlay.scene`"), true,
              "a sensor or an output with a scene or an image"},
             rate_field(false, "pictures a second (default: the graph's rate)"),
             {"keys", render_keys_format(), false,
              "keys that steer the simulation of `report --simulate` while they are held"}}),
        false, "drawing that `--render` of a program shows"},
       {"telemetry", telemetry_format(), false,
        "messages that a board sends over its serial port, in real time"},
       {"safety", safety_format(), false, "safe actions, and when they replace the agent's"},
       {"placement", format::inner_map("names of nodes, `agent` or `controller`", part_format()),
        false,
        "parts on boards, in other processes or on other machines: nodes, `agent`, or `controller` "
        "for the agent and all nodes that are not placed otherwise"},
       {"budget", budget_format(), false,
        "limits for memory, instructions, the age of data and stability margins; `build`, `run` "
        "and "
        "`size` check those of an image"},
       {"allow", format::list("a list of codes of warnings", format::text("a code such as W0103")),
        false, "warnings to suppress for this graph"},
       // Keys that compose/ removes before the checks.
       {"tunable", format::list("a list of parameters", format::port("`node.parameter`")), false,
        "parameters that a reset may set, as states: `controller.kp`"},
       {"extends",
        format::one_of("a graph file, or a mapping with its `file` and `variant`",
                       {format::record("what is extended", {{"file", format::text("a graph file"),
                                                             true, "a graph file"},
                                                            {"variant", format::name("a variant"),
                                                             false, "a variant in that file"}}),
                        format::text("a graph file")}),
        false, "graph that this one modifies"},
       {"variants", format::map("variants", format::any("what a variant says")), false,
        "modifications of this graph, selected with `--variant`"},
       {"remove", format::list("a list of paths", format::text("a path such as `nodes.filter`")),
        false, "elements of the extended graph to remove"}});
}

}  // namespace

const Format& graph_format(GraphForm form) {
  static const FormatPtr kWritten = make_graph_format(GraphForm::written);
  static const FormatPtr kInner = make_graph_format(GraphForm::flat);
  return form == GraphForm::written ? *kWritten : *kInner;
}

}  // namespace eagerx::gen
