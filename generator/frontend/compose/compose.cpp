#include "generator/frontend/compose/compose.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "generator/frontend/compose/arrays.hpp"
#include "generator/frontend/compose/composite_use.hpp"
#include "generator/frontend/compose/gather.hpp"
#include "generator/frontend/compose/inner_files.hpp"
#include "generator/frontend/compose/inner_ports.hpp"
#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/compose/port_pattern.hpp"
#include "generator/frontend/compose/rename_ports.hpp"
#include "generator/frontend/compose/scope.hpp"
#include "generator/frontend/compose/tunable.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

// Limits for arrays of composites that contain arrays: a graph of a million nodes is a mistake.
constexpr std::size_t kMostEntities = 20'000;
constexpr std::size_t kDeepest = 16;

class Composer {
 public:
  Composer(const YamlValue& root, const Library& library, SourceMap& sources,
           Diagnostics& diagnostics)
      : root_(root), library_(library), sources_(sources), diagnostics_(diagnostics) {}

  FlatGraph run() {
    if (!root_.is_map()) return {root_, GraphForm::written, {}, {}};
    expand(root_, {});
    if (!changed_) return {root_, GraphForm::written, {}, {}};
    YamlValue flat = root_;
    replace(flat, "objects", std::move(objects_));
    replace(flat, "nodes", std::move(nodes_));
    const auto list = ranges::find(flat.entries, "connections", &YamlValue::Entry::key);
    if (list != flat.entries.end() && list->value.is_sequence())
      list->value.items = std::move(connections_);
    rename_ports(flat, inner_.ends, counter({}), diagnostics_);
    return {std::move(flat), GraphForm::flat, std::move(inner_.ends), std::move(composites_)};
  }

 private:
  enum class Section : std::uint8_t { objects, nodes };

  static void replace(YamlValue& root, const char* key, std::vector<YamlValue::Entry> entities) {
    const auto found = ranges::find(root.entries, key, &YamlValue::Entry::key);
    if (found == root.entries.end()) {
      if (entities.empty()) return;
      YamlValue map;
      map.kind = YamlKind::map;
      map.span = entities.front().key_span;
      map.entries = std::move(entities);
      root.entries.push_back({key, map.span, std::move(map)});
    } else if (found->value.is_map() || found->value.is_null()) {
      if (!entities.empty()) found->value.kind = YamlKind::map;
      found->value.entries = std::move(entities);
    }
  }

  void expand(const YamlValue& graph, const Scope& scope) {
    for (const auto section : {Section::objects, Section::nodes}) {
      const YamlValue* map = graph.find(section == Section::objects ? "objects" : "nodes");
      if (map == nullptr || !map->is_map()) continue;
      for (const auto& entry : map->entries) add_entities(scope, section, entry);
    }
    report_unknown_inner(scope, graph, diagnostics_);
    const YamlValue* connections = graph.find("connections");
    if (connections != nullptr) add_connections(scope, *connections);
  }

  /// One, or all of an array.
  void add_entities(const Scope& scope, Section section, const YamlValue::Entry& entry) {
    // Only what is composed has such names.
    if (is_inner_name(entry.key) && !check_name(entry.key, entry.key_span, diagnostics_)) return;
    const auto count = count_of(entry.value, scope.references, diagnostics_);
    if (!count) {
      YamlValue settings = entry.value;
      if (!scope.around.empty())
        settings = substitute(std::move(settings), scope.references, diagnostics_);
      add_entity(scope, section, entry, entry.key, std::move(settings));
      return;
    }
    changed_ = true;
    counts_[scope.prefix + entry.key] = *count;
    for (std::int64_t i = 0; i < *count && !too_many_; ++i)
      add_entity(scope, section, entry, element_name(entry.key, i),
                 element_of(entry.value, i, *count, scope.references, diagnostics_));
  }

