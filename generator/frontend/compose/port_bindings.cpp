#include "generator/frontend/compose/port_bindings.hpp"

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/spec/port_name.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kProcessor = "processor";

void append(std::vector<YamlValue>& list, const YamlValue& processor) {
  if (processor.is_sequence())
    list.insert(list.end(), processor.items.begin(), processor.items.end());
  else
    list.push_back(processor);
}

/// The processor of `over`, then that of `map`: a message passes the outer one first.
void set_processor(YamlValue& map, const YamlValue& inner, Span span) {
  const YamlValue* outer = map.find(kProcessor);
  if (outer == nullptr) {
    set_entry(map, kProcessor, span, inner);
    return;
  }
  std::vector<YamlValue> both;
  append(both, *outer);
  append(both, inner);
  set_entry(map, kProcessor, span, made_list(std::move(both), outer->span));
}

}  // namespace

std::string PortBindings::source(const std::string& port) const {
  const PortName name = parse_port(port);
  const CompositePorts* composite = find(name.owner);
  if (composite == nullptr) return port;
  const bool sends = name.section.empty() || name.section == "outputs" || name.section == "sensors";
  const auto found = composite->sources.find(name.name);
  return sends && found != composite->sources.end() ? found->second : port;
}

std::vector<PortBinding> PortBindings::sinks(const std::string& port) const {
  const PortName name = parse_port(port);
  const CompositePorts* composite = find(name.owner);
  if (composite == nullptr) return {{port, {}}};
  const bool takes =
      name.section.empty() || name.section == "inputs" || name.section == "actuators";
  const auto found = composite->sinks.find(name.name);
  return takes && found != composite->sinks.end() ? found->second
                                                  : std::vector<PortBinding>{{port, {}}};
}

CompositeSpec shown_composite(const std::string& name, Span span, const Entity& entity,
                              const YamlValue* rate, const CompositePorts& ports) {
  CompositeSpec shown{name, entity.id.value, entity.summary, {}, {}, {}, {}, span};
  shown.is_object = entity.kind == EntityKind::object;
  if (rate != nullptr) shown.rate_hz = exact_of(*rate);
  for (const auto& port : shown.is_object ? entity.actuators : entity.inputs) {
    std::vector<std::string> inside;
    const auto found = ports.sinks.find(port.name.value);
    if (found != ports.sinks.end())
      for (const PortBinding& sink : found->second) inside.push_back(sink.port);
    shown.inputs.emplace_back(port.name.value, std::move(inside));
  }
  for (const auto& port : shown.is_object ? entity.sensors : entity.outputs) {
    const auto found = ports.sources.find(port.name.value);
    if (found != ports.sources.end())
      shown.outputs.emplace_back(port.name.value, std::vector{found->second});
  }
  return shown;
}

void set_entry(YamlValue& map, const std::string& key, Span span, YamlValue value) {
  const auto found = ranges::find(map.entries, key, &YamlValue::Entry::key);
  if (found != map.entries.end())
    found->value = std::move(value);
  else
    map.entries.push_back({key, span, std::move(value)});
}

YamlValue& map_at(YamlValue& map, const std::string& key, Span span) {
  auto found = ranges::find(map.entries, key, &YamlValue::Entry::key);
  if (found == map.entries.end()) {
    YamlValue empty;
    empty.span = span;
    map.entries.push_back({key, span, std::move(empty)});
    found = map.entries.end() - 1;
  }
  YamlValue& value = found->value;
  if (value.is_null()) value.kind = YamlKind::map;
  return value;
}

void move_file(YamlValue& yaml, FileId file) {
  yaml.span.file = file;
  for (auto& item : yaml.items) move_file(item, file);
  for (auto& entry : yaml.entries) {
    entry.key_span.file = file;
    move_file(entry.value, file);
  }
}

YamlValue joined(const YamlValue& connection, const Spanned<std::string>& from,
                 const Spanned<std::string>& to, const std::vector<YamlValue>& settings) {
  YamlValue result = connection;
  set_entry(result, "from", from.span, made_scalar(from.value, from.span));
  set_entry(result, "to", to.span, made_scalar(to.value, to.span));
  for (const YamlValue& each : settings) {
    for (const auto& entry : each.entries) {
      if (entry.key == kProcessor)
        set_processor(result, entry.value, entry.key_span);
      else if (result.find(entry.key) == nullptr)
        result.entries.push_back(entry);
    }
  }
  return result;
}

}  // namespace eagerx::gen
