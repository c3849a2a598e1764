#include "generator/frontend/compose/rename_ports.hpp"

#include <string_view>

namespace eagerx::gen {
namespace {

template <class F>
void with(YamlValue& map, std::string_view key, F&& f) {
  for (auto& entry : map.entries)
    if (entry.key == key) f(entry.value);
}

template <class F>
void rename_inputs_of_task(YamlValue& task, F&& source) {
  with(task, "inputs", [&](YamlValue& inputs) {
    for (auto& input : inputs.entries) {
      source(input.value);
      with(input.value, "from", source);
    }
  });
}

/// A channel of all elements of an array is one of each.
void name_channels(YamlValue& channels, const PortBindings& ends, const CountOf& count_of,
                   Diagnostics& diagnostics) {
  std::vector<YamlValue> named;
  for (const auto& item : channels.items) {
    const Spanned<std::string> text{item.text, item.span};
    std::vector<IndexedPort> ports = {{item.text, std::nullopt}};
    if (item.text.find('[') != std::string::npos) {
      const auto pattern = parse_pattern(text, diagnostics);
      if (!pattern) continue;
      // An element of a message is no channel, as is said later.
      if (!pattern->has_element()) ports = indexed_ports(*pattern, count_of, diagnostics);
    }
    for (const IndexedPort& port : ports) {
      named.push_back(item);
      if (item.is_scalar()) named.back().text = ends.source(port.port);
    }
  }
  channels.items = std::move(named);
}

}  // namespace

void rename_ports(YamlValue& root, const PortBindings& ends, const CountOf& count_of,
                  Diagnostics& diagnostics) {
  const auto source = [&ends](YamlValue& port) {
    if (port.is_scalar()) port.text = ends.source(port.text);
  };
  const auto sink = [&ends](YamlValue& port) {
    if (port.is_scalar()) port.text = ends.sinks(port.text).front().port;
  };
  for (auto& entry : root.entries) {
    if (entry.key == "task") rename_inputs_of_task(entry.value, source);
    if (entry.key == "render") with(entry.value, "source", source);
    if (entry.key == "actions")
      for (auto& action : entry.value.entries)
        with(action.value, "space", [&](YamlValue& space) { with(space, "like", sink); });
    if (entry.key == "budget") {
      with(entry.value, "age", [&](YamlValue& ages) {
        for (auto& age : ages.items) {
          with(age, "from", source);
          with(age, "to", sink);
        }
      });
      with(entry.value, "margin", [&](YamlValue& margins) {
        with(margins, "at", source);
        for (auto& margin : margins.items) with(margin, "at", source);
      });
    }
    if (entry.key == "safety")
      with(entry.value, "actuators", [&](YamlValue& actuators) {
        for (auto& actuator : actuators.entries)
          actuator.key = ends.sinks(actuator.key).front().port;
      });
    if (entry.key == "telemetry")
      with(entry.value, "channels",
           [&](YamlValue& channels) { name_channels(channels, ends, count_of, diagnostics); });
  }
}

}  // namespace eagerx::gen
