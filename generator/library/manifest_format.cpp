// The tables of manifests, one for each kind.
#include <array>

#include "generator/library/library.hpp"

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
                                       "values of its parameters that it is this entity for"}}),
                      id}));
}

FormatPtr parameter_format() {
  return format::record(
      "a parameter",
      {{"type", format::keyword({"int", "float", "bool", "string", "enum", "ints", "floats"}), true,
        "type"},
       {"about", format::text("a text"), true, "what it means, in one line"},
       {"unit", format::text("a unit"), false, "unit"},
       {"eagerx", format::text("a name"), false, "its name in EAGERx, if that is another one"},
       {"default", format::any("a value"), false,
        "value if none is given; without a default, a value must be given"},
       {"low", format::number("a number"), false, "lowest value, inclusive"},
       {"high", format::number("a number"), false, "highest value, inclusive"},
       {"options", texts(), false, "the choices of an enum"},
       {"class", format::text("a C++ enumeration"), false, "the C++ enumeration of an enum"}});
}

FormatPtr requirements_format() {
  return format::list(
      "a list of conditions",
      format::record("a condition",
                     {{"that", format::text("a condition such as `low < high`"), true,
                       "a condition such as `low < high`"},
                      {"because", format::text("a text"), true, "what it means, in one line"}}));
}

Fields port_fields() {
  return {{"space", space_format(Reference::accept, true), false, "what its messages may hold"},
          {"unit", format::text("a unit"), false, "unit"},
          {"about", format::text("a text"), false, "what it means, in one line"}};
}

Fields connection_defaults() {
  return {{"window",
           format::one_of("a number of messages or `$(config NAME)`",
                          {format::integer("a number of messages", 0, 1'000'000),
                           format::text("`$(config NAME)`")}),
           false, "default window"},
          {"delay", format::decimal("a delay in seconds", 0.0, false), false, "default delay"},
          {"skip", format::boolean(), false, "default skip"}};
}

FormatPtr ports(const std::string& what, const Fields& fields) {
  return format::map(what, format::record("one of the " + what, fields));
}

Fields common(const std::string& kind) {
  // Boards have names such as mps2-an386; an entity's id is a name.
  const FormatPtr id =
      kind == "target" ? format::file_name("the id of a target") : format::name("an id");
  return {{"kind", format::keyword({kind}), true, "kind of entity"},
          {"id", id, true, "what graphs write as `type:`, or `--target`"},
          {"eagerx", eagerx_format(), false, "ids of EAGERx that it stands for"},
          {"summary", format::text("a text"), true, "one line"},
          {"description", format::text("a text"), false, "equations, units, sources"}};
}

/// A file beside the manifest.
FormatPtr header_format() {
  return format::path("a header", true);
}

FormatPtr templates_format() {
  Format result = *format::file_map("a mapping from template files to the files they become");
  result.key = format::path("a template file", true);
  result.item = format::path("a file of the output", false);
  return std::make_shared<const Format>(std::move(result));
}

FormatPtr system_format() {
  return format::keyword({"linux"});
}

Fields cpp() {
  return {{"header", header_format(), true, "header beside the manifest"},
          {"class", format::text("a C++ class template"), true, "C++ class template over its Io"},
          {"pkg_config",
           format::list("a list of names of libraries", format::file_name("the name of a library")),
           false, "pkg-config's names of the libraries that it needs"},
          {"system", system_format(), false, "the operating system it needs (default: none)"},
          {"family", format::name("a family of boards"), false,
           "the family of boards it needs (default: none)"}};
}

Fields config() {
  return {{"config", format::map("parameters", parameter_format()), false, "parameters"},
          {"requires", requirements_format(), false, "what they must fulfil together"}};
}
Fields engines() {
  return {{"engines", texts(), false, "engines it works with (default: all)"}};
}
Fields states() {
  return {{"states", ports("states", port_fields()), false, "what can be set at a reset"}};
}

Fields node_ports() {
  const Fields max_delay = {{"max_delay",
                             format::one_of("a delay in seconds or `$(config NAME)`",
                                            {format::decimal("a delay in seconds", 0.0, false),
                                             format::text("`$(config NAME)`")}),
                             false, "the entity sets the delay at its reset, up to this"}};
  const Fields optional = {
      {"optional", format::boolean(), false, "whether a graph may leave it out (default: false)"}};
  return Fields{{"inputs",
                 ports("inputs", port_fields() + connection_defaults() + max_delay + optional),
                 false, "inputs"},
                {"outputs", ports("outputs", port_fields() + optional), false, "outputs"},
                {"counts", texts(), false,
                 "what its for_each_count() counts besides messages, for the summary"}} +
         states();
}

