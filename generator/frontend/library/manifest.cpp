// Converts the tree of a manifest into a struct.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/library/manifest_values.hpp"
#include "generator/frontend/library/parameters.hpp"
#include "generator/frontend/read/bytes.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Afterwards: conditions speak of parameters and ports.
std::vector<Requirement> read_requirements(const YamlValue& root, const Entity& entity,
                                           Diagnostics& diagnostics) {
  std::vector<Requirement> result;
  const YamlValue* list = root.find("requires");
  if (list == nullptr) return result;
  for (const auto& item : list->items) {
    const YamlValue& that = *item.find("that");
    if (auto condition = read_condition(that, entity, diagnostics))
      result.push_back({std::move(*condition), that.text, text_at(item, "because"), that.span});
  }
  return result;
}

/// Afterwards, too: true, false or a condition.
Condition read_vectorized(const YamlValue& root, const Entity& entity, Diagnostics& diagnostics) {
  const YamlValue* vectorized = root.find("vectorized");
  if (vectorized == nullptr || vectorized->text == "false") return {};
  if (vectorized->text == "true") return always();
  return read_condition(*vectorized, entity, diagnostics).value_or(Condition{});
}

std::vector<EagerxId> read_eagerx_ids(const YamlValue& root) {
  std::vector<EagerxId> result;
  const YamlValue* list = root.find("eagerx");
  if (list == nullptr) return result;
  for (const auto& item : list->items) {
    const YamlValue& id = item.is_map() ? *item.find("id") : item;
    result.push_back({{id.text, id.span}, read_config(item.find("when"))});
  }
  return result;
}

std::vector<PortManifest> read_ports(const YamlValue& root, const char* key,
                                     Diagnostics& diagnostics) {
  std::vector<PortManifest> result;
  const YamlValue* map = root.find(key);
  if (map == nullptr) return result;
  for (const auto& entry : map->entries) {
    PortManifest port;
    port.name = {entry.key, entry.key_span};
    port.space.span = entry.key_span;
    if (const YamlValue* space = entry.value.find("space")) port.space = read_space(*space);
    port.unit = text_at(entry.value, "unit");
    port.about = text_at(entry.value, "about");
    const YamlValue* eagerx = entry.value.find("eagerx");
    port.eagerx = eagerx != nullptr ? eagerx->text : entry.key;
    if (const YamlValue* rate = entry.value.find("rate")) port.rate = read_quantity(*rate);
    port.settings = read_connection_settings(entry.value, diagnostics);
    port.optional = text_at(entry.value, "optional") == "true";
    port.tunes_running = text_at(entry.value, "tunable") == "running";
    result.push_back(std::move(port));
  }
  return result;
}

/// `tick` is the engine's own message: its space is always the same.
void complete_tick(std::vector<PortManifest>& inputs, const YamlValue& root,
                   Diagnostics& diagnostics) {
  for (auto& input : inputs) {
    if (input.name.value != "tick") continue;
    const YamlValue* written = root.find("inputs")->find("tick");
    if (const YamlValue* space = written->find("space")) {
      diagnostics.error("E0208", space->span, "`space` does nothing for `tick`").help =
          "leave it out: the engine's tick is always an int64";
    }
    input.space.dtype = Spanned<std::string>{"int64", input.name.span};
    input.space.shape = made_list({}, input.name.span);
  }
}

std::vector<EntitySpec> read_entities(const YamlValue& root, const char* key,
                                      Diagnostics& diagnostics) {
  std::vector<EntitySpec> result;
  const YamlValue* map = root.find(key);
  if (map == nullptr) return result;
  for (const auto& entry : map->entries) {
    result.push_back(read_entity(entry.key, entry.key_span, entry.value, diagnostics));
  }
  return result;
}

/// An output may have the space of an input of the same entity, and of nothing else.
void check_like(const Entity& entity, Diagnostics& diagnostics) {
  const std::vector<std::string> known = names_of(entity.inputs);
  for (const PortManifest& output : entity.outputs) {
    const auto& like = output.space.like;
    if (!like || contains(known, like->value)) continue;
    auto& problem = diagnostics.error(
        "E0309", like->span, fmt::format("`{}` has no input `{}`", entity.id.value, like->value));
    problem.label = fmt::format("`{}` needs its space", output.name.value);
    problem.help =
        did_you_mean(like->value, known,
                     known.empty() ? "write `dtype` and `shape`: it has no inputs"
                                   : fmt::format("its inputs are {}", join(known, ", ")));
  }
}

