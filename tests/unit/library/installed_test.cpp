#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {
namespace {

const std::string kSource = EAGERX_SOURCE_DIR;

TEST(DeclaredId, IsThePlainWordOfTheOnlyLine) {
  EXPECT_EQ(declared_id("id: Pendulum\n"), "Pendulum");
  EXPECT_EQ(declared_id("kind: target\nid:  linux-sim  # a comment\nsummary: x"), "linux-sim");
  EXPECT_EQ(declared_id("kind: node\nid: Last"), "Last");
}

TEST(DeclaredId, IsUnknownWhereOnlyAParserCanTell) {
  for (const char* text : {"kind: node\n", "kind: node\nid:\n  Far\n", "id: \"Quoted\"\n",
                           "id: 'Quoted'\n", "{kind: node, id: Flow}\n", "id: A\nid: B\n",
                           "kind: node\nid: A\nid: B\n", "id: &a Anchor\n", "id: Two words\n",
                           "id: Word#more\n", "id:NoSpace\n", "id : Apart\n", "  id: Inside\n", ""})
    EXPECT_EQ(declared_id(text), std::nullopt) << text;
}

class Installed : public testing::Test {
 protected:
  Library load(const std::vector<Spanned<std::string>>& folders = {}) {
    return load_library(folders, sources_, diagnostics_,
                        {{kSource + "/models", {}}, {kSource + "/targets", {}}});
  }

  SourceMap sources_;
  Diagnostics diagnostics_;
};

TEST_F(Installed, AManifestIsReadWhenItsIdIsAskedFor) {
  const Library library = load();
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_TRUE(library.entities.empty());
  ASSERT_NE(library.find("Pendulum"), nullptr);
  EXPECT_EQ(library.find("Pendulum"), library.find("Pendulum"));
  EXPECT_EQ(library.entities.size(), 1U);
  EXPECT_EQ(library.find("linux-sim"), nullptr);  // a target
  EXPECT_NE(library.find_target("linux-sim"), nullptr);
  EXPECT_EQ(library.find("Pendulun"), nullptr);
  EXPECT_EQ(library.entities.size() + library.targets.size(), 2U);
}

TEST_F(Installed, WhatIsReadInAnotherOrderIsTheSame) {
  const Library library = load();
  for (const char* id : {"Pendulum", "OdeEngine", "Gain"}) ASSERT_NE(library.find(id), nullptr);
  SourceMap sources;
  const Library eager =
      load_library({{kSource + "/models", {}}, {kSource + "/targets", {}}}, sources, diagnostics_);
  EXPECT_LT(library.entities.size(), eager.entities.size());
  EXPECT_EQ(library.all_entities().size(), eager.entities.size());
  EXPECT_EQ(library.all_targets().size(), eager.targets.size());
  for (const auto& [id, entity] : library.entities) {
    const Entity* same = eager.find(id);
    ASSERT_NE(same, nullptr) << id;
    EXPECT_EQ(entity.id.span.file, same->id.span.file) << id;
    EXPECT_EQ(entity.path, same->path);
    EXPECT_EQ(entity.include_root, same->include_root);
  }
}

TEST_F(Installed, FoldersOfUsersAreReadAtOnce) {
  EXPECT_TRUE(load({{kSource + "/tests/data/library", {}}}).entities.contains("LeakySum"));
}

TEST_F(Installed, AnIdOfTheUserThatIsInstalledTooIsFoundTwice) {
  const auto folder = std::filesystem::temp_directory_path() / "eagerx_installed_test" / "gain";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "manifest.yaml") << "kind: node\nid: Gain\nsummary: another\n"
                                             "class: Gain\nheader: gain.hpp\n";
  const Library library = load({{folder.parent_path().string(), {}}});
  std::filesystem::remove_all(folder.parent_path());
  ASSERT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(diagnostics_.all().back().code, "E0302") << diagnostics_.all().back().message;
}

}  // namespace
}  // namespace eagerx::gen
