// The data of a graph that a part in another language receives.
#include <eagerx/link/frame.hpp>

#include "generator/backend/languages/package.hpp"
#include "generator/support/json/json.hpp"
#include "tests/unit/stages/graphs.hpp"

namespace eagerx::gen {
namespace {

constexpr std::uint64_t kHash = 0x0123456789abcdefU;

/// The pendulum with its filter in Python, which runs at `rate`.
std::unique_ptr<GraphOfText> placed_in_python(const std::string& rate = "30",
                                              const std::string& more = "") {
  return graph_of_text(swing(rate, "placement: {smooth: {part: filter, target: python}}\n" + more));
}

Json layout_of_text(const GraphOfText& graph) {
  const auto json =
      parse_json(layout_json(*graph.plan, layout_of_part(*graph.plan, 0), kHash, "0.2.1"));
  EXPECT_TRUE(json);
  return json.value_or(Json());
}

const Json& at(const Json& list, std::size_t i) {
  return list.as<Json::List>()->at(i);
}
std::size_t size(const Json* list) {
  return list->as<Json::List>()->size();
}

TEST(Languages, ALayoutSaysWhatCrossesTheLineAndInWhichOrder) {
  const auto graph = placed_in_python();
  const Json json = layout_of_text(*graph);
  EXPECT_EQ(text_of(member(&json, "format")), "eagerx part 1");
  EXPECT_EQ(text_of(member(&json, "part")), "filter");
  EXPECT_EQ(text_of(member(&json, "runtime")), "0.2");
  EXPECT_EQ(text_of(member(&json, "hash")), "0x0123456789abcdef");
  const Json* const messages = member(&json, "messages");
  ASSERT_EQ(size(messages), 2U);
  EXPECT_EQ(text_of(member(&at(*messages, 0), "port")), "actions.voltage");
  EXPECT_EQ(text_of(member(&at(*messages, 0), "to")), "part");
  EXPECT_EQ(text_of(member(&at(*messages, 1), "name")), "smooth/filtered");
  EXPECT_EQ(text_of(member(&at(*messages, 1), "to")), "hub");
  EXPECT_EQ(number_of(member(&at(*messages, 1), "bytes")), 4.0);
  EXPECT_EQ(integers_of(member(&json, "actions")), std::vector<std::int64_t>{0});
  const Json* const after = member(&json, "after");
  ASSERT_EQ(size(after), 1U) << "the filter waits for the action";
  EXPECT_EQ(truth_of(member(&at(*after, 0), "runs")), true);
  EXPECT_EQ(size(member(&json, "before")), 0U);
}

TEST(Languages, TheHashIsThatOfPrograms) {
  EXPECT_EQ(hash_of_part(kHash, "filter"), link::hash_of_part(kHash, "filter"));
}

TEST(Languages, RatesAreCountedAsInThePlan) {
  const auto graph = placed_in_python("15");
  const Json json = layout_of_text(*graph);
  const Json* const rates = member(&json, "rates");
  ASSERT_EQ(size(rates), 2U);
  EXPECT_EQ(text_of(member(&at(*rates, 1), "rate")), "15/1");
  EXPECT_EQ(number_of(member(&at(*rates, 1), "period")),
            2 * *number_of(member(&at(*rates, 0), "period")));
  const Json& input = at(*member(&at(*member(&json, "nodes"), 0), "inputs"), 0);
  EXPECT_EQ(number_of(member(&input, "a")), 2.0);
  EXPECT_EQ(number_of(member(&input, "b")), 1.0);
}

TEST(Languages, AFolderIsWrittenOnceWhereItIsTheUsers) {
  const auto graph = placed_in_python();
  const auto files = emit_language(*graph->plan, 0, kHash, "0.2.1", graph->diagnostics);
  ASSERT_TRUE(files) << graph->codes();
  std::string yours;
  for (const GeneratedFile& file : *files) {
    if (file.yours) yours += file.path + "\n" + file.text;
  }
  EXPECT_TRUE(yours.starts_with("nodes.py\n")) << yours;
  EXPECT_NE(yours.find("def step(self, n, signal):"), std::string::npos) << yours;
  EXPECT_NE(yours.find("\"smooth\": Smooth,"), std::string::npos) << yours;
}

TEST(Languages, WhatOnlyCppCanDoIsRefused) {
  const auto refused = [](const std::string& text) {
    const auto graph = graph_of_text(text);
    check_languages(*graph->plan, 0, graph->diagnostics);
    return graph->codes();
  };
  EXPECT_EQ(refused(swing("30", "placement: {agent: {part: mind, target: python}}\n")), "E0350");
  EXPECT_EQ(refused(swing("30", "placement: {smooth: {part: filter, target: python}}\n")), "");
  const auto with_processor = [](std::string text) {
    const std::string plain = "to: smooth.signal}";
    text.replace(text.find(plain), plain.size(), "to: smooth.signal, processor: Identity}");
    return text;
  };
  EXPECT_EQ(
      refused(with_processor(swing("30", "placement: {smooth: {part: filter, target: python}}\n"))),
      "E0350");
}

}  // namespace
}  // namespace eagerx::gen
