#include "generator/frontend/import/import.hpp"

#include <gtest/gtest.h>

#include "generator/frontend/import/saved.hpp"
#include "tests/unit/import/saved_text.hpp"

namespace eagerx::gen {
namespace {

TEST(SavedGraph, IsKnownByItsForm) {
  SourceMap sources;
  Diagnostics diagnostics;
  const auto is_saved = [&](const std::string& text) {
    return is_saved_graph(read_yaml_text("x", text, sources, diagnostics));
  };
  EXPECT_TRUE(is_saved("nodes: {}\nconnects: []\ngui_state: {}\n"));
  EXPECT_TRUE(is_saved("backup: {}\n"));  // cut off
  EXPECT_FALSE(is_saved("nodes: {}\nconnections: []\n"));
  EXPECT_FALSE(is_saved("[nodes, connects, gui_state]\n"));
}

TEST(SavedGraph, ACutOffFileIsAnError) {
  SourceMap sources;
  Diagnostics diagnostics;
  for (const char* text : {"backup: {}\n", "backup: {}\nnodes: {}\n", "backup:\nconnects: []\n"}) {
    const std::size_t before = diagnostics.error_count();
    const YamlValue tree = read_yaml_text("x", text, sources, diagnostics);
    EXPECT_FALSE(read_saved_graph(tree, diagnostics)) << text;
    EXPECT_GT(diagnostics.error_count(), before) << text;
  }
}

TEST(PlainValues, TuplesAndNumpyAreValuesAndOtherObjectsAreNot) {
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("x", R"(
tuple: !!python/tuple [1, !!python/unicode 'a']
scalar: !!python/object/apply:numpy.core.multiarray.scalar
- &id001 !!python/object/apply:numpy.dtype
  args: [f4, false, true]
  state: !!python/tuple [3, <, null, null, null, -1, -1, 0]
- !!binary |
  AADAPw==
array: !!python/object/apply:numpy.core.multiarray._reconstruct
  args: [!!python/name:numpy.ndarray '', !!python/tuple [0], !!binary Yg==]
  state: !!python/tuple [1, !!python/tuple [2], !!python/object/apply:numpy.dtype {args: [i2], state: [3, <]}, false, !!binary AQD+/w==]
wrong: !!python/object/apply:numpy.core.multiarray.scalar [*id001, !!binary AA==]
other: !!python/object:package.Class {a: 1}
)",
                                        sources, diagnostics, Tags::accept);
  ASSERT_FALSE(diagnostics.has_errors()) << render_text(diagnostics, sources, false);
  const YamlValue plain = plain_values(tree);
  EXPECT_EQ(plain.find("tuple")->items[1].text, "a");
  EXPECT_EQ(plain.find("scalar")->text, "1.5");
  ASSERT_EQ(plain.find("array")->items.size(), 2U);
  EXPECT_EQ(plain.find("array")->items[0].text, "1");
  EXPECT_EQ(plain.find("array")->items[1].text, "-2");
  EXPECT_TRUE(is_python_object(*plain.find("wrong")));
  EXPECT_TRUE(is_python_object(*plain.find("other")));
}

TEST(ImportGraph, ChoosesWhatIsNotSavedAndSaysSo) {
  const Import import(file(environment() + object()));
  ASSERT_TRUE(import.graph) << import.report();
  EXPECT_TRUE(import.saved);
  EXPECT_EQ(import.graph->spec.name.value, "state");
  EXPECT_EQ(import.graph->spec.engine.type.value, "OracleEngine");
  EXPECT_EQ(*import.graph->spec.engine.rate->number(), Rational(20));
  EXPECT_EQ(import.graph->spec.rate.value, Rational(20));
  EXPECT_EQ(import.diagnostics.all().size(), 3U);
  for (const auto& d : import.diagnostics.all()) EXPECT_EQ(d.severity, Severity::note);
}

TEST(ImportGraph, TheCommandLineWins) {
  const Import import(file(environment("5") + object()),
                      {"OracleEngine", Rational(100), Rational(1, 3)});
  ASSERT_TRUE(import.graph) << import.report();
  EXPECT_EQ(import.graph->spec.engine.type.value, "OracleEngine");
  EXPECT_EQ(Import(file(environment("5") + object()), {"OracelEngine", {}, {}}).codes(),
            Codes{"E0303"});
  EXPECT_EQ(*import.graph->spec.engine.rate->number(), Rational(100));
  EXPECT_EQ(import.graph->spec.rate.value, Rational(1, 3));
}

TEST(ImportGraph, AnEngineThatIsOnlyNamedIsTaken) {
  const Import import("engine_id: oracle_nodes/OracleEngine\n" + file(environment("5") + object()));
  ASSERT_TRUE(import.graph) << import.report();
  EXPECT_EQ(import.graph->spec.engine.type.span.line, 1U);
  EXPECT_EQ(Import("engine_id: a/B\n" + file(environment("5") + object())).codes(), Codes{"E0801"});
}

TEST(ImportGraph, OnlyWhatDiffersFromTheManifestIsWritten) {
  const std::string text =
      Import(file(environment("10") + object("chain: false, nid: 20", "rate: 1.0"))).text();
  EXPECT_EQ(text.find("sensors:"), std::string::npos) << text;
  EXPECT_NE(text.find("actions: [act]"), std::string::npos) << text;
  const std::string bounded =
      Import(file(environment("10", "{dtype: int64, low: 0, high: 5, shape: [2]}") + object()))
          .text();
  EXPECT_NE(bounded.find("act: {space: {dtype: int64, shape: [2], low: 0, high: 5}}"),
            std::string::npos)
      << bounded;
}

TEST(ImportGraph, ObjectsOfAFlattenedFileArePutBack) {
  const Import import(flattened("{skip: true, window: 1, delay: 0.0}"));
  ASSERT_TRUE(import.graph) << import.report();
  EXPECT_TRUE(import.codes().empty()) << import.report();
  const std::string text = import.text();
  for (const char* part :
       {"name: robot\n", "type: OObjectChain", "config: {number: 30}", "s3: {rate: 10}",
        "st0:", "{from: actions.act, to: obj.a0, window: 3, delay: 0.02}",
        "{from: obj.s3, to: observations.obs}"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(ImportGraph, ADelayOfOurSensorIsTakenBackWhereTheFileHasAnother) {
  const auto connection = [](const std::string& saved, const std::string& ours) {
    std::string text = file(environment("10") + object());
    const std::string key = "window: 1}}\n    outputs";
    text.replace(text.find(key), key.size(), "window: 1, delay: " + saved + "}}\n    outputs");
    const std::string graph = Import(text, {}, ours).text();
    const std::size_t begin = graph.find("{from: obj.s0");
    return graph.substr(begin, graph.find('\n', begin) - begin);
  };
  EXPECT_EQ(connection("0.0", ""), "{from: obj.s0, to: observations.obs}");
  EXPECT_EQ(connection("0.0", "0.25"), "{from: obj.s0, to: observations.obs, delay: 0}");
  EXPECT_EQ(connection("0.25", "0.25"), "{from: obj.s0, to: observations.obs}");
  EXPECT_EQ(connection("0.0", "$(config late)"), "{from: obj.s0, to: observations.obs, delay: 0}");
}

TEST(ImportGraph, ADoubleIsTheSimplestFractionThatRoundsToIt) {
  const auto number = [](const char* text) {
    const auto value = meant_number(made_scalar(text, {}));
    return value ? value->to_string() : "none";
  };
  EXPECT_EQ(number("0.06666666666666667"), "1/15");
  EXPECT_EQ(number("142.85714285714286"), "1000/7");
  EXPECT_EQ(number("33.333333333333336"), "100/3");
  EXPECT_EQ(number("0.007"), "0.007");
  EXPECT_EQ(number("30.0"), "30");
  EXPECT_EQ(number("0"), "0");
  EXPECT_EQ(number("0.3333333"), "0.3333333");  // what somebody wrote so
  EXPECT_EQ(number("0.1234567"), "0.1234567");
  EXPECT_EQ(number("1e-9"), "0.000000001");
  EXPECT_EQ(number("x"), "none");
}

TEST(ImportGraph, AnActionAndItsConnectionKeepTheirProcessors) {
  std::string text = file(environment("10") + object());
  const auto add = [&](const std::string& before, const char* k) {
    const std::size_t place = text.find(before);
    ASSERT_NE(place, std::string::npos);
    text.insert(place + before.size(),
                std::string("processor: {processor_type: oracle_nodes/AddProc, k: ") + k + "}, ");
  };
  add("outputs: {act: {", "31");
  EXPECT_NE(Import(text).text().find("{from: actions.act, to: obj.a0, processor: {type: AddProc, "
                                     "config: {k: 31}}}"),
            std::string::npos)
      << Import(text).text();
  add("actuators: {a0: {", "11");
  const Import both(text);
  EXPECT_NE(both.text().find("to: obj.a0, processor: [{type: AddProc, config: {k: 31}}, {type: "
                             "AddProc, config: {k: 11}}]}"),
            std::string::npos)
      << both.text();
}

TEST(ImportGraph, WhatWasRenderedIsDrawnByOurObject) {
  const std::string picture = "{space: {dtype: uint8, shape: [4, 4, 3]}";
  const std::string image = ", image: " + picture + ", rate: 10}";
  std::string thing =
      object("chain: false, nid: 20", "rate: 10}" + image.substr(0, image.size() - 1));
  thing.replace(thing.find("sensors: [s0]"), 13, "sensors: [s0, image]");
  const std::string nodes =
      environment("10") + thing +
      "  overlay: {node_type: x/Overlay, config: {entity_id: x/Overlay, inputs: [base], outputs: "
      "[image], states: [], rate: 10}, inputs: {base: " +
      picture + "}}, outputs: {image: " + picture +
      "}}}\n"
      "  show: {node_type: eagerx.core.nodes/RenderNode, config: {entity_id: "
      "eagerx.core.nodes/RenderNode, inputs: [image], outputs: [], states: [], rate: 5}, inputs: "
      "{image: " +
      picture + "}}, outputs: {}}\n";
  const std::string links =
      "- [[obj, sensors, image], [overlay, inputs, base]]\n"
      "- [[overlay, outputs, image], [show, inputs, image]]\n";
  const auto text_with = [&](bool draws) {
    SourceMap sources;
    Diagnostics diagnostics;
    const YamlValue tree = read_yaml_text("state.yaml", file(nodes, links), sources, diagnostics);
    Library library = load_library({{"tests/data/import/models", {}}}, sources, diagnostics);
    Entity& ours = library.entities.at("OObject");
    if (draws) {
      PortManifest drawing;
      drawing.name.value = "scene";
      drawing.space.dtype = Spanned<std::string>{"float32", {}};
      drawing.space.shape = made_list({made_scalar("2", {}), made_scalar("16", {})}, {});
      ours.sensors.push_back(drawing);
      ConnectionSpec inside;
      inside.from.value = "s1.o0";
      inside.to.value = "sensors.scene";
      ours.object_engines.front().connections.push_back(inside);
    }
    const auto graph = import_graph(tree, "state.yaml", library, {}, diagnostics);
    return (graph ? write_graph(*graph) : "") + render_text(diagnostics, sources, false);
  };
  const std::string drawn = text_with(true), left_out = text_with(false);
  EXPECT_NE(drawn.find("\nrender: {source: obj.scene, rate: 5}\n"), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("`render:` shows `obj.scene` instead of `obj.image`; left out, as it is "
                       "only for pictures: the node `overlay`"),
            std::string::npos)
      << drawn;
  EXPECT_EQ(left_out.find("render:"), std::string::npos) << left_out;
  EXPECT_NE(left_out.find("left out, as they are only for pictures: the node `show`, the node "
                          "`overlay`, `obj.image`"),
            std::string::npos)
      << left_out;
}

TEST(ImportGraph, DifferencesWithinAnObjectAreWarnings) {
  const Import import(flattened("{skip: false, window: 2, delay: 0.0}"));
  ASSERT_TRUE(import.graph) << import.report();
  EXPECT_EQ(import.codes(), (Codes{"E0806", "E0806"})) << import.report();
}

TEST(ImportGraph, ReferencesCannotGrowWithoutLimit) {
  std::string many = "chain: false, nid: 20, big: [", uses;
  for (int i = 0; i < 20'000; ++i) many += "0,";
  for (int i = 0; i < 20'000; ++i) uses += "$(config big),";
  const Import import(
      file(environment("10") + object(many + "0]", "rate: 10, list: [" + uses + "0]")));
  EXPECT_TRUE(import.graph) << import.report();
}

TEST(ImportGraph, AliasBombsAreRefused) {
  std::string bomb = "a0: &a0 [x]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    bomb +=
        "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last + ", " + last + "]\n";
  }
  const Import import(bomb + file(environment() + object()));
  EXPECT_EQ(import.codes(), Codes{"E0110"}) << import.report();
}

TEST(WriteGraph, TextsSurvive) {
  ImportedGraph graph;
  graph.spec.name.value = "x";
  graph.spec.path = "x.yaml";
  graph.spec.rate.value = Rational(1);
  graph.spec.engine.type.value = "E";
  graph.spec.engine.rate = QuantitySpec{Rational(1), {}};
  const std::vector<std::string> texts = {"plain",      "",           "it's",         "a: b", "#",
                                          "two\nlines", "\x01\t\"\\", "\u00e9\u2028", "null", "-",
                                          "[",          "*a",         "12",           " "};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    YamlValue value;
    value.kind = YamlKind::scalar;
    value.text = texts[i];
    value.quoted = true;
    graph.spec.engine.config.push_back({"t" + std::to_string(i), {}, value});
  }
  SourceMap sources;
  Diagnostics diagnostics;
  const YamlValue tree = read_yaml_text("x.yaml", write_graph(graph), sources, diagnostics);
  ASSERT_FALSE(diagnostics.has_errors()) << render_text(diagnostics, sources, false);
  const YamlValue* config = tree.find("engine")->find("config");
  for (std::size_t i = 0; i < texts.size(); ++i)
    EXPECT_EQ(config->entries.at(i).value.text, texts[i]);
}

}  // namespace
}  // namespace eagerx::gen
