// `process:` of a file of EAGERx.
#include <gtest/gtest.h>

#include "generator/frontend/import/import.hpp"
#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {
namespace {

/// BaseEnv.save of an object and two nodes between it and the environment; each with its process,
/// "process: 0, " or nothing.
std::string saved_with(const std::string& engine, const std::string& sensor,
                       const std::string& first, const std::string& second) {
  const std::string space = "space: {dtype: int64, low: 0, high: 1000000000, shape: [2]}";
  const auto node = [&](const std::string& name, const std::string& process) {
    return "  " + name + ": {node_type: x, config: {entity_id: oracle_nodes/CountNode, rate: 10, " +
           process + "nid: 1, inputs: [i0], outputs: [o0], states: []}, inputs: {i0: {" + space +
           ", window: 1}}, outputs: {o0: {" + space + "}}}\n";
  };
  const auto engine_node = [&](const std::string& name, const std::string& id,
                               const std::string& process, const std::string& inputs) {
    return "  obj/" + name + ": {node_type: x, config: {entity_id: oracle_nodes/" + id +
           ", rate: 10, " + process + "nid: 1, outputs: [o0], inputs: [tick" + inputs +
           "]}, inputs: {i0: {window: 1}}, outputs: {o0: {processor: null}}}\n";
  };
  return "backup:\n  obj:\n    entity_type: oracle_nodes/OObject\n"
         "    config: {entity_id: oracle_nodes/OObject, actuators: [a0], sensors: [s0], states: "
         "[], chain: false, nid: 20}\n"
         "    sensors: {s0: {rate: 10}}\n    actuators: {a0: {rate: 10, window: 1}}\n"
         "connects:\n- [[environment, outputs, act], [first, inputs, i0]]\n"
         "- [[first, outputs, o0], [second, inputs, i0]]\n"
         "- [[second, outputs, o0], [obj/a0, inputs, i0]]\n"
         "- [[obj/s0, outputs, o0], [environment, inputs, obs]]\n"
         "gui_state: {}\nnodes:\n"
         "  environment:\n    config: {entity_id: eagerx.core.nodes/EnvNode, inputs: [obs], "
         "outputs: [act], process: 1, rate: 10, states: []}\n    inputs: {obs: {" +
         space + ", window: 1}}\n    outputs: {act: {" + space + "}}\n" +
         "  engine: {config: {entity_id: oracle_nodes/OracleEngine, " + engine +
         "rate: 20, node_names: [robot/supervisor]}, objects: {obj: {add_object: {nid: 30}, "
         "engine_states: {st0: {}}, nodes: [obj/a0, obj/s0]}}}\n" +
         engine_node("a0", "OActuator", "process: 2, ", ", i0") +
         engine_node("s0", "OSensor", sensor, "") + node("first", first) + node("second", second);
}

struct ProcessesOf {
  explicit ProcessesOf(const std::string& text, bool keep_processes = true) {
    SourceMap sources;
    const YamlValue tree = read_yaml_text("state.yaml", text, sources, diagnostics, Tags::accept);
    library =
        load_library({{"tests/data/import/models", {}}, {"targets", {}}}, sources, diagnostics);
    graph = import_graph(tree, "state.yaml", library, {{}, {}, {}, keep_processes}, diagnostics);
    if (graph) {
      written = write_graph(*graph);
      resolved = resolve(graph->spec, library, {}, diagnostics);
    }
    report = render_text(diagnostics, sources, false);
  }

  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> result;
    for (const auto& d : diagnostics.all())
      if (d.severity == Severity::note) result.push_back(d.message);
    return result;
  }

  Diagnostics diagnostics;
  Library library;
  std::optional<ImportedGraph> graph;
  std::optional<Graph> resolved;
  std::string written, report;
};

using Notes = std::vector<std::string>;