Fields implementation() {
  const FormatPtr engine_state = format::record(
      "an engine state, or the state of an engine node",
      {{"type", format::name("the id of an engine state"), false, "its id"},
       {"config", config_format(), false, "its parameters"},
       {"node", format::port("`NODE.STATE`"), false, "the engine node's state that it is"}});
  return {
      {"model",
       format::record("a model", {{"header", header_format(), true, "header beside the manifest"},
                                  {"class", format::text("a C++ class template"), true,
                                   "what the engine simulates"}}),
       true, "what the engine simulates"},
      {"nodes", engine_nodes_format(), false, "engine nodes"},
      {"connections", connections_format(), false,
       "connections between them, `sensors` and `actuators`"},
      {"states", format::map("states", engine_state), false, "engine states"}};
}

FormatPtr object_engine_format() {
  return format::map("implementations", format::record("an implementation", implementation()));
}

Fields implementation_apart() {
  return Fields{{"kind", format::keyword({"implementation"}), true, "kind of manifest"},
                {"object", format::name("the id of an object"), true, "what is implemented"},
                {"engine", format::name("the id of an engine"), true, "on which engine"},
                {"summary", format::text("a text"), false, "one line"},
                {"description", format::text("a text"), false, "equations, units, sources"}} +
         implementation();
}

Fields object_ports() {
  const FormatPtr rate = format::one_of(
      "a rate in Hz or `$(config NAME)`",
      {format::decimal("a rate in Hz", 0.0, true), format::text("`$(config NAME)`")});
  const Fields rated = port_fields() + Fields{{"rate", rate, true, "its rate in Hz"}};
  return Fields{
             {"sensors", ports("sensors", rated), false, "sensors"},
             {"actuators", ports("actuators", rated + connection_defaults()), false, "actuators"}} +
         states() +
         Fields{{"engines", object_engine_format(), false, "how it is made on each engine"}};
}

FormatPtr target_format() {
  return format::record(
      "a target",
      common("target") +
          Fields{{"templates", templates_format(), false, "files made for each graph"},
                 {"partner", templates_format(), false,
                  "files made for the board's half of a split graph"},
                 {"cmake", format::path("a CMake file", true), true,
                  "defines eagerx_configure_target"},
                 {"toolchain", format::file_name("a toolchain file"), false, "in toolchains/"},
                 // For people and for CMake; a board in the making has blanks here.
                 {"cpu", format::text("a processor core"), false, "the processor core"},
                 {"clock_hz", format::text("a frequency in Hz"), false, "the core's clock"},
                 {"flash", texts(), false, "origin and size of the memory for code"},
                 {"ram", texts(), false, "origin and size of the memory for data"},
                 {"system", system_format(), false, "its operating system (default: none)"},
                 {"family", format::name("a family of boards"), false,
                  "what entities made for these boards name (default: none)"},
                 {"run", texts(), false, "command that runs an image"}});
}

}  // namespace

std::vector<std::string> manifest_kinds() {
  return {"node",   "reset_node", "engine",         "engine_node", "engine_state",
          "object", "processor",  "implementation", "target"};
}

const Format* manifest_format(std::string_view kind) {
  const Fields space = {{"space", space_format(Reference::accept, true), false, "what it takes"}};
  static const std::map<std::string, FormatPtr, std::less<>> kFormats = {
      {"node", format::record("a node", common("node") + cpp() + config() + node_ports())},
      {"reset_node",
       format::record("a reset node", common("reset_node") + cpp() + config() + node_ports() +
                                          Fields{{"targets", ports("targets", port_fields()), true,
                                                  "states that it brings about"}})},
      {"engine",
       format::record("an engine",
                      common("engine") + cpp() + config() + states() +
                          Fields{{"runs", texts(), false,
                                  "engines whose implementations of objects it runs, too"},
                                 {"asynchronous", format::boolean(), false,
                                  "its class has now_ns(), a clock that inputs can go by"},
                                 {"simulator",
                                  format::record("a simulator",
                                                 {{"class", format::text("a C++ class template"),
                                                   true, "class template over a model"},
                                                  {"header", header_format(), false,
                                                   "header beside the manifest"}}),
                                  true, "what holds an object's state"}})},
      {"engine_node", format::record("an engine node", common("engine_node") + cpp() + engines() +
                                                           config() + node_ports())},
      {"engine_state", format::record("an engine state", common("engine_state") + cpp() +
                                                             engines() + config() + space)},
      {"object", format::record("an object", common("object") + config() + object_ports())},
      {"processor",
       format::record("a processor", common("processor") + cpp() + config() +
                                         Fields{{"input", space_format(Reference::accept, false),
                                                 false, "what it takes"},
                                                {"output", space_format(Reference::accept, true),
                                                 true, "what it gives"}})},
      {"implementation", format::record("an implementation", implementation_apart())},
      {"target", target_format()}};
  const auto found = kFormats.find(kind);
  return found == kFormats.end() ? nullptr : found->second.get();
}

}  // namespace eagerx::gen
