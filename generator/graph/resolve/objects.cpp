#include "generator/graph/resolve/objects.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "generator/frontend/read/number.hpp"
#include "generator/graph/resolve/ports.hpp"
#include "generator/graph/resolve/prune.hpp"
#include "generator/graph/resolve/safety.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// Names of the ports of objects that connections name, by object.
struct ConnectedOfObject {
  std::set<std::string> sensors, actuators;
};
using ConnectedPorts = std::map<std::string, ConnectedOfObject, std::less<>>;

/// Gathered once: a scan for each object would take a time that grows with the square of the graph.
ConnectedPorts connected_ports(const std::vector<ConnectionSpec>& connections) {
  ConnectedPorts result;
  for (const auto& connection : connections) {
    const PortName from = parse_port(connection.from.value);
    if (from.section.empty() || from.section == "sensors")
      result[from.owner].sensors.insert(from.name);
    const PortName to = parse_port(connection.to.value);
    if (to.section.empty() || to.section == "actuators") result[to.owner].actuators.insert(to.name);
  }
  return result;
}

/// Builds one object. Its engine nodes are drafted on their own first, pruned, and then moved to
/// the graph.
class ObjectBuilder {
 public:
  ObjectBuilder(UnresolvedGraph& draft, const EntitySpec& spec, const Entity& entity,
                const ObjectEngine& implementation, const ConnectedPorts& connected)
      : draft_(draft),
        spec_(spec),
        entity_(entity),
        implementation_(implementation),
        connected_(connected) {}

  void build() {
    const std::size_t errors_before = diagnostics().error_count();
    collect_references();
    select();
    draft_engine_nodes();
    connect_inside();
    // If the manifest contradicts itself, a name that the graph selects need not be what is wrong.
    if (diagnostics().error_count() == errors_before) report_unknown_selection();
    mark_needed();
    move_to_graph();
  }

 private:
  Diagnostics& diagnostics() { return draft_.diagnostics; }

  void add_rates(const char* kind, const std::vector<PortManifest>& ports,
                 const Selection& chosen) {
    for (const auto& port : ports) {
      YamlValue rate = value_of(*port.rate, references_, diagnostics());
      const ComponentSpec* set = find_component(chosen, port.name.value);
      if (set != nullptr && set->rate) rate = made_number(set->rate->value, set->rate->span);
      references_[rate_reference(kind, port.name.value)] = std::move(rate);
    }
  }

  void collect_references() {
    references_ = references_of(entity_, spec_.config);
    add_rates("sensors", entity_.sensors, spec_.sensors);
    add_rates("actuators", entity_.actuators, spec_.actuators);
    add_safe_actuators(draft_, spec_, entity_, references_);
  }

  /// Sensors and actuators in use: the connected ones and the listed ones.
  void select() {
    if (const auto found = connected_.find(spec_.name.value); found != connected_.end()) {
      sensors_ = found->second.sensors;
      actuators_ = found->second.actuators;
    }
    for (const auto& item : spec_.sensors.value_or(std::vector<ComponentSpec>()))
      sensors_.insert(item.name.value);
    for (const auto& item : spec_.actuators.value_or(std::vector<ComponentSpec>()))
      actuators_.insert(item.name.value);
  }

  void report_unknown_selection() {
    report_unknown(spec_.sensors, entity_.sensors, entity_, "sensor", diagnostics());
    report_unknown(spec_.actuators, entity_.actuators, entity_, "actuator", diagnostics());
  }

  void draft_engine_nodes() {
    for (const auto& spec : implementation_.nodes) {
      UnresolvedNode node;
      node.node.name = spec_.name.value + "/" + spec.name.value;
      node.node.role = NodeRole::engine_node;
      node.node.span = spec_.name.span;
      node.node.object = draft_.objects.size();
      node.node.rate_hz = rate_of(*spec.rate, references_, diagnostics()).value_or(Rational{});
      const Entity* entity =
          find_entity(draft_.library, spec.type, EntityKind::engine_node, diagnostics());
      node.node.entity = entity;
      if (entity != nullptr) add_ports(node, spec, *entity);
      nodes_.push_back(std::move(node));
    }
  }

  /// Parameters of a manifest's processor may refer to the object's.
  void bind(std::optional<ProcessorSpec>& processor) {
    if (!processor) return;
    for (ProcessorSpec& each : processor->before)
      each.config = substitute(each.config, references_, diagnostics());
    processor->config = substitute(processor->config, references_, diagnostics());
  }

