#include "generator/driver/pipeline/pipeline.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

class Pipeline : public testing::Test {
 protected:
  void SetUp() override { setenv("EAGERX_HOME", EAGERX_SOURCE_DIR, 1); }
  void TearDown() override { unsetenv("EAGERX_HOME"); }

  static GraphOptions options_for(const std::string& graph) {
    GraphOptions options;
    options.graph = std::string(EAGERX_SOURCE_DIR) + "/" + graph;
    return options;
  }
};

TEST_F(Pipeline, GraphsWithoutAProblemNeedOnlyWhatTheyMention) {
  std::size_t graphs = 0;
  for (const auto& folder : fs::directory_iterator(fs::path(EAGERX_SOURCE_DIR) / "examples")) {
    const fs::path graph = folder.path() / "graph.yaml";
    if (!fs::exists(graph)) continue;
    gen::Run run;
    if (!make(run, options_for(fs::relative(graph, EAGERX_SOURCE_DIR).string()))) continue;
    ++graphs;
    EXPECT_FALSE(run.library.whole) << graph;
  }
  EXPECT_GT(graphs, 8U);
}

TEST_F(Pipeline, NoiseNeedsNoMoreThanItsNode) {
  gen::Run run;
  EXPECT_TRUE(make(run, options_for("tests/environments/swing.yaml")));
  EXPECT_FALSE(run.library.whole);
}

TEST_F(Pipeline, AProblemThatListsNothingNeedsNoMore) {
  gen::Run run;
  EXPECT_FALSE(make(run, options_for("tests/diagnostics/cases/cycle.yaml")));
  EXPECT_TRUE(run.diagnostics.has_errors());
  EXPECT_FALSE(run.library.whole);
}

TEST_F(Pipeline, AProblemThatListsWhatThereIsIsSaidOfTheWholeLibrary) {
  GraphOptions options = options_for("examples/pendulum_swing_up/graph.yaml");
  options.engine = "OdeEngin";
  gen::Run run;
  EXPECT_FALSE(make(run, options));
  EXPECT_TRUE(run.library.whole);
  ASSERT_EQ(run.diagnostics.all().size(), 1U);
  EXPECT_EQ(run.diagnostics.all().front().help.text, "did you mean `OdeEngine`?");
}

TEST_F(Pipeline, ALibraryOfEnvironmentsHasTheWholeOfAPlacedGraph) {
  const auto is_placed = [](const std::vector<std::string>& targets) {
    GraphOptions options = options_for("tests/data/placed.yaml");
    options.targets = targets;
    gen::Run run;
    EXPECT_TRUE(make(run, options));
    return run.graph && run.graph->placement.has_value();
  };
  EXPECT_TRUE(is_placed({}));
  EXPECT_TRUE(is_placed({"linux-sim"}));
  EXPECT_FALSE(is_placed({"environments"}));
  EXPECT_TRUE(is_placed({"environments", "linux-sim"})) << "which E0335 then refuses";
}

TEST_F(Pipeline, TargetsAndEnginesOfTheCommandLineAreMentioned) {
  GraphOptions options = options_for("examples/pendulum_swing_up/graph.yaml");
  options.engine = "OpenDynamicsEngine";
  options.targets = {"mps2-an500"};
  gen::Run run;
  EXPECT_TRUE(make(run, options));
  EXPECT_FALSE(run.library.whole);
  EXPECT_TRUE(run.library.targets.contains("mps2-an500"));
}

}  // namespace
}  // namespace eagerx::gen