  void add_entity(const Scope& scope, Section section, const YamlValue::Entry& entry,
                  const std::string& name, YamlValue settings) {
    add_said(scope, entry, name, settings);
    const YamlValue* type = settings.find("type");
    const bool known = type != nullptr && type->is_scalar();
    const Entity* const found = known ? library_.find(type->text) : nullptr;
    if (found != nullptr && found->is_composite() &&
        (found->kind == EntityKind::object) == (section == Section::objects)) {
      add_composite(scope, entry, name, settings, *found);
      return;
    }
    if (++entities_ > kMostEntities) {
      if (!std::exchange(too_many_, true))
        diagnostics_.error("E0393", entry.key_span,
                           fmt::format("the graph has more than {} entities", kMostEntities));
      return;
    }
    if (!scope.around.empty())
      name_files_from(*scope.around.back(), sources_.name(root_.span.file), settings);
    inner_.entity_of[scope.prefix + name] = found;
    (section == Section::objects ? objects_ : nodes_)
        .push_back({scope.prefix + name, entry.key_span, std::move(settings)});
  }

  bool enters(const Scope& scope, const YamlValue& type, const Entity& entity) {
    if (contains_entity(scope.around, entity)) {
      std::vector<std::string> names;
      for (const Entity* each : scope.around) names.push_back(each->id.value);
      names.push_back(entity.id.value);
      diagnostics_
          .error("E0393", type.span,
                 fmt::format("`{}` is made of itself: {}", entity.id.value, join(names, " → ")))
          .help = "a composite cannot be a part of what it is made of";
      return false;
    }
    if (scope.around.size() < kDeepest) return true;
    diagnostics_.error("E0393", type.span,
                       fmt::format("composites in composites, more than {} deep", kDeepest));
    return false;
  }

  static bool contains_entity(const std::vector<const Entity*>& list, const Entity& entity) {
    return ranges::contains(list, &entity);
  }

  void add_composite(const Scope& outer, const YamlValue::Entry& entry, const std::string& name,
                     const YamlValue& settings, const Entity& entity) {
    const std::string full = outer.prefix + name;
    const YamlValue& type = *settings.find("type");
    changed_ = true;
    inner_.entity_of[full] = nullptr;  // after a problem nothing is said of its ports
    if (!enters(outer, type, entity)) return;
    const bool object = entity.kind == EntityKind::object;
    if (!check(settings, object ? *object_format() : *composite_node_format(), diagnostics_))
      return;
    const YamlValue written =
        in_base_units(settings, object ? *object_format() : *composite_node_format());
    Scope scope;
    scope.prefix = full + "/";
    scope.around = outer.around;
    scope.around.push_back(&entity);
    if (!take_parameters(library_, written, entity, type.span, scope, diagnostics_)) return;
    YamlValue inside = *entity.composite;
    move_file(inside,
              sources_.add_use(inside.span.file,
                               {entry.key_span, fmt::format("`{}` is a `{}`, as written here", full,
                                                            entity.id.value)}));
    take_states(written, scope, diagnostics_);
    CompositePorts ports;
    const char* receiving = object ? "actuators" : "inputs";
    const char* sending = object ? "sensors" : "outputs";
    if (!knows_ports(written, entity, receiving, diagnostics_) ||
        !knows_ports(written, entity, sending, diagnostics_))
      return;
    if (object) take_settings_of_ports(written, inside, scope);
    const std::size_t connections_before = connections_.size();
    expand(*inside.find("graph"), scope);
    Feeds feeds;
    for (std::size_t c = connections_before; c < connections_.size(); ++c)
      feeds.add_connection(connections_[c]);
    bind(inside, written, receiving, scope, feeds, ports);
    bind_sources(inside, sending, scope, ports);
    composites_.push_back(
        shown_composite(full, entry.key_span, entity, written.find("rate"), ports));
    inner_.entity_of.erase(full);
    inner_.ends.add(full, std::move(ports));
  }

