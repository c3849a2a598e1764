#include "generator/frontend/library/mentions.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {
namespace {

const std::string kSource = EAGERX_SOURCE_DIR;

YamlValue yaml(const std::string& text) {
  SourceMap sources;
  Diagnostics diagnostics;
  YamlValue tree = read_yaml_text("x.yaml", text, sources, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << text;
  return tree;
}

std::set<std::string> all_of(Mentions& mentions) {
  std::set<std::string> texts;
  while (const auto text = mentions.next()) EXPECT_TRUE(texts.insert(*text).second) << *text;
  return texts;
}

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

TEST(Mentions, AreTextsAndKeysOnce) {
  Mentions mentions;
  mentions.add(yaml("{nodes: {a: {type: Gain, config: {x: [1, Gain]}}}}"));
  EXPECT_EQ(all_of(mentions),
            (std::set<std::string>{"", "nodes", "a", "type", "Gain", "config", "x", "1"}));
  mentions.add("Gain");
  mentions.add("Sum");
  EXPECT_EQ(all_of(mentions), std::set<std::string>{"Sum"});
}

TEST(Mentions, OfAnObjectsEnginesAreThoseOfMentionedEngines) {
  const YamlValue object = yaml(
      "{kind: object, engines: {First: {nodes: {x: {type: OfFirst}}}, Second: {nodes: {x: {type: "
      "OfSecond}}}}}");
  const YamlValue node = yaml("{kind: engine_node, engines: [Second]}");
  Mentions mentions;
  mentions.add("First");
  mentions.add_manifest(object);
  mentions.add_manifest(node);
  const auto before = all_of(mentions);
  EXPECT_TRUE(before.contains("OfFirst"));
  EXPECT_FALSE(before.contains("OfSecond"));
  EXPECT_FALSE(before.contains("Second"));
  mentions.add("Second");
  EXPECT_TRUE(all_of(mentions).contains("OfSecond"));
}

class LoadMentioned : public testing::Test {
 protected:
  Library load(const std::vector<std::string>& mentioned,
               const std::vector<Spanned<std::string>>& folders = {}) {
    Mentions mentions;
    for (const auto& text : mentioned) mentions.add(text);
    return load_mentioned(std::move(mentions), folders,
                          {{kSource + "/models", {}}, {kSource + "/targets", {}}}, sources_,
                          diagnostics_);
  }

  SourceMap sources_;
  Diagnostics diagnostics_;
};

TEST_F(LoadMentioned, HasWhatIsMentionedAndWhatThatNeeds) {
  const Library library = load({"Pendulum", "OdeEngine", "linux-sim"});
  EXPECT_FALSE(diagnostics_.has_errors());
  EXPECT_FALSE(library.whole);
  for (const char* id : {"Pendulum", "OdeEngine", "OdeInput", "OdeEngineState", "ActionApplied"})
    EXPECT_NE(library.find(id), nullptr) << id;
  for (const char* id : {"Quadruped", "RealEngine", "GymPendulum", "Gain"})
    EXPECT_EQ(library.find(id), nullptr) << id;
  EXPECT_TRUE(library.targets.contains("linux-sim"));
  EXPECT_EQ(library.targets.size(), 1U);
}

TEST_F(LoadMentioned, PlacesAreInTheOrderOfTheWholeLibrary) {
  // They are read in another order.
  const Library library = load({"Pendulum", "OdeEngine"});
  SourceMap sources;
  const Library whole =
      load_library({{kSource + "/models", {}}, {kSource + "/targets", {}}}, sources, diagnostics_);
  EXPECT_TRUE(whole.whole);
  EXPECT_GT(library.entities.size(), 1U);
  EXPECT_LT(library.entities.size(), whole.entities.size());
  for (const auto& [id, entity] : library.entities) {
    const Entity* same = whole.find(id);
    ASSERT_NE(same, nullptr) << id;
    EXPECT_EQ(entity.id.span.file, same->id.span.file) << id;
    EXPECT_EQ(entity.path, same->path);
    EXPECT_EQ(entity.include_root, same->include_root);
  }
}

TEST_F(LoadMentioned, FoldersOfUsersAreReadWhole) {
  const Library library = load({}, {{kSource + "/tests/data/library", {}}});
  EXPECT_NE(library.find("LeakySum"), nullptr);
}

TEST_F(LoadMentioned, AnIdOfTheUserThatIsInstalledTooIsFoundTwice) {
  const auto folder = std::filesystem::temp_directory_path() / "eagerx_mentions_test" / "gain";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "manifest.yaml") << "kind: node\nid: Gain\nsummary: another\n"
                                             "class: Gain\nheader: gain.hpp\n";
  load({}, {{folder.parent_path().string(), {}}});
  std::filesystem::remove_all(folder.parent_path());
  ASSERT_TRUE(diagnostics_.has_errors());
  EXPECT_EQ(diagnostics_.all().back().code, "E0302") << diagnostics_.all().back().message;
}

}  // namespace
}  // namespace eagerx::gen
