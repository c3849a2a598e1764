// Short texts as EAGERx saves them, and the results of importing them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/import/import.hpp"

namespace eagerx::gen {

/// A text of EAGERx, imported with the oracle's entities.
struct Import {
  /// `sensor_delay`: what our manifest says of the object's sensor.
  explicit Import(const std::string& text, const ImportOptions& options = {},
                  const std::string& sensor_delay = {}) {
    const YamlValue tree = read_yaml_text("state.yaml", text, sources, diagnostics, Tags::accept);
    if (diagnostics.has_errors()) return;
    saved = is_saved_graph(tree);
    library = load_library({{"tests/data/import/models", {}}}, sources, diagnostics);
    if (!sensor_delay.empty())
      library.entities.at("OObject").sensors.front().settings.delay =
          read_quantity(made_scalar(sensor_delay, {}));
    graph = import_graph(tree, "state.yaml", library, options, diagnostics);
  }

  [[nodiscard]] std::string report() const { return render_text(diagnostics, sources, false); }
  [[nodiscard]] std::string text() const { return graph ? write_graph(*graph) : report(); }
  [[nodiscard]] std::vector<std::string> codes() const {
    std::vector<std::string> result;
    for (const auto& d : diagnostics.all()) {
      if (d.severity != Severity::note) result.push_back(d.code);
    }
    return result;
  }

  SourceMap sources;
  Diagnostics diagnostics;
  bool saved = false;
  Library library;
  std::optional<ImportedGraph> graph;
};

using Codes = std::vector<std::string>;

inline constexpr const char* kSpace = "{dtype: int64, low: 0, high: 1000000000, shape: [2]}";

inline std::string environment(const std::string& rate = "null",
                               const std::string& space = kSpace) {
  return "  environment:\n"
         "    config: {entity_id: eagerx.core.nodes/EnvNode, inputs: [obs], outputs: [act], "
         "rate: " +
         rate + ", states: []}\n    inputs: {obs: {space: " + kSpace +
         ", window: 1}}\n    outputs: {act: {space: " + space + "}}\n";
}

inline std::string object(const std::string& config = "chain: false, nid: 20",
                          const std::string& sensor = "rate: 10") {
  return "  obj:\n    entity_type: oracle_nodes/OObject\n"
         "    config: {entity_id: oracle_nodes/OObject, actuators: [a0], sensors: [s0], states: "
         "[], " +
         config + "}\n    sensors: {s0: {" + sensor + "}}\n" +
         "    actuators: {a0: {rate: 20, window: 1}}\n";
}

inline std::string file(const std::string& nodes, const std::string& links = "") {
  return "connects:\n- [[environment, outputs, act], [obj, actuators, a0]]\n"
         "- [[obj, sensors, s0], [environment, inputs, obs]]\n" +
         links + "gui_state: {}\nnodes:\n" + nodes;
}

/// BaseEnv.save of the same graph; `inputs` of the engine node s3 of an object with a chain.
inline std::string flattened(const std::string& inputs) {
  const std::string node = "node_type: x, config: {rate: 10, nid: 1, outputs: [o0], inputs: ";
  return "backup:\n" + object("chain: true, nid: 20") +
         "connects:\n- [[environment, outputs, act], [obj/a0, inputs, i0]]\n"
         "- [[obj/a0, outputs, o0], [obj/s3, inputs, i1]]\n"
         "- [[obj/s3, outputs, o0], [environment, inputs, obs]]\n"
         "gui_state: {}\nnodes:\n" +
         environment("10") +
         "  engine: {config: {entity_id: oracle_nodes/OracleEngine, rate: 20, node_names: "
         "[robot/supervisor]}, objects: {obj: {add_object: {nid: 30}, engine_states: {st0: {}}, "
         "nodes: [obj/a0, obj/s3]}}}\n"
         "  obj/a0: {" +
         node +
         "[tick, i0], entity_id: oracle_nodes/OActuator}, inputs: {i0: {delay: 0.02, window: "
         "3}}}\n" +
         "  obj/s3: {" + node +
         "[i0, i1], entity_id: oracle_nodes/OSensor}, inputs: {i1: " + inputs +
         "}, outputs: {o0: {processor: null}}}\n";
}

}  // namespace eagerx::gen
