// eagerx-gen info: lists all entities, and explains one.
#include "generator/analysis/info/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/backend/emit/namer.hpp"
#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/entity_json.hpp"
#include "generator/driver/commands/image_time.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/compose/flat_text.hpp"
#include "generator/frontend/library/other_names.hpp"
#include "generator/frontend/spec/schema.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

std::string text_of(const YamlValue& yaml) {
  if (yaml.is_scalar()) return yaml.text;
  std::vector<std::string> items;
  for (const auto& item : yaml.items) items.push_back(text_of(item));
  return fmt::format("[{}]", join(items, ", "));
}

std::string text_of(const QuantitySpec& quantity) {
  const Rational* number = quantity.number();
  return number != nullptr ? number->to_string() : text_of(*quantity.expression());
}

std::string space_of(const SpaceSpec& space) {
  if (space.like) return "like " + space.like->value;
  std::string text = space.dtype ? space.dtype->value : "any dtype";
  text += space.shape ? " " + text_of(*space.shape) : ", any shape";
  if (space.low) text += " from " + text_of(*space.low);
  if (space.high) text += " to " + text_of(*space.high);
  return text;
}

void print_ports(const char* title, const std::vector<PortManifest>& ports) {
  if (ports.empty()) return;
  say("\n{}\n", title);
  for (const auto& port : ports) {
    std::string more;
    if (!port.unit.empty()) more += " " + port.unit;
    if (port.rate) more += fmt::format(", {} Hz", text_of(*port.rate));
    if (port.settings.window) more += fmt::format(", window {}", text_of(*port.settings.window));
    if (port.settings.delay) more += fmt::format(", delay {} s", text_of(*port.settings.delay));
    if (skips(port.settings)) more += ", skip";
    if (port.optional) more += title == std::string_view("states") ? ", tunable" : ", optional";
    if (port.tunes_running) more += port.optional ? " while it runs" : ", tunable while it runs";
    if (port.eagerx != port.name.value) more += ", in EAGERx " + port.eagerx;
    if (port.settings.max_delay)
      more += fmt::format("{} up to {} s", port.rate ? ", longest delay" : ", sets its delay",
                          text_of(*port.settings.max_delay));
    say("  {:<20} {}{}\n", port.name.value, space_of(port.space), more);
    if (!port.about.empty()) say("  {:<20}   {}\n", "", port.about);
  }
}

void print_eagerx_ids(const Entity& entity) {
  for (const auto& eagerx : entity.eagerx_ids) {
    std::string when;
    for (const auto& [name, span, value] : eagerx.when)
      when += fmt::format("{}{} = {}", when.empty() ? " if " : ", ", name, text_of(value));
    say("{}{}{}", &eagerx == &entity.eagerx_ids.front() ? "\nin EAGERx: " : ", ", eagerx.id.value,
        when);
  }
  if (!entity.eagerx_ids.empty()) say("\n");
}

void print_parameters(const std::vector<Parameter>& parameters) {
  if (parameters.empty()) return;
  say("\nconfig\n");
  for (const auto& parameter : parameters) {
    std::string more = std::string(type_of(parameter));
    if (!parameter.options.empty()) more = fmt::format("{}", join(parameter.options, " | "));
    if (!parameter.engine.empty()) more += " " + parameter.engine;
    if (!parameter.unit.empty()) more += " " + parameter.unit;
    if (parameter.low) more += fmt::format(", at least {}", to_string(*parameter.low));
    if (parameter.high) more += fmt::format(", at most {}", to_string(*parameter.high));
    if (parameter.eagerx != parameter.name.value)
      more += fmt::format(", in EAGERx {}", parameter.eagerx);
    more += parameter.fallback ? fmt::format(" (default {})", text_of(*parameter.fallback))
                               : " (required)";
    say("  {:<20} {}\n  {:<20}   {}\n", parameter.name.value, more, "", parameter.about);
  }
}

void print_requirements(const std::vector<Requirement>& requirements) {
  if (requirements.empty()) return;
  say("\nrequires\n");
  for (const auto& requirement : requirements)
    say("  {}\n  {:<20}   {}\n", requirement.text, "", requirement.because);
}

/// Bindings of a composite's ports, and the entities inside.
void print_inside(const Entity& entity, const SourceMap& sources) {
  for (const char* section : {"sensors", "actuators", "inputs", "outputs"}) {
    const YamlValue* ports = entity.composite->find(section);
    if (ports == nullptr || ports->entries.empty()) continue;
    say("\n{}\n", section);
    for (const auto& entry : ports->entries) {
      const YamlValue* from = entry.value.find("from");
      const YamlValue& bound = from != nullptr ? *from : *entry.value.find("to");
      std::vector<std::string> inner;
      if (bound.is_scalar()) inner.push_back(bound.text);
      for (const auto& item : bound.items) inner.push_back(item.text);
      const YamlValue* unit = entry.value.find("unit");
      say("  {:<20} {} {}{}\n", entry.key, from != nullptr ? "from" : "to", join(inner, ", "),
          unit != nullptr ? ", " + unit->text : "");
      if (const YamlValue* about = entry.value.find("about")) say("{:25}{}\n", "", about->text);
    }
  }
  say("\ninside\n{}", flat_text(*entity.composite->find("graph"), sources));
}

