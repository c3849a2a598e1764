// The tables of manifests, one for each kind.
#include <array>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {
namespace {

using Fields = std::vector<Field>;

Fields operator+(Fields left, const Fields& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

FormatPtr texts() {
  return format::list("a list of texts", format::text("a text"));
}

FormatPtr eagerx_format() {
  const FormatPtr id = format::text("an id such as `package.module/Class`");
  return format::list(
      "a list of ids of EAGERx",
      format::one_of("an id of EAGERx, or a mapping with its `id` and `when`",
                     {format::record("an id of EAGERx",
                                     {{"id", id, true, "module/Class"},
                                      {"when", config_format(), false,
                                       "values of its parameters that select this entity"}}),
                      id}));
}

FormatPtr parameter_format() {
  return format::record(
      "a parameter",
      {{"type",
        format::keyword({"int", "float", "bool", "string", "enum", "ints", "floats", "model"}),
        true, "type"},
       {"about", format::text("a text"), true, "meaning, in one line"},
       {"unit", format::text("a unit"), false, "unit"},
       {"eagerx", format::text("a name"), false, "name in EAGERx, if different"},
       {"default", format::any("a value"), false,
        "default value; a parameter without one is required"},
       {"low", format::number("a number"), false, "lowest value, inclusive"},
       {"high", format::number("a number"), false, "highest value, inclusive"},
       {"tunable",
        format::one_of("true, false or running", {format::boolean(), format::keyword({"running"})}),
        false,
        "whether a reset may set it if the graph lists it under `tunable:`: the class takes a "
        "state of this name (nodes only; default: false); `running`: also between two steps, with "
        "the class's `tune()`"},
       {"options", texts(), false, "the choices of an enum"},
       {"class", format::text("a C++ enumeration"), false, "the C++ enumeration of an enum"},
       {"engine", format::name("the id of an engine"), false,
        "engine of the object's model, for type `model`"}});
}

FormatPtr requirements_format() {
  return format::list(
      "a list of conditions",
      format::record("a condition",
                     {{"that", format::text("a condition such as `low < high`"), true,
                       "a condition such as `low < high`"},
                      {"because", format::text("a text"), true, "meaning, in one line"}}));
}

/// `like` only where messages leave: what comes in has a space of its own.
Fields port_fields(bool like = false) {
  return {{"space", space_format(ReferenceRule::accept, like), false,
           "type, shape and bounds of its messages"},
          {"unit", format::text("a unit"), false, "unit"},
          {"eagerx", format::text("a name"), false, "name in EAGERx, if different"},
          {"about", format::text("a text"), false, "meaning, in one line"}};
}

FormatPtr delay_format() {
  return format::one_of("a delay in seconds or `$(config NAME)`",
                        {format::time("a delay in seconds"), format::text("`$(config NAME)`")});
}

Fields connection_defaults() {
  return {{"window",
           format::one_of("a number of messages or `$(config NAME)`",
                          {format::integer("a number of messages", 0, 1'000'000),
                           format::text("`$(config NAME)`")}),
           false, "default window"},
          {"delay", delay_format(), false, "default delay"},
          {"skip", format::boolean(), false, "default skip"}};
}

FormatPtr ports(const std::string& what, const Fields& fields) {
  return format::map(what, format::record("one of the " + what, fields));
}

Fields about(const std::string& kind, FormatPtr id) {
  return {{"kind", format::keyword({kind}), true, "kind of entity"},
          {"id", std::move(id), true, "name of the entity, for `type:` in graphs or `--target`"},
          {"summary", format::text("a text"), true, "one line"},
          {"description", format::text("a text"), false, "equations, units, sources"}};
}

/// A file in the manifest's folder.
FormatPtr header_format() {
  return format::path("a header", true);
}

FormatPtr templates_format() {
  Format result = *format::file_map("a mapping from template files to the files they become");
  result.key = format::path("a template file", true);
  result.item = format::path("a file of the output", false);
  return std::make_shared<const Format>(std::move(result));
}

Fields common(const std::string& kind) {
  return about(kind, format::name("an id")) +
         Fields{{"eagerx", eagerx_format(), false, "ids of EAGERx that it replaces"}};
}

FormatPtr system_format() {
  return format::keyword({"linux"});
}

Fields cpp(bool is_needed = true) {
  return {
      {"header", header_format(), is_needed, "header in the manifest's folder"},
      {"class", format::text("a C++ class template"), is_needed, "C++ class template over its Io"},
      {"pkg_config",
       format::list("a list of names of libraries", format::file_name("the name of a library")),
       false, "names of required libraries in pkg-config"},
      {"system", system_format(), false, "required operating system (default: none)"},
      {"family", format::name("a family of boards"), false,
       "required family of boards (default: none)"}};
}

Fields python() {
  return {{"python", format::path("a file in Python", true), false,
           "file in the manifest's folder with a class named like `id`, for parts in Python; "
           "without `header` and `class`, the node runs only there"}};
}

/// Of what ticks or converts; a reset runs alone.
Fields vectorized() {
  return {{"vectorized",
           format::one_of("true, false or a condition",
                          {format::boolean(), format::text("a condition")}),
           false,
           "whether its class also computes with SIMD vectors, one lane for each environment, or a "
           "condition for this (default: false)"}};
}

Fields config() {
  return {{"config", format::map("parameters", parameter_format()), false, "parameters"},
          {"requires", requirements_format(), false, "conditions on the parameters"}};
}
Fields engines() {
  return {{"engines", texts(), false, "supported engines (default: all)"}};
}
Fields states(const Fields& more = {}) {
  return {
      {"states", ports("states", port_fields() + more), false, "states, which a reset may set"}};
}

Fields node_ports(bool can_do_without) {
  const Fields max_delay = {{"max_delay", delay_format(), false,
                             "maximum delay, if the entity sets the delay at its reset"}};
  const Field leave_out = {"optional", format::boolean(), false,
                           "whether a graph may omit it (default: false)"};
  const Fields optional = can_do_without ? Fields{leave_out} : Fields{};
  const Field tunable = {"tunable", format::keyword({"running"}), false,
                         "`running`: also between two steps, with the class's `tune()`"};
  return Fields{{"inputs",
                 ports("inputs", port_fields() + connection_defaults() + max_delay + optional),
                 false, "inputs"},
                {"outputs", ports("outputs", port_fields(true) + optional), false, "outputs"},
                {"counts", texts(), false,
                 "names of the counts of its for_each_count(), for the summary"}} +
         states(can_do_without ? Fields{tunable} : Fields{});
}

Fields implementation() {
  const FormatPtr engine_state =
      format::record("an engine state, or the state of an engine node",
                     {{"type", format::name("the id of an engine state"), false, "its id"},
                      {"config", config_format(), false, "its parameters"},
                      {"node", format::port("`NODE.STATE`"), false,
                       "state of an engine node, instead of an engine state"}});
  return {{"model",
           format::record("a model",
                          {{"header", header_format(), true, "header in the manifest's folder"},
                           {"class", format::text("a C++ class template"), true,
                            "model that the engine simulates"},
                           {"vectorized", format::boolean(), false,
                            "whether it also computes with SIMD vectors, one lane for each "
                            "environment (default: false)"}}),
           true, "model that the engine simulates"},
          {"nodes", engine_nodes_format(), false, "engine nodes"},
          {"connections", connections_format(), false,
           "connections between them, `sensors` and `actuators`"},
          {"states", format::map("states", engine_state), false, "engine states"}};
}

FormatPtr object_engine_format() {
  return format::map("implementations", format::record("an implementation", implementation()));
}

Fields implementation_apart() {
  return Fields{
             {"kind", format::keyword({"implementation"}), true, "kind of manifest"},
             {"object", format::name("the id of an object"), true, "the implemented object"},
             {"engine", format::name("the id of an engine"), true, "engine of the implementation"},
             {"summary", format::text("a text"), false, "one line"},
             {"description", format::text("a text"), false, "equations, units, sources"}} +
         implementation();
}

Fields object_ports() {
  const FormatPtr rate = format::one_of("a rate in Hz or `$(config NAME)`",
                                        {format::rate(), format::text("`$(config NAME)`")});
  const Fields rated = port_fields() + Fields{{"rate", rate, true, "its rate in Hz"}};
  const Fields delayed = {
      {"delay", delay_format(), false, "default delay of connections from it"},
      {"max_delay", delay_format(), false, "maximum delay that a reset may set"}};
  return Fields{
             {"sensors", ports("sensors", rated + delayed), false, "sensors"},
             {"actuators", ports("actuators", rated + connection_defaults()), false, "actuators"}} +
         states() +
         Fields{{"engines", object_engine_format(), false, "its implementation for each engine"}};
}

/// An engine state is given values of the object's space, whose bounds are the object's.
Fields space_of_state() {
  std::vector<Field> fields = space_format(ReferenceRule::accept, false)->fields;
  std::erase_if(fields,
                [](const Field& field) { return field.name == "low" || field.name == "high"; });
  return {{"space", format::record("a space", std::move(fields)), false, "accepted messages"}};
}

FormatPtr target_format() {
  constexpr double kMostBaud = 100'000'000;
  constexpr double kMostWaitStates = 1000;
  return format::record(
      "a target",
      // Boards have names such as mps2-an386.
      about("target", format::file_name("the id of a target")) +
          Fields{
              {"templates", templates_format(), false, "files made for each graph"},
              {"partner", templates_format(), false,
               "files made for the board's half of a split graph"},
              {"language", format::text("a language"), false,
               "language of `partner`, if not C++: templates get messages and nodes of the part"},
              {"yours", templates_format(), false,
               "with `language`: files that are written once and belong to the user"},
              {"vectorized", format::boolean(), false,
               "whether the vectorized program is generated, too (default: false)"},
              {"derivatives", format::boolean(), false,
               "whether the program over numbers with derivatives is generated, too (default: "
               "false)"},
              {"cmake", format::path("a CMake file", true), false,
               "the CMake file that defines eagerx_configure_target"},
              {"toolchain", format::file_name("a toolchain file"), false, "in toolchains/"},
              // For people and for CMake; a board in the making has blanks here.
              {"cpu", format::text("a processor core"), false, "the processor core"},
              {"clock_hz", format::text("a frequency in Hz"), false, "the core's clock"},
              {"wait_states", format::integer("a number of cycles", 0, kMostWaitStates), false,
               "cycles that each access to the memory for code waits at this clock"},
              {"interrupts", format::map("interrupts", format::rate()), false,
               "handlers of the board's own interrupts, and how often a second each comes at most"},
              {"baud", format::integer("a baud rate", 1, kMostBaud), false,
               "speed of the serial port, which then takes telemetry"},
              {"flash", texts(), false, "origin and size of the memory for code"},
              {"ram", texts(), false, "origin and size of the memory for data"},
              {"system", system_format(), false, "its operating system (default: none)"},
              {"family", format::name("a family of boards"), false,
               "the family of boards that it belongs to (default: none)"},
              {"run", texts(), false, "command that runs an image"},
              {"image", format::text("a file name"), false,
               "the built file; `{name}` is the graph's name (default: {name}, and {name}.elf "
               "without an operating system)"}});
}

/// Ports of a composite: what they are bound to. Spaces are those of the ports inside.
FormatPtr bound_ports(const std::string& what, const Fields& binding) {
  return ports(
      what,
      binding + Fields{{"unit", format::text("a unit"), false, "unit"},
                       {"eagerx", format::text("a name"), false, "name in EAGERx, if different"},
                       {"about", format::text("a text"), false, "meaning, in one line"}});
}

Fields receiving() {
  const FormatPtr port = format::port("a port inside, such as `position.setpoint`");
  return Fields{{"to",
                 format::one_of("a port inside, or a list of them",
                                {format::list("a list of ports", port, 1), port}),
                 true, "port inside that receives its messages, or several"},
                {"processor", processor_format(), false, "converts every message"},
                {"max_delay", delay_format(), false, "maximum delay that a reset may set"}} +
         connection_defaults();
}

Fields sending() {
  return {{"from", format::port("a port inside, such as `current.u`"), true,
           "port inside that sends its messages"}};
}

/// The graph inside is checked where it is used: only there its parameters have values.
Field inner_graph() {
  const FormatPtr entities = format::map("entities", format::any("an entity"));
  return {"graph",
          format::record("the graph inside",
                         {{"objects", entities, false, "as in a graph"},
                          {"nodes", entities, false, "as in a graph; `rate` may be `$(rate)`"},
                          {"connections", format::list("a list of connections", format::any("")),
                           false, "connections of the components, as in a graph"}}),
          true, "components, instead of a class"};
}

}  // namespace

std::vector<std::string> manifest_kinds() {
  return {"node",   "reset_node", "engine",         "engine_node", "engine_state",
          "object", "processor",  "implementation", "target"};
}

const Format* manifest_format(std::string_view kind) {
  static const std::map<std::string, FormatPtr, std::less<>> kFormats = {
      {"node", format::record("a node", common("node") + cpp(false) + python() + vectorized() +
                                            config() + node_ports(true))},
      {"reset_node",
       format::record("a reset node", common("reset_node") + cpp() + config() + node_ports(true) +
                                          Fields{{"targets", ports("targets", port_fields()), true,
                                                  "states that its callback can reach"}})},
      {"engine", format::record(
                     "an engine",
                     common("engine") + cpp() + vectorized() + config() + states() +
                         Fields{{"runs", texts(), false,
                                 "other engines whose implementations of objects it runs"},
                                {"simd_registers", format::integer("a whole number", 1, 8), false,
                                 "registers of a SIMD vector; large models are fastest with 1 "
                                 "(default: 4, fastest for small models)"},
                                {"asynchronous", format::boolean(), false,
                                 "whether its class has a clock, now_ns(), for `sync: false`"},
                                {"simulator",
                                 format::record("a simulator",
                                                {{"class", format::text("a C++ class template"),
                                                  true, "class template over a model"},
                                                 {"header", header_format(), false,
                                                  "header in the manifest's folder"}}),
                                 true, "class that holds an object's state"}})},
      {"engine_node",
       format::record("an engine node", common("engine_node") + cpp() + vectorized() + engines() +
                                            config() + node_ports(false))},
      {"engine_state",
       format::record("an engine state",
                      common("engine_state") + cpp() + engines() + config() + space_of_state() +
                          Fields{{"moves", texts(), false,
                                  "what it sets that changes during an episode, such as "
                                  "`positions` (default: nothing, a parameter)"}})},
      {"object", format::record("an object", common("object") + config() + object_ports())},
      {"processor", format::record("a processor",
                                   common("processor") + cpp() + vectorized() + config() +
                                       Fields{{"input", space_format(ReferenceRule::accept, false),
                                               false, "accepted messages"},
                                              {"output", space_format(ReferenceRule::accept, true),
                                               true, "what it gives"}})},
      {"implementation", format::record("an implementation", implementation_apart())},
      {"target", target_format()}};
  const auto found = kFormats.find(kind);
  return found == kFormats.end() ? nullptr : found->second.get();
}

const Format* composite_format(std::string_view kind) {
  static const std::map<std::string, FormatPtr, std::less<>> kFormats = {
      {"node", format::record("a node made of a graph",
                              common("node") + config() +
                                  Fields{{"inputs", bound_ports("inputs", receiving()), false,
                                          "inputs, each the input of one or several inside"},
                                         {"outputs", bound_ports("outputs", sending()), false,
                                          "outputs, each the output of one inside"},
                                         inner_graph()})},
      {"object",
       format::record("an object made of a graph",
                      common("object") + config() +
                          Fields{{"sensors", bound_ports("sensors", sending()), false,
                                  "sensors, each the sensor or output of one inside"},
                                 {"actuators", bound_ports("actuators", receiving()), false,
                                  "actuators, each the actuator or input of one or several inside"},
                                 inner_graph()})}};
  const auto found = kFormats.find(kind);
  return found == kFormats.end() ? nullptr : found->second.get();
}

}  // namespace eagerx::gen