/// The include is the header's full path here; load_library makes it relative to its root.
CppClass read_cpp(const YamlValue& yaml, const fs::path& folder, Diagnostics& diagnostics) {
  CppClass result;
  if (const YamlValue* name = yaml.find("class")) {
    check_class(*name, diagnostics);
    result.span = name->span;
  }
  result.name = text_at(yaml, "class");
  const std::string header = text_at(yaml, "header");
  if (!header.empty()) {
    result.header = yaml.find("header")->span;
    result.include = (folder / header).lexically_normal().string();
  }
  return result;
}

/// A node has a class in C++, or is written in Python, or both.
void read_python(const YamlValue& root, const fs::path& folder, Entity& entity,
                 Diagnostics& diagnostics) {
  if (entity.kind != EntityKind::node || entity.composite) return;
  const std::string file = text_at(root, "python");
  if (!file.empty()) entity.python = (folder / file).lexically_normal().string();
  const bool has_header = root.find("header") != nullptr, has_class = root.find("class") != nullptr;
  if (has_header && has_class) return;
  if (has_header != has_class || file.empty())
    diagnostics.error("E0202", root.span,
                      fmt::format("missing key `{}` in a node", has_header ? "class" : "header"));
}

EntityKind entity_kind(const std::string& word) {
  if (word == "engine") return EntityKind::engine;
  if (word == "engine_node") return EntityKind::engine_node;
  if (word == "engine_state") return EntityKind::engine_state;
  if (word == "object") return EntityKind::object;
  return word == "processor" ? EntityKind::processor : EntityKind::node;
}

PortManifest only_port(const YamlValue& root, const char* key) {
  PortManifest port;
  port.name = {key, root.span};
  port.space.span = root.span;
  if (const YamlValue* space = root.find(key)) port.space = read_space(*space);
  return port;
}

/// A sensor ends inside of the object: it is received where the graph connects it.
void refuse_settings_of_sensors(const std::vector<ConnectionSpec>& connections,
                                Diagnostics& diagnostics) {
  for (const auto& connection : connections) {
    const PortName to = parse_port(connection.to.value);
    if (to.owner != "sensors") continue;
    const auto refuse = [&](const char* key, const auto& setting, const std::string& help) {
      if (!setting) return;
      auto& problem = diagnostics.error(
          "E0208", setting->span,
          fmt::format("`{}` does nothing on a connection to `{}`", key, connection.to.value));
      problem.label = "nothing receives messages here";
      problem.help = help;
    };
    const std::string of_graph =
        fmt::format("write it where the graph connects the sensor `{}`", to.within_owner());
    const ConnectionSettings& settings = connection.settings;
    refuse("window", settings.window, of_graph);
    refuse("skip", settings.skip, of_graph);
    const auto of_sensor = [&](const char* key) {
      return fmt::format("write it for the sensor: `sensors: {{{}: {{{}: …}}}}`", to.within_owner(),
                         key);
    };
    refuse("delay", settings.delay, of_sensor("delay"));
    refuse("delay", settings.random_delay, of_sensor("max_delay"));
    refuse("max_delay", settings.max_delay, of_sensor("max_delay"));
  }
}

ObjectEngine read_implementation(const Spanned<std::string>& engine, const YamlValue& yaml,
                                 const fs::path& folder, Diagnostics& diagnostics) {
  ObjectEngine result;
  result.engine = engine;
  result.model = read_cpp(*yaml.find("model"), folder, diagnostics);
  result.vectorized = text_at(*yaml.find("model"), "vectorized") == "true";
  result.summary = text_at(yaml, "summary");
  result.description = text_at(yaml, "description");
  result.nodes = read_entities(yaml, "nodes", diagnostics);
  result.connections = read_connections(yaml.find("connections"), diagnostics);
  refuse_settings_of_sensors(result.connections, diagnostics);
  const YamlValue* states = yaml.find("states");
  for (const auto& entry : states != nullptr ? states->entries : std::vector<YamlValue::Entry>{}) {
    const YamlValue* owner = entry.value.find("node");
    if ((owner != nullptr) == (entry.value.find("type") != nullptr)) {
      diagnostics.error("E0206", entry.key_span,
                        fmt::format("`{}` needs either a `type` (an engine state) or a `node` (the "
                                    "state of an engine node)",
                                    entry.key));
    } else if (owner != nullptr) {
      if (const YamlValue* config = entry.value.find("config")) {
        diagnostics.error("E0208", config->span, "`config` does nothing next to `node`").help =
            "write it for that node";
      }
      result.node_states.push_back({{entry.key, entry.key_span}, {owner->text, owner->span}});
    } else {
      result.states.push_back(read_entity(entry.key, entry.key_span, entry.value, diagnostics));
    }
  }
  return result;
}

