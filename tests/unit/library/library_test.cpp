#include "generator/frontend/library/library.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace eagerx::gen {
namespace {

const std::string kRoot = EAGERX_SOURCE_DIR;

Library load(const std::vector<std::string>& folders, Diagnostics& diagnostics) {
  static SourceMap sources;
  std::vector<Spanned<std::string>> named;
  for (const auto& folder : folders) named.push_back({folder, {}});
  return load_library(named, sources, diagnostics);
}

TEST(LoadLibrary, FindsEveryEntityAndTarget) {
  Diagnostics diagnostics;
  const Library library = load({kRoot + "/models", kRoot + "/targets"}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  for (const char* id : {"OdeEngine", "Pendulum", "ButterworthFilter", "DecomposedAngle",
                         "OdeInput", "OdeEngineState"})
    EXPECT_NE(library.find(id), nullptr) << id;
  EXPECT_TRUE(library.targets.contains("linux-sim"));
  for (const auto& [id, entity] : library.entities) {
    if (entity.cpp.include.empty()) continue;
    EXPECT_TRUE(std::filesystem::exists(kRoot + "/" + entity.cpp.include))
        << id << ": " << entity.cpp.include;
    // Engines of a board lie next to its drivers.
    EXPECT_TRUE(entity.cpp.include.starts_with("models/") ||
                entity.cpp.include.starts_with("targets/"))
        << entity.cpp.include;
  }
}

TEST(LoadLibrary, IncludesAreRelativeHoweverTheFolderIsWritten) {
  for (const std::string folder :
       {"tests/data/library", "./tests/data/library/", "tests/data/../data/library"}) {
    Diagnostics diagnostics;
    const Library library = load({folder}, diagnostics);  // the tests run at the root
    ASSERT_FALSE(diagnostics.has_errors()) << folder;
    const Entity* node = library.find("LeakySum");
    ASSERT_NE(node, nullptr) << folder;
    EXPECT_EQ(node->cpp.include, "library/nodes/leaky_sum/leaky_sum.hpp") << folder;
    EXPECT_EQ(node->include_root, kRoot + "/tests/data") << folder;
    EXPECT_EQ(node->config.size(), 7U);
  }
}

TEST(LoadLibrary, AFolderNamedTwiceIsReadOnce) {
  Diagnostics diagnostics;
  const Library library = load({"tests/data/library", kRoot + "/tests/data/library/"}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(library.entities.size(), 1U);
}

TEST(LoadLibrary, OfTwoCopiesTheFirstCounts) {
  Diagnostics diagnostics;
  // Two roots that see the same manifest, as a clone next to an installed library does.
  const Library library = load({"tests/data/library", "tests/data"}, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  ASSERT_NE(library.find("LeakySum"), nullptr);
  EXPECT_EQ(library.find("LeakySum")->cpp.include, "library/nodes/leaky_sum/leaky_sum.hpp");
}

TEST(LoadLibrary, TheSameIdFromTwoFilesIsAnErrorAtBoth) {
  const std::string copy = testing::TempDir() + "eagerx-library-copy";
  std::filesystem::create_directories(copy);
  std::ifstream original("tests/data/library/nodes/leaky_sum/manifest.yaml");
  std::ofstream(copy + "/manifest.yaml") << "# another version\n" << original.rdbuf();
  Diagnostics diagnostics;
  load({"tests/data/library", copy}, diagnostics);
  std::filesystem::remove_all(copy);
  ASSERT_EQ(diagnostics.error_count(), 1U);
  const Diagnostic& problem = diagnostics.all().front();
  EXPECT_EQ(problem.code, "E0302");
  ASSERT_EQ(problem.notes.size(), 1U);
}

TEST(LoadLibrary, AFolderThatIsNotThereIsAnInputError) {
  Diagnostics diagnostics;
  load({"tests/data/no_such_folder"}, diagnostics);
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_TRUE(diagnostics.has_io_errors());
  EXPECT_EQ(diagnostics.all().front().code, "E0301");
}

TEST(EntityManifest, NamesItsEagerxIdsAndParameters) {
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("manifest.yaml", R"(
kind: processor
id: Chained
eagerx: [module/Plain, {id: module/Other, when: {chain: true, size: 2}}]
summary: A processor.
header: chained.hpp
class: Chained
config:
  gain: {type: float, eagerx: k, about: a factor}
  offset: {type: float, about: a summand}
output: {like: input}
)",
                                        sources, diagnostics);
  const auto entity = read_entity_manifest(tree, "manifest.yaml", diagnostics);
  ASSERT_TRUE(entity) << render_text(diagnostics, sources, false);
  ASSERT_EQ(entity->eagerx_ids.size(), 2U);
  EXPECT_EQ(entity->eagerx_ids[0].id.value, "module/Plain");
  EXPECT_TRUE(entity->eagerx_ids[0].when.empty());
  EXPECT_EQ(entity->eagerx_ids[1].id.value, "module/Other");
  ASSERT_EQ(entity->eagerx_ids[1].when.size(), 2U);
  EXPECT_EQ(entity->eagerx_ids[1].when[0].name, "chain");
  EXPECT_EQ(entity->eagerx_ids[1].when[1].value.text, "2");
  EXPECT_EQ(entity->config[0].eagerx, "k");
  EXPECT_EQ(entity->config[1].eagerx, "offset");
}

TEST(ManifestFormat, EveryKindHasOne) {
  for (const auto& kind : manifest_kinds()) EXPECT_NE(manifest_format(kind), nullptr) << kind;
  EXPECT_EQ(manifest_format("gizmo"), nullptr);
}

}  // namespace
}  // namespace eagerx::gen
