// Entities to write in C++ before a file runs: interfaces as saved, as manifests.
#include <fmt/format.h>

#include <algorithm>

#include "generator/frontend/import/implementation.hpp"
#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/import/written.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {

std::string type_of_parameter(const YamlValue& value) {
  if (is_python_object(value)) return "";
  if (value.is_scalar()) {
    if (value.quoted) return "string";
    if (parse_bool(value.text)) return "bool";
    if (parse_int(value.text)) return "int";
    return parse_number(value.text) ? "float" : "string";
  }
  if (joined_names(value)) return "string";
  if (!value.is_sequence()) return "";
  bool whole = true;
  for (const auto& item : value.items) {
    if (!item.is_scalar() || item.quoted || !parse_number(item.text)) return "";
    whole = whole && parse_int(item.text).has_value();
  }
  return whole ? "ints" : "floats";
}

std::optional<SpaceSpec> whole_space(const SavedPort& port) {
  auto space = saved_space(port);
  if (!space || space->shape) return space;
  for (const auto& bound : {space->low, space->high}) {
    if (!bound || !bound->is_sequence()) continue;
    const std::string length = fmt::format("{}", bound->items.size());
    space->shape = made_list({made_scalar(length, bound->span)}, bound->span);
    return space;
  }
  return space;
}

bool is_parameter_of_manifest(const YamlValue::Entry& entry) {
  return !is_common_parameter(entry.key) && !entry.value.is_null() &&
         !type_of_parameter(entry.value).empty() && is_identifier(legal_name(entry.key));
}

namespace {

class ManifestWriter {
 public:
  ManifestWriter(const std::string& id, const Missing& missing, const std::string& engine,
                 SavedImplementation inside)
      : id_(id),
        missing_(missing),
        saved_(missing.saved),
        engine_(engine),
        inside_(std::move(inside)) {}

  MissingEntity write(const std::string& type) {
    made_.id = id_;
    made_.kind = kind();
    made_.type = type;
    for (const auto& user : missing_.users) made_.users.push_back(user.first);
    line(fmt::format("kind: {}", made_.kind));
    line(fmt::format("id: {}", type));
    line(fmt::format("eagerx: [{}]", yaml_text(id_)));
    line(fmt::format("summary: {}", yaml_text("What " + id_ + " does in EAGERx.")));
    if ((made_.kind == "engine_node" || made_.kind == "engine_state") && !engine_.empty())
      line(fmt::format("engines: [{}]", engine_));
    add_parameters();
    add_ports();
    return std::move(made_);
  }

 private:
  void line(const std::string& text) { made_.manifest += text + "\n"; }

  /// "eagerx: 'a b', " where EAGERx's name cannot be one here.
  static std::string named_in_eagerx(const std::string& name) {
    return legal_name(name) == name ? "" : fmt::format("eagerx: {}, ", yaml_text(name));
  }

  std::string kind() const {
    if (missing_.use == Use::node && !list_of("targets").empty()) return "reset_node";
    std::string name = to_string(missing_.use);
    std::ranges::replace(name, ' ', '_');
    return name;
  }

  const std::vector<SavedPort>& list_of(const std::string& section) const {
    static const std::vector<SavedPort> kNone;
    const auto found = saved_.ports.find(section);
    return found == saved_.ports.end() ? kNone : found->second;
  }

  void add_parameters() {
    std::vector<std::string> lines;
    for (const auto& entry : saved_.config.entries) {
      if (is_common_parameter(entry.key)) continue;
      const std::string name = legal_name(entry.key);
      const std::string type = type_of_parameter(entry.value);
      if (!is_parameter_of_manifest(entry)) {
        lines.push_back(fmt::format("  # {}: {}", in_comment(entry.key),
                                    entry.value.is_null() ? "None in the file, so of any type"
                                                          : "of a type that C++ does not have"));
        continue;
      }
      const auto names = joined_names(entry.value);
      lines.push_back(fmt::format(
          "  {}: {{{}type: {}, default: {}, about: {}}}", yaml_text(name),
          named_in_eagerx(entry.key), type, names ? yaml_text(*names) : text_of(entry.value),
          yaml_text(names ? entry.key + ", with blanks between them" : entry.key)));
    }
    const bool any = ranges::any_of(lines, [](const auto& text) { return text[2] != '#'; });
    if (!lines.empty()) line(any ? "config:" : "# config:");
    for (const auto& text : lines) line(text);
  }

  void add_ports() {
    if (made_.kind == "processor") return line("output: {like: input}");
    if (made_.kind == "engine_state") return add_space_of_state();
    if (made_.kind == "engine") return add_states();
    if (made_.kind == "object") {
      add_section("sensors", nullptr);
      add_section("actuators", nullptr);
      add_states();
      add_implementation();
      return;
    }
    add_section("inputs", &made_.inputs);
    add_section("outputs", &made_.outputs);
    if (made_.kind == "reset_node") add_section("targets", &made_.targets);
    add_states();
  }

  void add_states() {
    add_section("states", &made_.states);
    if (list_of("states").empty() && !inside_.states.empty()) line("states:");
    for (const auto& state : inside_.states) line("  " + state);
  }