TEST(Processes, WhatIsTogetherInEagerxIsOneProgram) {
  const ProcessesOf import(
      saved_with("process: 1, ", "process: 2, ", "process: 1, ", "process: 2, "));
  ASSERT_TRUE(import.resolved) << import.report;
  EXPECT_FALSE(import.resolved->placement);
  EXPECT_EQ(import.written.find("placement"), std::string::npos) << import.written;
  EXPECT_EQ(import.notes(), Notes{});
  EXPECT_FALSE(ProcessesOf(saved_with("", "", "", "")).resolved->placement) << "nothing is said";
}

TEST(Processes, ANewProcessIsAPartAndAnExternalOneHasAHost) {
  const ProcessesOf import(
      saved_with("process: 1, ", "process: 2, ", "process: 0, ", "process: 3, "));
  ASSERT_TRUE(import.resolved) << import.report;
  ASSERT_TRUE(import.resolved->placement);
  const auto& parts = import.resolved->placement->parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].name, "first");
  EXPECT_EQ(parts[0].host, "");
  EXPECT_EQ(parts[0].target->id.value, "linux-sim");
  EXPECT_EQ(parts[1].name, "second");
  EXPECT_EQ(parts[1].host, "second_host");
  EXPECT_NE(import.written.find("placement:\n"
                                "  first: {part: first} # NEW_PROCESS in EAGERx\n"
                                "  second: {part: second, host: second_host} # EXTERNAL in EAGERx: "
                                "name its machine\n"),
            std::string::npos)
      << import.written;
  EXPECT_EQ(import.notes(), Notes{"what had its own process in EAGERx is a separate program "
                                  "(`placement:`): `first` on this machine; `second` on a machine "
                                  "for you to name"});
}

TEST(Processes, OneProgramUnlessPartsAreAskedFor) {
  const ProcessesOf import(
      saved_with("process: 1, ", "process: 2, ", "process: 0, ", "process: 0, "), false);
  ASSERT_TRUE(import.resolved) << import.report;
  EXPECT_FALSE(import.resolved->placement);
  EXPECT_EQ(import.notes(), Notes{"one program runs `first`, `second`, which EAGERx runs in "
                                  "their own processes"});
  EXPECT_NE(import.report.find("--keep-processes"), std::string::npos) << import.report;
  const ProcessesOf external(
      saved_with("process: 1, ", "process: 2, ", "process: 0, ", "process: 3, "), false);
  ASSERT_TRUE(external.resolved) << external.report;
  ASSERT_EQ(external.resolved->placement->parts.size(), 1U);
  EXPECT_EQ(external.resolved->placement->parts.front().name, "second");
}

TEST(Processes, TheEngineAndItsNodesStayTogether) {
  const ProcessesOf import(
      saved_with("process: 0, ", "process: 3, ", "process: 0, ", "process: 1, "));
  ASSERT_TRUE(import.resolved) << import.report;
  ASSERT_TRUE(import.resolved->placement);
  EXPECT_EQ(import.resolved->placement->parts.size(), 1U);
  EXPECT_EQ(import.resolved->placement->parts.front().name, "first");
  EXPECT_EQ(import.notes(),
            Notes{"what had its own process in EAGERx is a separate program "
                  "(`placement:`): `first` on this machine; the engine, `obj/s0` in the main "
                  "program, with all of the engine"});
  const ProcessesOf alone(
      saved_with("process: 0, ", "process: 2, ", "process: 1, ", "process: 1, "));
  EXPECT_FALSE(alone.resolved->placement);
  EXPECT_EQ(alone.notes(), Notes{"in the main program here, but in EAGERx in its own process: "
                                 "the engine"});
}

TEST(Processes, WhatIsNoProcessIsAnError) {
  for (const char* wrong : {"process: 4, ", "process: -1, ", "process: new, ", "process: [0], ",
                            "process: 00, ", "process: '', "}) {
    const ProcessesOf import(saved_with("", "", wrong, ""));
    EXPECT_FALSE(import.graph) << wrong;
    EXPECT_NE(import.report.find("E0802"), std::string::npos) << import.report;
  }
  EXPECT_TRUE(ProcessesOf(saved_with("", "", "process: null, ", "")).graph);
}

}  // namespace
}  // namespace eagerx::gen
