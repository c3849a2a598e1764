// One file by two names.
#include "generator/support/files/files.hpp"

#include <filesystem>

#include "generator/support/files/missing_file.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

class FilesTest : public testing::Test {
 protected:
  void SetUp() override { forget_files(); }
  void TearDown() override { forget_files(); }
  [[nodiscard]] std::string at(const std::string& name) const {
    return folder_.path() + "/" + name;
  }

  const TestFolder folder_;
};

TEST_F(FilesTest, AnOutputIsNoInputByAnyNameOrLink) {
  const std::string input = folder_.file("in.yaml", "x");
  fs::create_symlink(input, at("link"));
  fs::create_hard_link(input, at("hard"));
  const std::string around = at("../" + fs::path(folder_.path()).filename().string() + "/in.yaml");
  for (const std::string& name : {input, at("link"), at("hard"), around}) {
    forget_files();
    remember_input(input, "the graph");
    EXPECT_EQ(input_at(name), "the graph") << name;
    EXPECT_FALSE(find_one_file());
    remember_output(name, "--csv");
    const auto found = find_one_file();
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->output, "--csv");
    EXPECT_EQ(found->other, "the graph");
  }
  EXPECT_FALSE(input_at(at("out.yaml")));
}

TEST_F(FilesTest, NorAFileThatIsAboutToBeWritten) {
  remember_output(at("a"), "--csv");
  EXPECT_FALSE(find_one_file({at("b")}));
  EXPECT_TRUE(find_one_file({at("b"), at("a")}));
}

TEST_F(FilesTest, TwoOutputsAreTwoFilesThoughNeitherIsThere) {
  remember_output(at("a"), "--csv");
  EXPECT_FALSE(find_one_file());
  remember_output(at("b"), "--trace");
  EXPECT_FALSE(find_one_file());
  remember_output(at("x/../a"), "--json");
  const auto found = find_one_file();
  ASSERT_TRUE(found);
  EXPECT_NE((found->output + found->other).find("--json"), std::string::npos);
}

TEST_F(FilesTest, WhatIsForgottenIsNotInTheWay) {
  const std::string input = folder_.file("in", "x");
  remember_input(input);
  remember_output(input, "--csv");
  forget_files();
  EXPECT_FALSE(find_one_file());
  EXPECT_FALSE(input_at(input));
}

TEST_F(FilesTest, AMissingFileHasANearNameOrAFewOfItsKindOrNoFolder) {
  const std::string graph = folder_.file("graph.yaml", "x");
  EXPECT_EQ(help_for_missing(graph, "graph.yaml").text, "");
  EXPECT_EQ(help_for_missing(at("grahp.yaml"), "sub/grahp.yaml").text,
            "did you mean `sub/graph.yaml`?");
  EXPECT_EQ(help_for_missing(at("grap.yml"), "grap.yml").text, "did you mean `graph.yaml`?");
  EXPECT_EQ(help_for_missing(at("x.yaml"), "x.yaml").text, "available: `graph.yaml`");
  EXPECT_EQ(help_for_missing(at("x.onnx"), "x.onnx").text, "");
  EXPECT_EQ(help_for_missing(at("no/graph.yaml"), "no/graph.yaml").text, "there is no folder `no`");
  // A long end makes nothing near.
  const std::string other = folder_.file("a.manifest", "x");
  EXPECT_EQ(help_for_missing(other, "a.manifest").text, "");
  EXPECT_EQ(help_for_missing(at("motor.manifest"), "motor.manifest").text,
            "available: `a.manifest`");
}

}  // namespace
}  // namespace eagerx::gen
