#include "generator/frontend/import/implementation.hpp"

#include <fmt/format.h>

#include <set>

#include "generator/frontend/import/port_match.hpp"
#include "generator/frontend/import/translate.hpp"
#include "generator/frontend/import/written.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

class ImplementationWriter {
 public:
  ImplementationWriter(const SavedGraph& saved, const SavedEntity& object, EntityMapping& mapping,
                       const MadeTypes& types)
      : saved_(saved), backup_(object), mapping_(mapping), types_(types) {}

  SavedImplementation write() {
    for (const auto& object : saved_.objects) {
      const SavedEntity* backup = find_named(saved_.backup, object.name.value);
      if (backup != nullptr && backup->id.value == backup_.id.value) add_object(object, *backup);
    }
    add("nodes", nodes_);
    add("connections", connections_);
    add("states", states_);
    return std::move(result_);
  }

 private:
  void add(const char* heading, const std::vector<std::string>& lines) {
    if (!lines.empty()) result_.lines.push_back(fmt::format("{}:", heading));
    for (const auto& line : lines) result_.lines.push_back("  " + line);
  }

  void add_object(const SavedObject& object, const SavedEntity& backup) {
    const PortMatch match = match_ports(saved_, object, backup);
    const std::string prefix = object.name.value + "/";
    for (const auto& entity : saved_.entities) {
      if (!entity.name.value.starts_with(prefix)) continue;
      const std::string local = entity.name.value.substr(prefix.size());
      if (seen_.insert(local).second) add_node(local, entity, match);
    }
    for (const auto& [sensor, place] : match.sensors) {
      const SavedEntity* node = saved_.find(prefix + place.first);
      const SavedPort* output = node != nullptr ? node->port("outputs", place.second) : nullptr;
      connect(fmt::format("{}.{}", place.first, place.second), "sensors." + sensor,
              processor(output));
    }
    for (const auto& [actuator, place] : match.actuators)
      connect("actuators." + actuator, fmt::format("{}.{}", place.first, place.second), "");
    for (const auto& link : saved_.links) add_inside(link, prefix);
    for (const auto& [node, port] : match.open) {
      const std::string line = fmt::format("# {}.{} is in use, but the file does not say as what",
                                           in_comment(node), in_comment(port));
      if (linked_.insert(line).second) connections_.push_back(line);
    }
    for (const auto& state : object.engine_states) add_state(state, object);
    if (!result_.parameters.empty()) return;
    for (const auto& entry : object.parameters.entries) {
      if (entry.key != "name")
        result_.parameters.push_back(fmt::format("{}: {}", entry.key, text_of(entry.value)));
    }
  }

  void connect(const std::string& from, const std::string& to, const std::string& settings) {
    if (!linked_.insert(from + " " + to).second) return;
    connections_.push_back(
        fmt::format("- {{from: {}, to: {}{}}}", yaml_scalar(from), yaml_scalar(to), settings));
  }

  void add_node(const std::string& name, const SavedEntity& node, const PortMatch& match) {
    auto [type, config] = typed(node.id, node.config, Use::engine_node, node.name.value);
    add_sizes(node, config);
    std::vector<std::string> items = {"type: " + yaml_scalar(type),
                                      "rate: " + rate(name, node, match)};
    if (!config.empty()) items.push_back("config: " + config_text(config));
    const Entity* known = mapping_.look_up(node.id.value, node.config, Use::engine_node);
    if (known == nullptr) add_spaces(name, node, match, items);
    if (known != nullptr) note_required(*known, config);
    nodes_.push_back(fmt::format("{}: {}", yaml_text(name), in_braces(items)));
    for (const auto& state : node.selected.at("states")) add_state_of_node(name, node, state.value);
  }

  static YamlValue as_written(const YamlValue& value) {
    const auto names = joined_names(value);
    return names ? made_scalar(*names, value.span) : value;
  }