  /// A folder knows the header of the model.
  void add_implementation() {
    if (inside_.empty() || engine_.empty()) {
      line("# engines: how it is made on each engine: `eagerx-gen new object` makes an example");
      return line("# (a file of BaseEnv.save says it, and then it is made of that)");
    }
    made_.engine = engine_;
    made_.model = inside_.parameters;
    made_.implementation = inside_.lines;
  }

  void add_space_of_state() {
    for (const auto& port : list_of("states")) {
      auto space = saved_space(port);
      if (!space) continue;
      space->low.reset();
      space->high.reset();
      if (space->dtype || space->shape) line("space: " + space_text(*space));
    }
  }

  void add_section(const std::string& section, std::vector<MissingEntity::Port>* into) {
    const auto& ports = list_of(section);
    if (!ports.empty()) line(section + ":");
    for (const auto& port : ports) {
      if (section == "inputs" && port.name.value == "tick") {
        line("  tick: {about: the engine's tick}");
        continue;
      }
      const bool optional = (section == "inputs" || section == "outputs") &&
                            !saved_.is_selected(section, port.name.value) &&
                            made_.kind != "engine_node";
      const auto space = whole_space(port);
      const bool known = space && (space->shape || port.has_spaces_apart);
      const std::string like = known ? "" : space_like(section);
      const std::string text = !like.empty() ? like : space ? space_text(*space) : "";
      const std::string name = legal_name(port.name.value);
      line(fmt::format("  {}: {}", yaml_text(name), port_text(section, port, text, optional)));
      if (into != nullptr) into->push_back({name, text, optional});
    }
  }

  /// An input without a space in EAGERx is most often the applied action.
  [[nodiscard]] std::string space_like(const std::string& section) const {
    if (section != "outputs" || made_.kind != "engine_node") return "";
    std::vector<std::string> inputs;
    for (const auto& input : list_of("inputs")) {
      if (input.name.value != "tick") inputs.push_back(legal_name(input.name.value));
    }
    return inputs.size() == 1 ? fmt::format("{{like: {}}}", yaml_text(inputs.front())) : "";
  }

  [[nodiscard]] std::string port_text(const std::string& section, const SavedPort& port,
                                      const std::string& space, bool optional) const {
    std::vector<std::string> items;
    const bool object = section == "sensors" || section == "actuators";
    if (const std::string name = named_in_eagerx(port.name.value); !name.empty())
      items.push_back(name.substr(0, name.size() - 2));
    if (optional) items.emplace_back("optional: true");
    if (const YamlValue* rate = port.find("rate"); object && rate != nullptr) {
      const auto value = meant_number(*rate);
      items.push_back("rate: " + (value ? value->to_string() : text_of(*rate)));
    }
    if (!space.empty()) items.push_back("space: " + space);
    // Those of an engine node's input belong to its connection.
    if ((section == "inputs" && made_.kind != "engine_node") || section == "actuators") {
      if (const YamlValue* window = port.find("window"); window != nullptr && window->text != "1")
        items.push_back("window: " + text_of(*window));
      if (const YamlValue* skip = port.find("skip"); skip != nullptr && skip->text == "true")
        items.emplace_back("skip: true");
    }
    items.push_back("about: " + yaml_text(port.name.value));
    return fmt::format("{{{}}}", join(items, ", "));
  }

  const std::string& id_;
  const Missing& missing_;
  const SavedEntity& saved_;
  const std::string& engine_;
  const SavedImplementation inside_;
  MissingEntity made_;
};

/// The class's own name, if it is free here.
std::string free_type(const std::string& id, const Library& library, std::set<std::string>& taken) {
  std::string name = id.substr(id.rfind('/') + 1);
  std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  if (!is_identifier(name)) name = "Entity" + name;
  std::string type = name;
  for (int i = 1; library.all_entities().contains(type) || !taken.insert(type).second; ++i)
    type = i == 1 ? "Own" + name : fmt::format("Own{}{}", name, i);
  return type;
}

}  // namespace

std::optional<std::vector<MissingEntity>> missing_entities(const YamlValue& root,
                                                           const Library& library,
                                                           const ImportOptions& options,
                                                           Diagnostics& diagnostics) {
  auto saved = read_saved_graph(root, diagnostics);
  if (!saved) return std::nullopt;
  EntityMapping mapping(library, diagnostics);
  remove_pictures(*saved, mapping);
  rename_ports(*saved, mapping);
  require_all(*saved, mapping);
  std::set<std::string> taken;
  std::map<std::string, std::string> types;
  for (const auto& [id, missing] : mapping.missing()) types[id] = free_type(id, library, taken);
  std::string engine = options.engine;
  if (const SavedEntity* own = saved->find("engine"); own != nullptr && engine.empty()) {
    const Entity* known = mapping.look_up(own->id.value, own->config, Use::engine);
    engine = known != nullptr ? known->id.value : types[own->id.value];
  }
  std::vector<MissingEntity> result;
  for (const auto& [id, missing] : mapping.missing()) {
    SavedImplementation inside;
    if (missing.use == Use::object)
      inside = saved_implementation(*saved, missing.saved, mapping, types);
    result.push_back(ManifestWriter(id, missing, engine, std::move(inside)).write(types.at(id)));
  }
  return result;
}

}  // namespace eagerx::gen
