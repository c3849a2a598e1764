#include "generator/frontend/import/entity_mapping.hpp"

#include <gtest/gtest.h>

#include "tests/unit/import/saved_text.hpp"

namespace eagerx::gen {
namespace {

TEST(ImportGraph, ParametersDecideWhichEntityIsMeant) {
  EXPECT_NE(
      Import(file(environment() + object("chain: false, nid: 20"))).text().find("type: OObject\n"),
      std::string::npos);
  EXPECT_NE(Import(file(environment() + object("chain: true, nid: 20")))
                .text()
                .find("type: OObjectChain\n"),
            std::string::npos);
  const Import neither(file(environment() + object("chain: 3, nid: 20")));
  EXPECT_EQ(neither.codes(), Codes{"E0801"});
  EXPECT_NE(neither.report().find("for these parameters"), std::string::npos);
}

TEST(ImportGraph, ParametersAreRenamedAndUnknownOnesNoted) {
  const Import import(file(environment("10") + object("chain: false, nid: 7, extra: 3")));
  EXPECT_NE(import.text().find("config: {number: 7}"), std::string::npos);
  EXPECT_NE(import.report().find("`extra` of the object `obj` is left out"), std::string::npos);
}

TEST(ImportGraph, AClassOfAScriptIsOnlyOursWithTheSameInterface) {
  Library library;
  Entity entity;
  entity.id.value = "Own";
  entity.inputs.resize(1);
  entity.inputs[0].name.value = "i0";
  Diagnostics diagnostics;
  EntityMapping mapping(library, diagnostics);
  SavedEntity saved;
  saved.id.value = "__main__/Own";
  EXPECT_FALSE(mapping.may_stand_in(entity, saved, "the node `n`"));  // no input i0
  EXPECT_EQ(diagnostics.error_count(), 1U);
  saved.ports["inputs"].push_back({{"i0", {}}, {}});
  EXPECT_TRUE(mapping.may_stand_in(entity, saved, "the node `n`"));
  EXPECT_EQ(diagnostics.all().back().severity, Severity::warning);
  saved.config.kind = YamlKind::map;
  saved.config.entries.push_back({"gain", {}, made_scalar("2", {})});
  EXPECT_FALSE(mapping.may_stand_in(entity, saved, "the node `n`"));  // an unknown parameter
  saved.config.entries.clear();
  entity.config.resize(1);
  entity.config[0].eagerx = "n";
  EXPECT_FALSE(mapping.may_stand_in(entity, saved, "the node `n`"));  // has no n
  EXPECT_FALSE(mapping.may_stand_in(entity, saved, "the node `n`"));
  EXPECT_EQ(diagnostics.error_count(), 3U) << "reported twice";
  saved.id.value = "own.module/Own";
  EXPECT_TRUE(mapping.may_stand_in(entity, saved, "the node `n`"));
  saved.id.value = "__main__/Own";
  entity.own = true;
  EXPECT_TRUE(mapping.may_stand_in(entity, saved, "the node `n`"));  // its user says so
  EXPECT_EQ(diagnostics.error_count(), 3U);
}

TEST(ImportGraph, AUsersOwnEntityIsTakenForAClassOfAScript) {
  Library library;
  for (const auto* id : {"A", "B", "C"}) {
    Entity& entity = library.entities[id];
    entity.id.value = id;
    entity.eagerx_ids = {{{"__main__/Own", {}}, {}}, {{"module/Own", {}}, {}}};
    entity.own = std::string_view(id) == "B";
  }
  Diagnostics diagnostics;
  EntityMapping mapping(library, diagnostics);
  YamlValue none;
  none.kind = YamlKind::map;
  const Entity* found = mapping.find({"__main__/Own", {}}, none, Use::node, "the node `n`");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->id.value, "B");
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_NE(mapping.find({"module/Own", {}}, none, Use::node, "the node `n`"), nullptr);
  EXPECT_TRUE(diagnostics.has_errors()) << "three entities stand for the same class";
}

}  // namespace
}  // namespace eagerx::gen