  void add_ports(UnresolvedNode& node, const EntitySpec& spec, const Entity& entity) {
    const auto settings = substitute(spec.config, references_, diagnostics());
    node.node.config = resolve_config(draft_.library, entity, settings, spec.type.span,
                                      diagnostics(), draft_.safety);
    const References references = references_of(entity, settings);
    const Entity& engine = *draft_.engine();
    if (!entity.works_on(engine))
      report_wrong_engine(entity, engine, spec.type.span, diagnostics());
    report_unknown(spec.inputs, entity.inputs, entity, "input", diagnostics());
    report_unknown(spec.outputs, entity.outputs, entity, "output", diagnostics());
    for (const auto& port : entity.inputs) {
      if (spec.inputs && find_component(spec.inputs, port.name.value) == nullptr) continue;
      node.inputs.push_back(draft_input(port, node.node.name + "." + port.name.value,
                                        spec_.name.span, references, diagnostics()));
      if (port.name.value == "tick")
        node.inputs.back().edge = UnresolvedEdge{Graph::kEngine, 0, spec_.name.span};
    }
    for (const auto& port : entity.outputs) {
      if (spec.outputs && find_component(spec.outputs, port.name.value) == nullptr) continue;
      UnresolvedOutput output = draft_output(port, spec_.name.span, references, diagnostics());
      if (const ComponentSpec* set = find_component(spec.outputs, port.name.value)) {
        apply_overrides(output, *set, node.node.name + "." + port.name.value, diagnostics());
        bind(output.processor);
      }
      node.outputs.push_back(std::move(output));
    }
  }

  std::optional<std::size_t> find_node(const std::string& name, const Spanned<std::string>& port) {
    for (std::size_t i = 0; i < implementation_.nodes.size(); ++i) {
      if (implementation_.nodes[i].name.value == name) return i;
    }
    diagnostics().error("E0309", port.span,
                        fmt::format("this implementation has no engine node `{}`", name));
    return std::nullopt;
  }

  /// Whether there is an entity of its type; it was reported if not, and has no ports.
  [[nodiscard]] bool is_known(std::size_t node) const {
    return nodes_[node].node.entity != nullptr;
  }

  /// Index of a port by name, reported if it does not exist.
  template <class Ports>
  std::optional<std::size_t> find_port(const Ports& ports, const std::string& name,
                                       const Spanned<std::string>& port) {
    for (std::size_t i = 0; i < ports.size(); ++i) {
      if (ports[i].name == name) return i;
    }
    diagnostics().error("E0307", port.span, fmt::format("`{}` does not exist", port.value));
    return std::nullopt;
  }

  void connect_inside() {
    for (const auto& connection : implementation_.connections) {
      const PortName from = parse_port(connection.from.value);
      const PortName to = parse_port(connection.to.value);
      const std::string from_port = from.within_owner(), to_port = to.within_owner();
      if (from.owner == "actuators") {
        connect_actuator(connection, from_port, to.owner, to_port);
        continue;
      }
      const auto source = find_node(from.owner, connection.from);
      if (source && !is_known(*source)) continue;
      const auto output =
          source ? find_port(nodes_[*source].outputs, from_port, connection.from) : std::nullopt;
      if (!output) continue;
      if (to.owner == "sensors") {
        connect_sensor(connection, to_port, *source, *output);
        continue;
      }
      const auto sink = find_node(to.owner, connection.to);
      if (sink && !is_known(*sink)) continue;
      const auto input =
          sink ? find_port(nodes_[*sink].inputs, to_port, connection.to) : std::nullopt;
      if (!input || !is_free(nodes_[*sink].inputs[*input], connection)) continue;
      UnresolvedInput& port = nodes_[*sink].inputs[*input];
      port.settings = overlay(port.settings, connection.settings);
      bind(port.settings.processor);
      port.edge =
          UnresolvedEdge{*source, *output, connection.span};  // made a graph index when it moves
      links_.push_back({*source, *sink});
    }
  }

  bool is_free(const UnresolvedInput& input, const ConnectionSpec& connection) {
    if (!input.edge) return true;
    diagnostics()
        .error("E0311", connection.to.span,
               fmt::format("`{}` is connected twice", connection.to.value))
        .help = input.name == "tick" ? "`tick` always comes from the engine"
                                     : "an input takes one connection";
    return false;
  }

