// The stages of compose that work on trees: elements of arrays, gathered messages, variants.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "generator/frontend/compose/arrays.hpp"
#include "generator/frontend/compose/flat_text.hpp"
#include "generator/frontend/compose/gather.hpp"
#include "generator/frontend/compose/variants.hpp"

namespace eagerx::gen {
namespace {

struct Tree {
  SourceMap sources;
  Diagnostics diagnostics;
  YamlValue root;

  explicit Tree(std::string text)
      : root(read_yaml_text("graph.yaml", std::move(text), sources, diagnostics)) {}

  [[nodiscard]] std::string codes() const {
    std::string all;
    for (const Diagnostic& each : diagnostics.all()) all += each.code;
    return all;
  }
};

TEST(Arrays, HaveTheirCountOfElements) {
  struct Row {
    std::string text;
    std::optional<std::int64_t> count;
    std::string codes;
  };
  const std::vector<Row> rows = {{"type: Gain", std::nullopt, ""},
                                 {"count: 3", 3, ""},
                                 {"count: $(config legs)", 4, ""},
                                 {"count: $(2 * config legs)", 8, ""},
                                 {"count: $(config legs / 8)", 0, "E0203"},
                                 {"count: 0", 0, "E0204"},
                                 {"count: 10001", 0, "E0204"},
                                 {"count: many", 0, "E0203"}};
  const References references = {{parameter_reference("legs"), made_number(std::int64_t{4}, {})}};
  for (const Row& row : rows) {
    Tree tree(row.text);
    EXPECT_EQ(count_of(tree.root, references, tree.diagnostics), row.count) << row.text;
    EXPECT_EQ(tree.codes(), row.codes) << row.text;
  }
}

TEST(Arrays, GiveEachElementItsIndexAndItsValue) {
  struct Row {
    std::string text, element;  // element 1 of 3
    std::string codes;
  };
  const std::vector<Row> rows = {
      {"{count: 3, rate: 10}", "rate: 10\n", ""},
      {"{port: $(index)}", "port: 1\n", ""},
      {"{phase: $(index / 3)}", "phase: 1/3\n", ""},
      {"{gain: {each: [0.5, 0.25, 0.125]}}", "gain: 0.25\n", ""},
      {"{gain: {each: [0.5, 0.25]}}", "", "E0391"},
      {"{gain: {each: 0.5}}", "", "E0391"},
  };
  for (const Row& row : rows) {
    Tree tree(row.text);
    Diagnostics of_first;
    element_of(tree.root, 0, 3, {}, of_first);
    const YamlValue element = element_of(tree.root, 1, 3, {}, tree.diagnostics);
    std::string codes;
    for (const Diagnostic& each : of_first.all()) codes += each.code;
    EXPECT_EQ(codes, row.codes) << row.text;
    EXPECT_EQ(tree.codes(), "") << row.text;  // said of the first element
    if (row.codes.empty()) {
      EXPECT_EQ(flat_text(element, tree.sources), row.element) << row.text;
    }
  }
  EXPECT_EQ(element_name("leg", 2), "leg[2]");
}

std::vector<GatheredElement> elements(const std::vector<std::int64_t>& indices) {
  std::vector<GatheredElement> result;
  for (const std::int64_t index : indices)
    result.push_back({index, {fmt::format("lag[{}].y", index), {}}, Tree("{skip: true}").root});
  return result;
}

TEST(Gather, MakesOneMessageOfItsElements) {
  Diagnostics diagnostics;
  const YamlValue rate = made_number(std::int64_t{10}, {});
  const auto two = gather({"observations.y", {}}, elements({0, 1}), rate, diagnostics);
  ASSERT_TRUE(two);
  ASSERT_EQ(two->nodes.size(), 1U);
  EXPECT_EQ(two->nodes[0].key, "mux/observations/y");
  EXPECT_EQ(two->connections.size(), 2U);
  EXPECT_EQ(two->nodes[0].value.find("config")->find("size")->text, "2");
  // Four inputs a node: five elements need a second one.
  const auto five = gather({"observations.y", {}}, elements({0, 1, 2, 3, 4}), rate, diagnostics);
  ASSERT_TRUE(five);
  EXPECT_EQ(five->nodes.size(), 2U);
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(Gather, NeedsEachElementOnce) {
  for (const auto& indices : {std::vector<std::int64_t>{0, 2}, {1, 2}, {0, 1, 1}, {0, 0}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(gather({"observations.y", {}}, elements(indices),
                        made_number(std::int64_t{10}, {}), diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(diagnostics.all().front().code, "E0391");
  }
}

TEST(Variants, AreLaidOverTheGraphKeyByKey) {
  const std::string text =
      "rate: 10\n"
      "nodes: {a: {type: Gain, config: {gain: 1.0}}}\n"
      "variants:\n"
      "  fast: {rate: 20}\n"
      "  strong: {nodes: {a: {config: {gain: 5.0}}}}\n";
  struct Row {
    std::string variant, flat, codes;
  };
  const std::vector<Row> rows = {
      {"", "rate: 10\nnodes:\n  a: {type: Gain, config: {gain: 1.0}}\n", ""},
      {"fast", "rate: 20\nnodes:\n  a: {type: Gain, config: {gain: 1.0}}\n", ""},
      {"strong", "rate: 10\nnodes:\n  a: {type: Gain, config: {gain: 5.0}}\n", ""},
      {"slow", "", "E0394"},
  };
  for (const Row& row : rows) {
    Tree tree(text);
    const YamlValue root =
        choose_variant(tree.root, "graph.yaml", row.variant, tree.sources, tree.diagnostics);
    EXPECT_EQ(tree.codes(), row.codes) << row.variant;
    if (row.codes.empty()) {
      EXPECT_EQ(flat_text(root, tree.sources), row.flat) << row.variant;
    }
  }
  Tree tree(text);
  EXPECT_EQ(variants_of(tree.root, "graph.yaml", tree.sources, tree.diagnostics),
            (std::vector<std::string>{"fast", "strong"}));
}

}  // namespace
}  // namespace eagerx::gen