  CountOf counter(const Scope& scope) const {
    return [this, prefix = scope.prefix](const std::string& name) -> std::optional<std::int64_t> {
      const auto found = counts_.find(prefix + name);
      return found == counts_.end() ? std::nullopt : std::optional(found->second);
    };
  }

  /// The full names of what a port of this scope stands for; of an element the port alone.
  std::vector<std::string> ports_of(const Spanned<std::string>& text, const Scope& scope) {
    const auto pattern = parse_pattern(text, diagnostics_);
    std::vector<std::string> result;
    if (!pattern) return result;
    if (pattern->has_element()) {
      diagnostics_.error("E0390", text.span, "a port of a composite is a whole port inside").help =
          "take messages apart with nodes inside, such as `Demux`";
      return result;
    }
    for (const IndexedPort& port : indexed_ports(*pattern, counter(scope), diagnostics_))
      result.push_back(full_name(port.port, scope));
    return result;
  }

  static bool is_of_environment(std::string_view port) {
    return port.starts_with("actions.") || port.starts_with("observations.");
  }

  std::string full_name(const std::string& port, const Scope& scope) const {
    return scope.around.empty() || is_of_environment(port) ? port : scope.prefix + port;
  }

  void bind(const YamlValue& inside, const YamlValue& written, const char* key, const Scope& scope,
            Feeds& feeds, CompositePorts& ports) {
    const YamlValue* map = inside.find(key);
    if (map == nullptr) return;
    const YamlValue* chosen = written.find(key);
    for (const auto& entry : map->entries) {
      const YamlValue* of_use = chosen != nullptr ? chosen->find(entry.key) : nullptr;
      std::vector<PortBinding>& sinks = ports.sinks[entry.key];
      for (const auto& text : texts_of(*entry.value.find("to"))) {
        for (const std::string& port : ports_of(text, scope)) {
          if (!inner_.is_there(text, port, false, diagnostics_)) continue;
          for (PortBinding sink : inner_.ends.sinks(port)) {
            feeds.bind(sink.port, text, diagnostics_);
            sink.settings.insert(sink.settings.begin(), settings_of(entry.value, scope));
            if (of_use != nullptr && of_use->is_map() &&
                scope.around.back()->kind == EntityKind::node)
              sink.settings.insert(sink.settings.begin(), settings_of(*of_use, {}));
            sinks.push_back(std::move(sink));
          }
        }
      }
    }
  }

  /// Settings of connections, without the rest.
  YamlValue settings_of(const YamlValue& port, const Scope& scope) {
    YamlValue result;
    result.kind = YamlKind::map;
    result.span = port.span;
    for (const auto& entry : port.entries) {
      static const std::set<std::string, std::less<>> kSettings = {"window", "delay", "max_delay",
                                                                   "skip", "processor"};
      if (!kSettings.contains(entry.key)) continue;
      YamlValue value = scope.around.empty()
                            ? entry.value
                            : substitute(entry.value, scope.references, diagnostics_);
      result.entries.push_back({entry.key, entry.key_span, std::move(value)});
    }
    return result;
  }

  void bind_sources(const YamlValue& inside, const char* key, const Scope& scope,
                    CompositePorts& ports) {
    const YamlValue* map = inside.find(key);
    if (map == nullptr) return;
    for (const auto& entry : map->entries) {
      const YamlValue& from = *entry.value.find("from");
      const Spanned<std::string> text{from.text, from.span};
      const auto found = ports_of(text, scope);
      if (found.size() > 1)
        diagnostics_.error("E0390", text.span,
                           fmt::format("`{}` is more than one output", text.value));
      if (found.size() == 1 && inner_.is_there(text, found.front(), true, diagnostics_))
        ports.sources[entry.key] = inner_.ends.source(found.front());
      else
        ports.broken.insert(entry.key);
    }
  }