  void connect_actuator(const ConnectionSpec& connection, const std::string& name,
                        const std::string& to, const std::string& to_port) {
    const PortManifest* actuator = entity_.actuator(name);
    const auto sink = find_node(to, connection.to);
    const auto input =
        sink ? find_port(nodes_[*sink].inputs, to_port, connection.to) : std::nullopt;
    if (actuator == nullptr)
      diagnostics().error("E0307", connection.from.span,
                          fmt::format("`{}` has no actuator `{}`", entity_.id.value, name));
    if (actuator == nullptr || !input || !is_free(nodes_[*sink].inputs[*input], connection)) return;
    UnresolvedInput& port = nodes_[*sink].inputs[*input];
    port.settings =
        overlay(port.settings, manifest_settings(*actuator, references_, diagnostics()));
    port.settings = overlay(port.settings, connection.settings);
    port.written = spec_.name.value + "." + name;
    port.actuator = true;
    PartialSpace space = partial_space(actuator->space, references_, diagnostics());
    if (const ComponentSpec* set = find_component(spec_.actuators, name);
        set != nullptr && set->space) {
      space =
          narrow(space, partial_space(*set->space, {}, diagnostics()), port.written, diagnostics());
    }
    if (port.settings.processor) {
      bind(port.settings.processor);
      port.outside = space;
    } else {
      port.declared = narrow(port.declared, space, port.written, diagnostics());
    }
    check_rate(*actuator, "actuators", nodes_[*sink], connection.to.span);
    actuator_sinks_.push_back({name, *sink, *input});
  }

  void connect_sensor(const ConnectionSpec& connection, const std::string& name, std::size_t source,
                      std::size_t output) {
    const PortManifest* sensor = entity_.sensor(name);
    if (sensor == nullptr) {
      diagnostics().error("E0307", connection.to.span,
                          fmt::format("`{}` has no sensor `{}`", entity_.id.value, name));
      return;
    }
    if (!sensors_.contains(name)) return;
    if (sensors_made_.contains(name)) {
      diagnostics()
          .error("E0311", connection.to.span,
                 fmt::format("`{}` is connected twice", connection.to.value))
          .help = "a sensor is one output of an engine node";
      return;
    }
    nodes_[source].outputs[output].sensors.push_back(spec_.name.value + "." + name);
    sensors_made_[name] = make_sensor(connection, *sensor, {source, output});
    check_rate(*sensor, "sensors", nodes_[source], connection.from.span);
    add_delay(*sensor);
  }

  /// Its readers get the messages that the output publishes, if that has no other sensor.
  UnresolvedSensor make_sensor(const ConnectionSpec& connection, const PortManifest& manifest,
                               const PortIndex& index) {
    UnresolvedSensor sensor{
        spec_.name.value + "." + manifest.name.value, index, {}, connection.settings.processor};
    bind(sensor.processor);
    sensor.of_connection = true;
    UnresolvedOutput& output = nodes_[index.node].outputs[index.port];
    const bool alone = !has_other_sensors(connection);
    say_space(sensor, partial_space(manifest.space, references_, diagnostics()), output, alone);
    const ComponentSpec* set = find_component(spec_.sensors, manifest.name.value);
    if (set != nullptr && set->settings.processor) {
      sensor.processor = set->settings.processor;
      sensor.space = {};  // of the processor that it replaces
      sensor.of_connection = false;
    }
    if (set != nullptr && set->space)
      say_space(sensor, partial_space(*set->space, {}, diagnostics()), output, alone);
    if (sensor.processor && alone && !output.processor) {
      output.processor = std::exchange(sensor.processor, std::nullopt);
      output.published = std::exchange(sensor.space, {});
      output.of_sensor = true;
      output.of_connection = sensor.of_connection;
    }
    if (sensor.processor) output.converted.push_back(sensor.written);
    return sensor;
  }

  /// Without a processor, dtype and shape are those of the output; bounds, too, if it has no other
  /// sensor.
  void say_space(UnresolvedSensor& sensor, PartialSpace said, UnresolvedOutput& output,
                 bool alone) {
    if (sensor.processor) {
      sensor.space = narrow(sensor.space, said, sensor.written, diagnostics());
      return;
    }
    if (!alone) {
      sensor.taken = overlay(sensor.taken, said);
      said.low.clear();
      said.high.clear();
    }
    PartialSpace& space = output.processor ? output.published : output.declared;
    space = narrow(space, said, sensor.written, diagnostics());
  }

  /// Of the same output, in use or not, so that a message does not depend on what else a graph
  /// connects.
  [[nodiscard]] bool has_other_sensors(const ConnectionSpec& connection) const {
    return ranges::any_of(implementation_.connections, [&](const ConnectionSpec& other) {
      return &other != &connection && other.from.value == connection.from.value &&
             parse_port(other.to.value).owner == "sensors";
    });
  }

