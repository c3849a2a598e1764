// Graphs from texts, with the library of this repository.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "generator/cut/cut.hpp"
#include "generator/plan/plan.hpp"

namespace eagerx::gen {

struct GraphOfText {
  SourceMap sources;
  Diagnostics diagnostics;
  std::optional<GraphSpec> spec;
  std::optional<Graph> graph;
  std::optional<Plan> plan;

  /// Codes of all problems, "E0307 E0310".
  [[nodiscard]] std::string codes() const {
    std::string text;
    for (const Diagnostic& problem : diagnostics.all())
      text += (text.empty() ? "" : " ") + problem.code;
    return text;
  }
};

inline std::unique_ptr<GraphOfText> graph_of(const std::string& text) {
  static SourceMap library_sources;
  static Diagnostics library_diagnostics;
  static const Library kLibrary = load_library({{std::string(EAGERX_SOURCE_DIR) + "/models", {}},
                                                {std::string(EAGERX_SOURCE_DIR) + "/targets", {}}},
                                               library_sources, library_diagnostics);
  auto result = std::make_unique<GraphOfText>();
  const YamlValue tree = read_yaml_text("graph.yaml", text, result->sources, result->diagnostics);
  result->spec = read_graph_spec(tree, "graph.yaml", result->diagnostics);
  if (result->spec) result->graph = resolve(*result->spec, kLibrary, {}, result->diagnostics);
  if (result->graph) result->plan = make_plan(*result->graph, result->diagnostics);
  EXPECT_TRUE(result->plan) << render_text(result->diagnostics, result->sources, false);
  return result;
}

/// A pendulum that a filter drives; `more` are further keys.
inline std::string swing(const std::string& rate_of_filter = "30", const std::string& more = "") {
  return "name: swing\nrate: 30\nengine: {type: OdeEngine, rate: 30}\n"
         "objects:\n  pendulum: {type: Pendulum}\n"
         "nodes:\n  smooth: {type: ButterworthFilter, rate: " +
         rate_of_filter +
         ", config: {order: 2, cutoff_hz: 6}}\n"
         "actions:\n  voltage: {space: {like: pendulum.u}}\n"
         "observations: [angle]\n"
         "connections:\n"
         "  - {from: actions.voltage, to: smooth.signal}\n"
         "  - {from: smooth.filtered, to: pendulum.u}\n"
         "  - {from: pendulum.theta, to: observations.angle}\n" +
         more;
}

/// A folder for files of a test, which is removed.
class TestFolder {
 public:
  TestFolder() {
    std::string name = testing::TempDir() + "eagerx-stages-XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  /// The path of a file with this text.
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
    return path_ + "/" + name;
  }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace eagerx::gen