  /// A manifest leaves open what its users do not share.
  void add_spaces(const std::string& local, const SavedEntity& node, const PortMatch& match,
                  std::vector<std::string>& items) const {
    const auto missing = mapping_.missing().find(node.id.value);
    std::vector<std::string> outputs;
    bool open = false;
    for (const auto& name : node.selected.at("outputs")) {
      const SavedPort* port = node.port("outputs", name.value);
      const SavedPort* shared = missing != mapping_.missing().end()
                                    ? missing->second.saved.port("outputs", name.value)
                                    : nullptr;
      const auto space = space_of({local, name.value}, port, match);
      const auto known = shared != nullptr ? whole_space(*shared) : std::nullopt;
      const bool differs = space && (!known || (space->shape && !known->shape));
      open = open || differs;
      outputs.push_back(
          differs ? fmt::format("{}: {{space: {}}}", yaml_text(name.value), space_text(*space))
                  : fmt::format("{}: {{}}", yaml_text(name.value)));
    }
    if (open) items.push_back("outputs: " + in_braces(outputs));
  }

  /// As saved, else that of the sensor which the output stands for.
  [[nodiscard]] std::optional<SpaceSpec> space_of(const InsidePort& place, const SavedPort* port,
                                                  const PortMatch& match) const {
    auto own = port != nullptr ? whole_space(*port) : std::nullopt;
    if (own && own->shape) return own;
    for (const auto& [sensor, inside] : match.sensors) {
      const SavedPort* outside = backup_.port("sensors", sensor);
      if (inside == place && outside != nullptr) return whole_space(*outside);
    }
    return own;
  }

  /// Parameters that say how long an output is: EAGERx has that from what the node sends.
  void add_sizes(const SavedEntity& node, std::vector<Setting>& config) {
    const Entity* known = mapping_.look_up(node.id.value, node.config, Use::engine_node);
    if (known == nullptr) return;
    for (const auto& output : known->outputs) {
      const auto& shape = output.space.shape;
      const SavedPort* port = node.port("outputs", output.name.value);
      const auto space = port != nullptr ? whole_space(*port) : std::nullopt;
      if (!shape || shape->items.size() != 1 || !space || !space->shape ||
          space->shape->items.size() != 1)
        continue;
      for (const auto& parameter : known->config) {
        const YamlValue& length = space->shape->items[0];
        if (reference_in(shape->items[0]) != parameter_reference(parameter.name.value)) continue;
        if (ranges::any_of(config,
                           [&](const Setting& s) { return s.name == parameter.name.value; }) ||
            (parameter.fallback && same_value(*parameter.fallback, length)))
          continue;
        if (port->find("processor") != nullptr && !parameter.fallback) continue;  // is asked for
        if (port->find("processor") != nullptr) {
          nodes_.push_back(fmt::format("# fill in {} of the next one: a processor hides it",
                                       parameter.name.value));
          continue;
        }
        config.push_back({parameter.name.value, port->name.span, length});
      }
    }
  }

  void note_required(const Entity& known, const std::vector<Setting>& config) {
    std::vector<std::string> names;
    for (const auto& parameter : known.config) {
      const bool given =
          ranges::any_of(config, [&](const Setting& s) { return s.name == parameter.name.value; });
      if (!given && !parameter.fallback) names.push_back(parameter.name.value);
    }
    if (!names.empty())
      nodes_.push_back(fmt::format("# fill in {} of the next one: the file has no such thing",
                                   join(names, ", ")));
  }

  /// The sensor's or actuator's rate, which a graph may change, else the number of the file.
  [[nodiscard]] std::string rate(const std::string& name, const SavedEntity& node,
                                 const PortMatch& match) const {
    for (const bool selected : {true, false}) {
      for (const auto& [section, matched] :
           {std::pair{"sensors", &match.sensors}, {"actuators", &match.actuators}}) {
        for (const auto& [port, place] : *matched) {
          if (place.first == name && is_identifier(port) &&
              (!selected || backup_.is_selected(section, port)))
            return in_dollars(rate_reference(section, port));
        }
      }
    }
    const YamlValue* rate = node.parameter("rate");
    if (rate == nullptr) return "1  # the file has none";
    const auto value = meant_number(*rate);
    return value ? value->to_string() : text_of(*rate);
  }

  /// Our type and its parameters, or those of the class that has to be written.
  std::pair<std::string, std::vector<Setting>> typed(const Spanned<std::string>& id,
                                                     const YamlValue& config, Use use,
                                                     const std::string& user) {
    if (const Entity* known = mapping_.look_up(id.value, config, use))
      return {known->id.value, mapping_.settings(*known, config, fmt::format("`{}`", user))};
    std::vector<Setting> settings;
    for (const auto& entry : config.entries) {
      if (is_parameter_of_manifest(entry))
        settings.push_back({legal_name(entry.key), entry.key_span, as_written(entry.value)});
    }
    const auto made = types_.find(id.value);
    return {made != types_.end() ? made->second : id.value, std::move(settings)};
  }