  void add_connections(const Scope& scope, const YamlValue& list) {
    std::map<std::string, std::vector<GatheredElement>> gathered;
    std::vector<Spanned<std::string>> order;  // of what is gathered
    for (const auto& item : list.items) {
      YamlValue connection =
          scope.around.empty() ? item : substitute(item, scope.references, diagnostics_);
      const YamlValue* from = connection.find("from");
      const YamlValue* to = connection.find("to");
      if (from == nullptr || to == nullptr || !from->is_scalar() || !to->is_scalar()) {
        connections_.push_back(std::move(connection));  // what is wrong is said later
        continue;
      }
      const Spanned<std::string> source{from->text, from->span}, sink{to->text, to->span};
      for (const auto& one : connections_of(source, sink, scope)) {
        const std::string from_port = full_name(one.from.port, scope);
        const bool sends = inner_.has_port(source, from_port, true, diagnostics_);
        if (!inner_.has_port(sink, full_name(one.to.port, scope), false, diagnostics_) || !sends)
          continue;
        const Spanned<std::string> sender{inner_.ends.source(from_port), source.span};
        YamlValue each = one.from.element ? with_element(connection, *one.from.element, source.span)
                                          : connection;
        const std::string receiver = full_name(one.to.port, scope);
        if (!one.to.element) {
          connect(each, sender, {receiver, sink.span});
          continue;
        }
        if (!gathered.contains(receiver)) order.push_back({receiver, sink.span});
        gathered[receiver].push_back({*one.to.element, sender, std::move(each)});
      }
    }
    for (const auto& to : order) connect_elements(to, std::move(gathered[to.value]));
  }

  std::vector<IndexedConnection> connections_of(const Spanned<std::string>& from,
                                                const Spanned<std::string>& to,
                                                const Scope& scope) {
    if (from.value.find('[') == std::string::npos && to.value.find('[') == std::string::npos)
      return {{{from.value, std::nullopt}, {to.value, std::nullopt}}};
    changed_ = true;
    const auto source = parse_pattern(from, diagnostics_);
    const auto sink = parse_pattern(to, diagnostics_);
    if (!source || !sink) return {};
    return indexed_connections(*source, *sink, counter(scope), diagnostics_);
  }

  void connect(const YamlValue& connection, const Spanned<std::string>& from,
               const Spanned<std::string>& to) {
    for (const PortBinding& sink : inner_.ends.sinks(to.value))
      connections_.push_back(joined(connection, from, {sink.port, to.span}, sink.settings));
  }

  void connect_elements(const Spanned<std::string>& to, std::vector<GatheredElement> elements) {
    const std::string sender = parse_port(elements.front().from.value).owner;
    const auto found = ranges::find(nodes_, sender, &YamlValue::Entry::key);
    const YamlValue* rate = found == nodes_.end() ? root_.find("rate") : found->value.find("rate");
    if (rate == nullptr) return;  // said of the node, or of the graph
    const YamlValue rate_of_nodes = *rate;
    auto gathered = gather(to, std::move(elements), rate_of_nodes, diagnostics_);
    if (!gathered) return;
    for (auto& node : gathered->nodes) nodes_.push_back(std::move(node));
    for (auto& connection : gathered->connections) connections_.push_back(std::move(connection));
    connect(gathered->connection, gathered->from, to);
  }

  const YamlValue& root_;
  const Library& library_;
  SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::vector<YamlValue::Entry> objects_, nodes_;
  std::vector<YamlValue> connections_;
  std::vector<CompositeSpec> composites_;
  std::map<std::string, std::int64_t> counts_;  // of arrays, by their full names
  InnerPorts inner_;
  std::size_t entities_ = 0;
  bool too_many_ = false;
  bool changed_ = false;
};

}  // namespace

FlatGraph compose(const YamlValue& root, const Library& library, SourceMap& sources,
                  Diagnostics& diagnostics) {
  FlatGraph flat = Composer(root, library, sources, diagnostics).run();
  take_tunable(flat.root, library, diagnostics);
  return flat;
}

}  // namespace eagerx::gen
