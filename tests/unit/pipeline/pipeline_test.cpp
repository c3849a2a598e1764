#include "generator/driver/pipeline/pipeline.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace eagerx::gen {
namespace {

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

TEST_F(Pipeline, AGraphReadsOnlyTheManifestsThatItUses) {
  gen::Run run;
  EXPECT_TRUE(make(run, options_for("tests/environments/swing.yaml")));
  const std::size_t used = run.library.entities.size();
  EXPECT_TRUE(run.library.entities.contains("Pendulum"));
  EXPECT_FALSE(run.library.entities.contains("Quadruped"));
  EXPECT_GT(run.library.all_entities().size(), 3 * used);
}

TEST_F(Pipeline, AProblemListsAllThatThereIs) {
  GraphOptions options = options_for("examples/pendulum_swing_up/graph.yaml");
  options.engine = "OdeEngin";
  gen::Run run;
  EXPECT_FALSE(make(run, options));
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

TEST_F(Pipeline, TargetsAndEnginesOfTheCommandLineAreFound) {
  GraphOptions options = options_for("examples/pendulum_swing_up/graph.yaml");
  options.engine = "OpenDynamicsEngine";
  options.targets = {"mps2-an500"};
  gen::Run run;
  EXPECT_TRUE(make(run, options));
  EXPECT_NE(run.library.find_target("mps2-an500"), nullptr);
}

}  // namespace
}  // namespace eagerx::gen