  /// The delay of a sensor is that of every connection from it which says nothing else.
  void add_delay(const PortManifest& sensor) {
    ConnectionSettings& settings = delays_[sensor.name.value];
    settings = manifest_settings(sensor, references_, diagnostics());
    const ComponentSpec* set = find_component(spec_.sensors, sensor.name.value);
    if (set == nullptr) return;
    ConnectionSettings said = set->settings;
    said.processor.reset();  // converts what the sensor publishes
    settings = overlay(settings, said);
  }

  /// A sensor or actuator ticks with the engine node that implements it.
  void check_rate(const PortManifest& port, const char* kind, const UnresolvedNode& node,
                  Span span) {
    const auto rate = exact_of(references_[rate_reference(kind, port.name.value)]);
    if (!rate || node.node.rate_hz == Rational() || *rate == node.node.rate_hz) return;
    diagnostics()
        .error("E0317", span,
               fmt::format("`{}` ticks at {} Hz, but `{}.{}` at {} Hz", node.node.name,
                           node.node.rate_hz.to_string(), spec_.name.value, port.name.value,
                           rate->to_string()))
        .help = fmt::format("write `rate: {}` for the engine node",
                            in_dollars(rate_reference(kind, port.name.value)));
  }

  void mark_needed() {
    std::vector<std::size_t> sensors, actuators;
    for (const auto& [name, sensor] : sensors_made_) sensors.push_back(sensor.output.node);
    for (const auto& sink : actuator_sinks_) {
      if (actuators_.contains(sink.name)) actuators.push_back(sink.node);
    }
    needed_ = needed_engine_nodes(nodes_, links_, sensors, actuators);
  }

  void move_to_graph() {
    UnresolvedObject object{spec_.name.value, &entity_, {}, {}, std::move(delays_)};
    std::vector<std::size_t> place(nodes_.size(), 0);
    std::size_t next = draft_.nodes.size();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (needed_[i]) place[i] = next++;
    }
    for (auto& [name, sensor] : sensors_made_) {
      sensor.output.node = place[sensor.output.node];
      object.sensors[name] = std::move(sensor);
    }
    for (const auto& sink : actuator_sinks_) {
      if (needed_[sink.node]) object.actuators[sink.name].push_back({place[sink.node], sink.port});
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!needed_[i]) continue;
      for (auto& input : nodes_[i].inputs) {
        if (input.edge && input.name != "tick") input.edge->node = place[input.edge->node];
      }
      draft_.nodes.push_back(std::move(nodes_[i]));
    }
    draft_.add_object(std::move(object));
  }

  struct Outside {  // an actuator and the port it stands for
    std::string name;
    std::size_t node, port;
  };

  UnresolvedGraph& draft_;
  const EntitySpec& spec_;
  const Entity& entity_;
  const ObjectEngine& implementation_;
  References references_;
  const ConnectedPorts& connected_;
  std::set<std::string> sensors_, actuators_;
  std::vector<UnresolvedNode> nodes_;
  std::vector<InnerLink> links_;
  std::vector<Outside> actuator_sinks_;
  std::map<std::string, UnresolvedSensor> sensors_made_;
  std::vector<bool> needed_;
  std::map<std::string, ConnectionSettings> delays_;  // by sensor
};

}  // namespace

void add_objects(UnresolvedGraph& draft) {
  const ConnectedPorts connected = connected_ports(draft.spec.connections);
  const Entity* engine = draft.engine();
  for (const auto& spec : draft.spec.objects) {
    const Entity* entity =
        find_entity(draft.library, spec.type, EntityKind::object, draft.diagnostics);
    const ObjectEngine* implementation = nullptr;
    if (entity != nullptr && engine != nullptr) {
      implementation =
          find_implementation(draft.library, *entity, *engine, spec.type.span, draft.diagnostics);
    }
    Object object{spec.name.value, entity, implementation, {}, {}, {}, spec.name.span};
    if (entity != nullptr)
      object.config =
          resolve_config(draft.library, *entity, spec.config, spec.type.span, draft.diagnostics);
    draft.graph.objects.push_back(std::move(object));
    if (implementation != nullptr) {
      const MakingPorts making(draft, spec.name.value);
      ObjectBuilder(draft, spec, *entity, *implementation, connected).build();
    } else {
      draft.erroneous.insert(spec.name.value);
      draft.add_object({spec.name.value, entity, {}, {}, {}});
    }
  }
}

}  // namespace eagerx::gen
