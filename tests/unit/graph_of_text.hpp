// Graphs from texts, with the library of this repository, for unit tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "generator/graph/plan/plan.hpp"

namespace eagerx::gen {

struct GraphOfText {
  SourceMap sources;
  Diagnostics diagnostics;
  std::optional<GraphSpec> spec;
  std::optional<Graph> graph;
  std::optional<Plan> plan;  // nothing after a problem

  /// Codes of all problems, "E0307 E0310".
  [[nodiscard]] std::string codes() const {
    std::string text;
    for (const Diagnostic& problem : diagnostics.all())
      text += (text.empty() ? "" : " ") + problem.code;
    return text;
  }
};

/// The result holds the diagnostics of the text.
inline std::unique_ptr<GraphOfText> read_graph_text(const std::string& text) {
  static SourceMap library_sources;
  static Diagnostics library_diagnostics;
  static const Library kLibrary = load_library({{std::string(EAGERX_SOURCE_DIR) + "/models", {}},
                                                {std::string(EAGERX_SOURCE_DIR) + "/targets", {}}},
                                               library_sources, library_diagnostics);
  EXPECT_FALSE(library_diagnostics.has_errors());
  auto result = std::make_unique<GraphOfText>();
  const YamlValue tree = read_yaml_text("graph.yaml", text, result->sources, result->diagnostics);
  result->spec = read_graph_spec(tree, "graph.yaml", result->diagnostics);
  if (result->spec) result->graph = resolve(*result->spec, kLibrary, {}, result->diagnostics);
  if (result->graph) result->plan = make_plan(*result->graph, result->diagnostics);
  return result;
}

/// Of a text without a problem.
inline std::unique_ptr<GraphOfText> graph_of_text(const std::string& text) {
  auto result = read_graph_text(text);
  EXPECT_TRUE(result->plan) << render_text(result->diagnostics, result->sources, false);
  return result;
}

}  // namespace eagerx::gen