void print_entity(const Entity& entity, const SourceMap& sources) {
  say("{} ({})\n{}\n", entity.id.value, kind_of(entity), entity.summary);
  if (!entity.description.empty()) say("\n{}", entity.description);
  print_eagerx_ids(entity);
  if (!entity.moves.empty())
    say("\nsets what changes during an episode: {}\n", join(entity.moves, ", "));
  if (!entity.engines.empty()) say("\nworks on: {}\n", join(entity.engines, ", "));
  if (!entity.runs.empty()) say("\nruns what is implemented for: {}\n", join(entity.runs, ", "));
  std::vector<std::string> engines;
  for (const auto& implementation : entity.object_engines)
    engines.push_back(implementation.engine.value);
  if (!engines.empty()) say("\nimplemented for: {}\n", join(engines, ", "));
  for (const auto& implementation : entity.object_engines) {
    if (!implementation.summary.empty())
      say("  {}: {}\n", implementation.engine.value, implementation.summary);
    if (!implementation.description.empty()) say("{}\n", implementation.description);
  }
  print_parameters(entity.config);
  if (entity.is_composite()) {
    print_requirements(entity.requirements);
    print_inside(entity, sources);
    return;
  }
  print_ports("sensors", entity.sensors);
  print_ports("actuators", entity.actuators);
  print_ports("inputs", entity.inputs);
  print_ports("outputs", entity.outputs);
  print_ports(entity.kind == EntityKind::engine_state ? "state" : "states", entity.states);
  print_ports("targets", entity.reset_targets);
  print_requirements(entity.requirements);
  if (!entity.cpp.include.empty()) say("\nC++: {} in {}\n", entity.cpp.name, entity.cpp.include);
}

void print_all(const Library& library) {
  for (const EntityKind kind :
       {EntityKind::object, EntityKind::node, EntityKind::processor, EntityKind::engine,
        EntityKind::engine_node, EntityKind::engine_state}) {
    say("{}s\n", to_string(kind));
    for (const auto& id : library.ids(kind)) say("  {:<22} {}\n", id, library.find(id)->summary);
  }
  say("targets\n");
  for (const auto& [id, target] : library.all_targets()) say("  {:<22} {}\n", id, target.summary);
}

/// A family is no entity, only a name that manifests use. False if `name` is none.
bool print_family(const Library& library, const std::string& name) {
  const auto engines = library.engines_of_family(name);
  if (!engines.empty()) {
    std::vector<std::string> objects;
    for (const auto& id : library.ids(EntityKind::object)) {
      const auto& made_for = library.find(id)->object_engines;
      if (ranges::any_of(made_for, [&](const auto& each) { return each.engine.value == name; }))
        objects.push_back(id);
    }
    say("{0} (family of engines)\nA name, not an engine: an object that is implemented for {0} "
        "runs "
        "on each engine of the family.\n\nengines that run it: {1}\nobjects implemented for it: "
        "{2}\n",
        name, join(engines, ", "),
        objects.empty() ? "none" : fmt::format("{}", join(objects, ", ")));
    return true;
  }
  std::vector<std::string> boards, entities;
  for (const auto& [id, target] : library.all_targets()) {
    if (target.family == name) boards.push_back(id);
  }
  for (const auto& [id, entity] : library.all_entities()) {
    if (entity.family && entity.family->value == name) entities.push_back(id);
  }
  if (boards.empty() && entities.empty()) return false;
  say("{} (family of boards)\nA name for boards with the same peripherals. Entities that need "
      "these "
      "name the family.\n\nboards: {}\nentities that need one of them: {}\n",
      name, boards.empty() ? "none" : fmt::format("{}", join(boards, ", ")),
      entities.empty() ? "none" : fmt::format("{}", join(entities, ", ")));
  return true;
}

bool is_graph_file(const std::string& name) {
  return name.ends_with(".yaml") || name.ends_with(".yml");
}

/// A line on policies whose bits differ from build to build; empty without any.
std::string profile_text(const GraphSpec& spec) {
  std::vector<std::string> names;
  const auto add = [&](const AgentSpec& policy, const std::string& name) {
    if (policy.profile && policy.profile->value == "fast") names.push_back(name);
  };
  add(spec.agent, "agent");
  for (const EntitySpec& node : spec.nodes) {
    if (node.policy) add(*node.policy, node.name.value);
  }
  if (names.empty()) return {};
  return fmt::format("\nprofile fast: {}; hashes hold for one build only\n", join(names, ", "));
}

struct InfoOptions : GraphOptions {
  std::string entity;  // or target, or graph file; empty: list all
  std::vector<std::string> images;
  bool flat = false, json_output = false;
};