/// The size in `[0x20000000, 128K]`; nullopt for what a person has still to fill in.
std::optional<std::uint64_t> size_of_memory(const std::vector<std::string>& texts) {
  if (texts.size() != 2) return std::nullopt;
  const auto bytes = parse_bytes(texts[1]);
  return bytes == 0U ? std::nullopt : bytes;
}

/// The manifest with its rates in Hz and its times in seconds, if it has the form of its kind.
std::optional<YamlValue> checked(const YamlValue& root, Diagnostics& diagnostics) {
  const YamlValue* kind = root.is_map() ? root.find("kind") : nullptr;
  if (kind == nullptr || manifest_format(kind->text) == nullptr) {
    auto& problem =
        kind == nullptr
            ? diagnostics.error("E0202", root.span, "a manifest needs its `kind`")
            : diagnostics.error("E0204", kind->span,
                                fmt::format("{} is not a kind of manifest", describe(*kind)));
    problem.help =
        did_you_mean(kind != nullptr ? kind->text : "", manifest_kinds(),
                     fmt::format("write `kind:` and one of {}", join(manifest_kinds(), ", ")));
    return std::nullopt;
  }
  const Format* composite = root.find("graph") != nullptr ? composite_format(kind->text) : nullptr;
  const Format& format = composite != nullptr ? *composite : *manifest_format(kind->text);
  return check(root, format, diagnostics) ? std::optional(in_base_units(root, format))
                                          : std::nullopt;
}

}  // namespace

std::optional<Entity> read_entity_manifest(const YamlValue& written, const std::string& path,
                                           Diagnostics& diagnostics) {
  const std::optional<YamlValue> tree = checked(written, diagnostics);
  if (!tree) return std::nullopt;
  const YamlValue& root = *tree;
  const std::size_t errors_before = diagnostics.error_count();
  const fs::path folder = fs::path(path).parent_path();
  Entity entity;
  entity.kind = entity_kind(root.find("kind")->text);
  entity.id = {root.find("id")->text, root.find("id")->span};
  entity.eagerx_ids = read_eagerx_ids(root);
  entity.summary = text_at(root, "summary");
  entity.description = text_at(root, "description");
  entity.path = path;
  if (root.find("graph") != nullptr) entity.composite = std::make_shared<const YamlValue>(root);
  entity.cpp = read_cpp(root, folder, diagnostics);
  read_python(root, folder, entity, diagnostics);
  entity.counts = texts_at(root, "counts");
  entity.packages = texts_at(root, "pkg_config");
  if (const YamlValue* system = root.find("system")) entity.system = {system->text, system->span};
  if (const YamlValue* family = root.find("family")) entity.family = {family->text, family->span};
  entity.runs = texts_at(root, "runs");
  if (const YamlValue* clock = root.find("asynchronous"))
    entity.asynchronous = clock->text == "true";
  entity.config = read_parameters(root, diagnostics);
  entity.inputs = read_ports(root, "inputs", diagnostics);
  complete_tick(entity.inputs, root, diagnostics);
  entity.outputs = read_ports(root, "outputs", diagnostics);
  entity.states = read_ports(root, "states", diagnostics);
  add_tunable_states(entity);
  entity.sensors = read_ports(root, "sensors", diagnostics);
  entity.actuators = read_ports(root, "actuators", diagnostics);
  entity.reset_targets = read_ports(root, "targets", diagnostics);
  if (entity.kind == EntityKind::engine_state || entity.kind == EntityKind::engine_node) {
    entity.engines = texts_at(root, "engines");
  }
  if (entity.kind == EntityKind::engine_state) {
    entity.states = {only_port(root, "space")};
    entity.moves = texts_at(root, "moves");
  }
  if (entity.kind == EntityKind::processor) {
    entity.inputs = {only_port(root, "input")};
    entity.outputs = {only_port(root, "output")};
  }
  check_like(entity, diagnostics);
  if (const YamlValue* simulator = root.find("simulator"))
    entity.simulator = read_cpp(*simulator, folder, diagnostics);
  if (entity.kind == EntityKind::object && root.find("engines") != nullptr) {
    for (const auto& entry : root.find("engines")->entries) {
      entity.object_engines.push_back(
          read_implementation({entry.key, entry.key_span}, entry.value, folder, diagnostics));
    }
  }
  if (root.find("kind")->text == "reset_node" &&
      (!entity.is_reset_node() || entity.outputs.empty()))
    diagnostics.error("E0206", entity.id.span,
                      "a reset node has at least one output and one target");
  entity.requirements = read_requirements(root, entity, diagnostics);
  entity.vectorized = read_vectorized(root, entity, diagnostics);
  entity.simd_registers = text_at(root, "simd_registers");
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  return entity;
}

