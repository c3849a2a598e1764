// Small files that would take hours or gigabytes: refused at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/formats/statistics.hpp"
#include "generator/policy/network/problem.hpp"
#include "generator/support/json/json.hpp"
#include "tests/unit/formats/onnx_builder.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

using test::expect_problem;
using test::little;
using test::read_bad;
using testing::HasSubstr;

std::string text(const std::string& value) {
  return "X" + little(value.size(), 4) + value;
}
std::string number(std::uint32_t value) {
  return "J" + little(value, 4);
}

/// A torch tensor of all of storage 0, which has `count` values.
std::string tensor(std::uint32_t rows, std::uint32_t columns, std::uint32_t count) {
  return "ctorch._utils\n_rebuild_tensor_v2\n((" + text("storage") + "ctorch\nFloatStorage\n" +
         text("0") + text("cpu") + number(count) + "tQK" + std::string(1, '\0') + "(" +
         number(rows) + number(columns) + "t(" + number(columns) + "K\x01t\x89NtR";
}

TEST(Bombs, DictionariesOfDictionaries) {
  std::string pickle("\x80\x02}q\x00", 5);
  for (char level = 1; level < 8; ++level) {
    pickle += "}(";
    for (int i = 0; i < 60; ++i) pickle += text(std::to_string(i)) + "h" + char(level - 1);
    pickle += std::string("uq") + level;
  }
  expect_problem(read_bad(test::zip({{"a/data.pkl", pickle + "."}})), "E0623",
                 "too many dictionaries");
}

TEST(Bombs, OneLongNameOften) {
  std::string pickle =
      "\x80\x02}(" + text(std::string(5000, 'x')) + "q" + std::string(1, '\0') + "N";
  for (int i = 0; i < 10; ++i) pickle += std::string("h\0N", 3);
  expect_problem(read_bad(test::zip({{"a/data.pkl", pickle + "u."}})), "E0623",
                 "impossible length");
}

TEST(Bombs, LayersOfTheSameBytes) {
  constexpr std::uint32_t kSide = 1450;
  std::string pickle = "\x80\x02}(";
  for (int i = 0; i < 20; i += 2) {
    pickle += text("net." + std::to_string(i) + ".weight") + tensor(kSide, kSide, kSide * kSide);
  }
  const std::string values(std::size_t{4} * kSide * kSide, '\0');
  Diagnostics diagnostics;
  ReadContext context;
  context.activation = Activation::relu;
  const auto network =
      read_policy_bytes(test::zip({{"a/data.pkl", pickle + "u."}, {"a/data/0", values}}), "x", {},
                        diagnostics, context);
  EXPECT_FALSE(network.has_value());
  ASSERT_EQ(diagnostics.all().size(), 1U);
  expect_problem(diagnostics.all().front(), "E0619", "16777216 parameters");
}