/// The bounds of images of the graph, as `size --worst` has them.
Json image_times(Run& run, const InfoOptions& options) {
  Json all = Json::list();
  for (const std::string& image : options.images) {
    const auto time = time_of_image(run, options, image, true, run.diagnostics);
    if (!time) continue;
    std::vector<std::string> nodes;
    for (const InstructionBound& row : time->bound.nodes) nodes.push_back(row.name);
    if (!check_image_nodes(image, nodes, *run.graph, run.diagnostics)) continue;
    if (!options.json_output) {
      say("\n{}\n{}", image, time_text(*time));
      continue;
    }
    Json json = time_json(*time, false);
    json["image"] = image;
    all.push_back(std::move(json));
  }
  return all;
}

/// Time, memory and traffic in the plan of a graph.
int graph_info(InfoOptions options) {
  options.graph = options.entity;
  Run run;
  const bool made = make(run, options);
  if (options.flat && !run.flat.is_null()) {
    say("{}", flat_text(run.flat, run.sources));
    return finish(run, options);
  }
  if (!made) return finish(run, options);
  const PlanInfo report = info_of(*run.plan, run.spec->budget, run.diagnostics);
  allow_warnings(run.spec->allow, false, run.diagnostics);
  if (options.json_output) {
    Json json = info_json(report);
    if (!options.images.empty()) json["images"] = image_times(run, options);
    say("{}\n", dump_json(json));
    return finish(run, options);
  }
  say("{}{}{}{}{}{}{}", plan_text(report), vectorized_text(*run.plan), task_text(*run.graph),
      timing_text(report), parts_text(*run.plan, run.spec->budget), telemetry_text(*run.plan),
      profile_text(*run.spec));
  image_times(run, options);
  return finish(run, options);
}

/// "did you mean `PidController`?" for `PID`.
std::string help_with_entity(std::string_view word, const std::vector<std::string>& known) {
  const std::string meant = meant_by_other_name(word, known);
  return meant.empty() ? "`eagerx-gen info` lists all entities and targets" : meant;
}

int perform(const InfoOptions& options) {
  if (is_graph_file(options.entity)) return graph_info(options);
  if (options.flat || !options.images.empty()) {
    complain("error: `{}` is for graphs\nhelp: give a file GRAPH.yaml\n",
             options.flat ? "--flat" : "--image");
    return kWrongUsage;
  }
  Run run;
  load(run, options);
  if (run.diagnostics.has_errors()) return finish(run, options);
  if (options.entity.empty()) {
    if (options.json_output)
      say("{}\n", dump_json(library_json(run.library)));
    else
      print_all(run.library);
    return finish(run, options);
  }
  if (const Entity* entity = run.library.find(options.entity)) {
    if (options.json_output)
      say("{}\n", dump_json(entity_json(*entity)));
    else
      print_entity(*entity, run.sources);
    return finish(run, options);
  }
  if (const Target* target = run.library.find_target(options.entity)) {
    if (options.json_output) {
      say("{}\n", dump_json(target_json(*target)));
      return finish(run, options);
    }
    say("{} (target)\n{}\n\n{}", target->id.value, target->summary, target->description);
    if (!target->facts.empty()) say("\n");
    for (const auto& [name, value] : target->facts) say("{}: {}\n", name, value);
    return finish(run, options);
  }
  if (!options.json_output && print_family(run.library, options.entity))
    return finish(run, options);
  std::vector<std::string> known;
  for (const auto& [id, entity] : run.library.all_entities()) known.push_back(id);
  for (const auto& [id, target] : run.library.all_targets()) known.push_back(id);
  run.diagnostics.error("E0303", {}, fmt::format("unknown entity or target `{}`", options.entity))
      .help = did_you_mean(options.entity, known, help_with_entity(options.entity, known));
  return finish(run, options);
}

Command table(InfoOptions& options) {
  return {.name = "info",
          .about = "list entities and targets, or describe an entity, a target or a graph",
          .examples = {{"list all entities", "eagerx-gen info"},
                       {"ports and parameters of an entity", "eagerx-gen info ButterworthFilter"},
                       {"rates, buffers and ages of a graph", "eagerx-gen info pendulum.yaml"},
                       {"messages on the links of a split graph",
                        "eagerx-gen info robot.yaml --split controller=stm32f405"},
                       {"the bounds of an image's slots against the graph's rates",
                        "eagerx-gen info pendulum.yaml --image build/pendulum.elf"},
                       {"the graph after its composites, arrays and variants are expanded",
                        "eagerx-gen info robot.yaml --variant real --flat"}},
          .arguments = joined(
              {{reads(text("entity", options.entity, "id of an entity or target, or a graph file",
                           "ENTITY|GRAPH.yaml")),
                variant(options), engine(options), split(options)},
               rates(options),
               {library(options),
                experimental(
                    reads(texts("--image", options.images,
                                "also list upper bounds from an image of the graph, as for size "
                                "--worst; may be repeated",
                                "IMAGE.elf"))),
                flag("--flat", options.flat,
                     "print the graph with composites, arrays and variants expanded, and the "
                     "origin of each line"),
                flag("--json", options.json_output, "print JSON")}}),
          .run = [&options] { return perform(options); }};
}

}  // namespace

Command info_command() {
  return with_options<InfoOptions>(table);
}

}  // namespace eagerx::gen