  void add_state(const SavedPort& state, const SavedObject& object) {
    const YamlValue* made = state.find("state");
    const YamlValue* type = made != nullptr ? made->find("state_type") : nullptr;
    const std::string& name = state.name.value;
    if (type == nullptr || !type->is_scalar() || !stated_.insert(name).second) return;
    const auto [id, config] = typed({type->text, type->span}, *made, Use::engine_state,
                                    fmt::format("{}.{}", object.name.value, name));
    std::vector<std::string> items = {"type: " + yaml_scalar(id)};
    if (!config.empty()) items.push_back("config: " + config_text(config));
    states_.push_back(fmt::format("{}: {}", yaml_text(name), in_braces(items)));
  }

  /// An object here has the states of its engine nodes; EAGERx keeps them apart.
  void add_state_of_node(const std::string& node, const SavedEntity& entity,
                         const std::string& state) {
    const auto is_taken = [&](const std::string& name) {
      return stated_.contains(name) ||
             ranges::any_of(saved_.objects, [&](const SavedObject& object) {
               return find_named(object.engine_states, name) != nullptr;
             });
    };
    const bool own = backup_.port("states", state) != nullptr && !is_taken(state);
    const std::string name = own || !is_taken(state) ? state : fmt::format("{}_{}", node, state);
    if (!stated_.insert(name).second) return;
    states_.push_back(
        fmt::format("{}: {{node: {}}}", yaml_text(name), yaml_scalar(node + "." + state)));
    if (own) return;
    const SavedPort* port = entity.port("states", state);
    const auto space = port != nullptr ? saved_space(*port) : std::nullopt;
    result_.states.push_back(
        fmt::format("{}: {{{}about: {}}}", yaml_text(name),
                    space ? fmt::format("space: {}, ", space_text(*space)) : "",
                    yaml_text(node + "." + state)));
  }

  void add_inside(const SavedLink& link, const std::string& prefix) {
    if (!link.from.entity.starts_with(prefix) || !link.to.entity.starts_with(prefix)) return;
    const auto local = [&](const SavedEnd& end) {
      return fmt::format("{}.{}", end.entity.substr(prefix.size()), end.port);
    };
    const SavedEntity* to = saved_.find(link.to.entity);
    const SavedPort* port = to != nullptr ? to->port("inputs", link.to.port) : nullptr;
    std::string settings;
    for (const auto& [key, usual] : {std::pair{"window", "1"}, {"delay", "0"}, {"skip", "false"}}) {
      const YamlValue* value = port != nullptr ? port->find(key) : nullptr;
      if (value == nullptr) continue;
      const auto number = meant_number(*value);
      const std::string text = number ? number->to_string() : text_of(*value);
      if (text != usual) settings += fmt::format(", {}: {}", key, text);
    }
    connect(local(link.from), local(link.to), settings + processor(port));
  }

  std::string processor(const SavedPort* port) {
    const YamlValue* saved = port != nullptr ? port->find("processor") : nullptr;
    const YamlValue* type = saved != nullptr ? saved->find("processor_type") : nullptr;
    if (type == nullptr || !type->is_scalar()) return "";
    const YamlValue* config = saved->find("config");
    const YamlValue& parameters = config != nullptr && config->is_map() ? *config : *saved;
    const auto [id, settings] =
        typed({type->text, type->span}, parameters, Use::processor, port->name.value);
    return ", processor: " + processor_text({{id, type->span}, settings});
  }

  const SavedGraph& saved_;
  const SavedEntity& backup_;
  EntityMapping& mapping_;
  const MadeTypes& types_;
  SavedImplementation result_;
  std::vector<std::string> nodes_, connections_, states_;
  std::set<std::string> seen_, linked_, stated_;  // nodes, connections, states that are written
};

}  // namespace

SavedImplementation saved_implementation(const SavedGraph& saved, const SavedEntity& object,
                                         EntityMapping& mapping, const MadeTypes& types) {
  return ImplementationWriter(saved, object, mapping, types).write();
}

}  // namespace eagerx::gen