std::optional<Implementation> read_implementation_manifest(const YamlValue& written,
                                                           const std::string& path,
                                                           Diagnostics& diagnostics) {
  const std::optional<YamlValue> tree = checked(written, diagnostics);
  if (!tree) return std::nullopt;
  const YamlValue& root = *tree;
  const std::size_t errors_before = diagnostics.error_count();
  const YamlValue& object = *root.find("object");
  const YamlValue& engine = *root.find("engine");
  Implementation result{{object.text, object.span},
                        read_implementation({engine.text, engine.span}, root,
                                            fs::path(path).parent_path(), diagnostics)};
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  return result;
}

namespace {

/// Conditions that the time of instructions depends on.
void read_timing(const YamlValue& root, Target& target) {
  target.cpu = text_at(root, "cpu");
  if (const auto hz = parse_int(text_at(root, "clock_hz")); hz && *hz > 0)
    target.clock_hz = static_cast<std::uint64_t>(*hz);
  if (const YamlValue* states = root.find("wait_states"))
    target.wait_states = static_cast<unsigned>(parse_int(states->text).value_or(0));
  const YamlValue* interrupts = root.find("interrupts");
  if (interrupts == nullptr) return;
  std::vector<std::string> texts;
  for (const auto& entry : interrupts->entries) {
    const double hz = Rational::parse(entry.value.text).value_or(Rational()).to_double();
    target.interrupts.emplace_back(entry.key, hz);
    texts.push_back(fmt::format("{} {:g} Hz", entry.key, hz));
  }
  target.facts.emplace_back("interrupts", join(texts, ", "));
}

}  // namespace

std::optional<Target> read_target_manifest(const YamlValue& written, const std::string& path,
                                           Diagnostics& diagnostics) {
  const std::optional<YamlValue> tree = checked(written, diagnostics);
  if (!tree) return std::nullopt;
  const YamlValue& root = *tree;
  Target target;
  target.id = {root.find("id")->text, root.find("id")->span};
  target.summary = text_at(root, "summary");
  target.description = text_at(root, "description");
  const auto read_templates = [&](const char* key, auto& into) {
    const YamlValue* templates = root.find(key);
    if (templates == nullptr) return;
    for (const auto& entry : templates->entries)
      into.emplace_back((fs::path(path).parent_path() / entry.key).string(), entry.value.text);
  };
  read_templates("templates", target.templates);
  read_templates("partner", target.partner);
  read_templates("yours", target.yours);
  target.language = text_at(root, "language");
  if (target.language.empty() && root.find("cmake") == nullptr)
    diagnostics.error("E0202", target.id.span, "missing key `cmake` in a target");
  target.vectorized = text_at(root, "vectorized") == "true";
  target.derivatives = text_at(root, "derivatives") == "true";
  target.cmake = text_at(root, "cmake");
  target.toolchain = text_at(root, "toolchain");
  target.system = text_at(root, "system");
  target.family = text_at(root, "family");
  for (const char* key : {"cpu", "clock_hz", "wait_states", "baud", "toolchain", "image"}) {
    if (const YamlValue* value = root.find(key)) target.facts.emplace_back(key, value->text);
  }
  for (const char* key : {"flash", "ram", "run"}) {
    if (root.find(key) != nullptr)
      target.facts.emplace_back(key, fmt::format("{}", join(texts_at(root, key), ", ")));
  }
  read_timing(root, target);
  if (const YamlValue* baud = root.find("baud"))
    target.baud = static_cast<std::uint32_t>(parse_int(baud->text).value_or(0));
  target.ram_bytes = size_of_memory(texts_at(root, "ram"));
  target.run = texts_at(root, "run");
  target.image = text_at(root, "image");
  return target;
}

}  // namespace eagerx::gen