TEST(Bombs, JsonOfManyOrDeepValues) {
  EXPECT_FALSE(parse_json(std::string(100'000, '[')).has_value());
  std::string many = "[0";
  for (int i = 0; i < 1'000'000; ++i) many += ",0";
  EXPECT_FALSE(parse_json(many + "]").has_value());
  EXPECT_FALSE(parse_json(R"({"a":{"b":1,"b":2}})").has_value());
  EXPECT_TRUE(parse_json(R"({"a":{"b":1},"b":[{"b":NaN}]})").has_value());
  std::string objects = "{";  // once quadratic
  for (int i = 0; i < 50'000; ++i) objects += "\"" + std::to_string(i) + "\":{},";
  EXPECT_TRUE(parse_json(objects + "\"a\":{}}").has_value());
}

TEST(Bombs, OnnxOfEmptyNodes) {
  std::string nodes;
  for (int i = 0; i < 600'000; ++i) nodes += std::string("\x0a\x00", 2);
  const std::string length = {static_cast<char>(0x80 | (nodes.size() & 0x7f)),
                              static_cast<char>(0x80 | (nodes.size() >> 7 & 0x7f)),
                              static_cast<char>(nodes.size() >> 14)};
  expect_problem(read_bad("\x08\x08\x3a" + length + nodes), "E0619", "more parts");
}

/// `content` as field `tag`.
std::string field(char tag, const std::string& content) {
  std::string bytes(1, tag);
  std::size_t left = content.size();
  for (; left >= 0x80; left >>= 7U) bytes += static_cast<char>(0x80 | (left & 0x7f));
  return bytes + static_cast<char>(left) + content;
}

TEST(Bombs, OnnxOfEmptyNodesBehindTheDeepestMessage) {
  std::string graph;  // graph, node, attribute, graph, …: protobuf reads 100 of them
  for (int i = 0; i < 33; ++i) graph = field('\x0a', field('\x2a', field('\x32', graph)));
  for (int i = 0; i < 600'000; ++i) graph += std::string("\x0a\x00", 2);
  const std::string bytes = "\x08\x08" + field('\x3a', graph);
  EXPECT_TRUE(onnx::ModelProto().ParseFromString(bytes));
  expect_problem(read_bad(bytes), "E0619", "more parts");
}

TEST(Bombs, OnnxOfPackedNumbers) {
  const std::string numbers(9'000'000, '\x01');                     // each becomes eight bytes
  const std::string graph = field('\x2a', field('\x3a', numbers));  // initializer.int64_data
  expect_problem(read_bad("\x08\x08" + field('\x3a', graph)), "E0619", "more parts");
}

TEST(Bombs, OnnxSplitOfManyParts) {
  constexpr int kParts = 20'000;  // each output once looked at all of them
  test::OnnxBuilder builder(kParts, 18);
  onnx::NodeProto& node = builder.add_node("Split", {"observation"}, "p0");
  test::OnnxBuilder::set(node, "axis", std::int64_t{1});
  for (int i = 1; i < kParts; ++i) node.add_output("p" + std::to_string(i));
  builder.add_node("Relu", {"p19999"}, "action");
  expect_problem(read_bad(builder.bytes()), "E0619", "too many values");
}

/// An LSTM over [time, batch, 1] with one value, which starts from `zeros`.
onnx::NodeProto& add_lstm(test::OnnxBuilder& builder, const char* from, const char* to) {
  onnx::NodeProto& node = builder.add_node("LSTM", {from, "w", "r", "", "", "zeros", "zeros"}, to);
  test::OnnxBuilder::set(node, "hidden_size", std::int64_t{1});
  return node;
}

TEST(Bombs, OnnxOfOneLargeStateOften) {
  constexpr std::int64_t kMany = 1'000'000;  // each cell once looked at all of them, twice
  test::OnnxBuilder builder(1);
  auto& shape =
      *builder.graph().mutable_input(0)->mutable_type()->mutable_tensor_type()->mutable_shape();
  shape.clear_dim();
  shape.add_dim()->set_dim_param("time");
  shape.add_dim()->set_dim_param("batch");
  shape.add_dim()->set_dim_value(1);
  builder.add_tensor("w", {1, 4, 1}, std::vector<float>(4, 0.5F));
  builder.add_tensor("r", {1, 4, 1}, std::vector<float>(4, 0.5F));
  builder.add_tensor("zeros", {1, 1, kMany}, std::vector<float>(kMany, 0.0F));
  add_lstm(builder, "observation", "action");
  expect_problem(read_bad(builder.bytes()), "E0640", "computes the state");
}

TEST(Bombs, StatisticsOfALongName) {
  const std::string pickle = "\x80\x04" + std::string("}(") + text("obs_rms") + "}(" +
                             text(std::string(5000, 'x')) + "}uu.";
  PolicyProblem problem;
  EXPECT_FALSE(read_statistics(pickle, problem).has_value());
  EXPECT_EQ(problem.code, "E0627");
}

TEST(Bombs, OneArrayNamedOften) {
  const std::string bytes(std::size_t{8} * 20'000, '\0');
  const std::string type = "cnumpy\ndtype\n" + text("f8") + "\x89\x88\x87R";
  const std::string array = "cnumpy.core.numeric\n_frombuffer\n(B" + little(bytes.size(), 4) +
                            bytes + type + number(20'000) + "\x85" + text("C") + "tR";
  std::string pickle = "\x80\x04" + std::string("}(") + text("obs_rms") + "}(";
  pickle += text("0") + "}(" + text("mean") + array + "q\x01" + text("var") + "h\x01uq\x02";
  PolicyProblem problem;
  const auto good = read_statistics(pickle + "uu.", problem);
  ASSERT_TRUE(good.has_value()) << problem.message;
  EXPECT_EQ(good->mean.size(), 20'000U);
  for (int i = 1; i < 400; ++i) pickle += text(std::to_string(i)) + "h\x02";
  EXPECT_FALSE(read_statistics(pickle + "uu.", problem).has_value());
  EXPECT_EQ(problem.code, "E0627");
}

}  // namespace
}  // namespace eagerx::gen
