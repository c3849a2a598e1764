// Tables of large policies as bytes: those that the compiler makes of the same tables as text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <eagerx/policy/convolution.hpp>
#include <eagerx/policy/int8.hpp>
#include <eagerx/policy/recurrent.hpp>
#include <string>
#include <vector>

#include "generator/backend/emit/policy_view.hpp"
#include "generator/policy/network/int8.hpp"
#include "tests/unit/emit/policy_header.hpp"

namespace eagerx::gen {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<float> counted(std::size_t count, float first = 1.0F) {
  std::vector<float> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = first + static_cast<float>(i);
  return values;
}

Network network_of(Layer layer) {
  Network network;
  network.file = "large.onnx";
  network.format = "ONNX";
  network.layers.push_back(std::move(layer));
  return network;
}

std::string bytes_of(const Network& network) {
  PolicyTables tables(PolicyTables::Kind::stored, "graphs::robot::policy");
  policy_view(network, tables);
  return tables.take_bytes();
}

/// The only table, as the program stores it.
template <class Table>
Table table_of(const Network& network) {
  const std::string bytes = bytes_of(network);
  Table table{};
  EXPECT_EQ(bytes.size(), sizeof table);
  std::memcpy(&table, bytes.data(), std::min(bytes.size(), sizeof table));
  return table;
}

std::string header_of(const Network& network, PolicyTables& tables) {
  return policy_header(network, tables, "robot", "graphs::robot");
}

/// Row `out` and column `in` of what counted() gives.
template <class Dense>
void expect_counted(const Dense& dense, std::size_t inputs, std::size_t outputs, float first) {
  for (std::size_t out = 0; out < outputs; ++out) {
    for (std::size_t in = 0; in < inputs; ++in)
      EXPECT_EQ(dense.w[Dense::index(out, in)], first + static_cast<float>(out * inputs + in));
  }
}

TEST(StoredTables, DenseLayersAreInPanels) {
  const auto table = table_of<DenseWeights<5, 11>>(
      network_of({5, 11, counted(55), counted(11, 100.0F), Activation::relu}));
  expect_counted(table, 5, 11, 1.0F);
  EXPECT_EQ(table.w[table.index(10, 0) + 1], 0.0F);  // no output 11
  for (std::size_t out = 0; out < 11; ++out)
    EXPECT_EQ(table.b[out], 100.0F + static_cast<float>(out));
  EXPECT_EQ(table.b[11], 0.0F);
}

TEST(StoredTables, EightBitsHaveScalesAndBiases) {
  const Network network =
      with_int8_weights(network_of({6, 5, counted(30, -15.0F), counted(5), Activation::tanh}));
  const Layer& layer = network.layers.front();
  const auto table = table_of<Int8Weights<6, 5>>(network);
  for (std::size_t out = 0; out < 5; ++out) {
    EXPECT_EQ(table.scale[out], layer.scales[out]);
    EXPECT_EQ(table.b[out], layer.bias[out]);
    for (std::size_t in = 0; in < 6; ++in)
      EXPECT_EQ(table.w[table.index(out, in)], layer.rounded[out * 6 + in]);
  }
}

TEST(StoredTables, GroupsOfAConvolutionFollowEachOther) {
  constexpr Kernel kKernel{
      .channels = 4, .width = 6, .columns = 3, .stride_right = 1, .out_width = 4};
  Convolution form;
  form.kernel = {.channels = 4, .width = 6, .columns = 3, .out_width = 4};
  form.groups = 2;
  form.channels = 6;
  const auto table = table_of<ConvolutionWeights<kKernel, 6, 2>>(
      network_of(layer_of(form, 24, 24, counted(6), counted(36))));
  expect_counted(table.group[0], 6, 3, 1.0F);
  expect_counted(table.group[1], 6, 3, 19.0F);
  EXPECT_EQ(table.group[1].b[2], 6.0F);
}

TEST(StoredTables, MemoriesHaveTwoMatrices) {
  const Recurrence cell{false, counted(12, 50.0F), counted(6, 70.0F)};
  const Network network = network_of(layer_of(cell, 3, 2, counted(6), counted(18)));
  const auto table = table_of<GruWeights<3, 2>>(network);
  expect_counted(table.input, 3, 6, 1.0F);
  expect_counted(table.hidden, 2, 6, 50.0F);
  EXPECT_EQ(table.hidden.b[5], 75.0F);
  using Rounded = GruWeights<3, 2, Int8Weights>;
  const Network int8 = with_int8_weights(network);
  EXPECT_EQ(table_of<Rounded>(int8).hidden.scale[5],
            int8.layers.front().recurrence()->hidden_scales[5]);
}

TEST(StoredTables, ConstantsAndIndicesAreNumbers) {
  const std::string constants =
      bytes_of(network_of(layer_of(Elementwise{Elementwise::Operation::add}, 3, 3, counted(3))));
  float number = 0.0F;
  ASSERT_EQ(constants.size(), 3 * sizeof number);
  std::memcpy(&number, &constants[2 * sizeof number], sizeof number);
  EXPECT_EQ(number, 3.0F);
  const auto bytes_of_indices = [](std::uint32_t inputs) {
    return bytes_of(network_of(layer_of(Reorder{{2, 1, 258}}, inputs, 3)));
  };
  EXPECT_EQ(bytes_of_indices(300), std::string("\2\0\1\0\2\1", 6));
  EXPECT_EQ(bytes_of_indices(70000), std::string("\2\0\0\0\1\0\0\0\2\1\0\0", 12));
}

TEST(StoredTables, TheHeaderNamesItsFileAndItsContents) {
  Network network = network_of({3, 4, counted(12), counted(4), Activation::relu});
  network.layers.push_back({4, 1, counted(4), counted(1), Activation::tanh});
  PolicyTables tables(PolicyTables::Kind::stored, "graphs::robot::policy");
  const std::string text = header_of(network, tables);
  EXPECT_EQ(tables.bytes().size(), 160);
  EXPECT_THAT(text, HasSubstr("#if !__has_include(\"policy.hpp.weights\")"));
  EXPECT_THAT(text, HasSubstr("EAGERX_STORED_TABLE(\"_ZN6graphs5robot6policy7kLayer2E\", "
                              "EAGERX_TABLES, \"96\", \"64\");\n"
                              "[[gnu::visibility(\"hidden\")]] extern const "
                              "eagerx::DenseWeights<4, 1> kLayer2;\n"
                              "static_assert(sizeof(kLayer2) == 64);\n"));
  EXPECT_THAT(text, Not(HasSubstr("inline constexpr eagerx::DenseWeights")));
  // Another number is another header: builds compare it, and not the file.
  network.layers[0].weights[5] += 1.0F;
  PolicyTables others(PolicyTables::Kind::stored, "graphs::robot::policy");
  EXPECT_NE(header_of(network, others), text);
}

TEST(StoredTables, AHeaderDoesNotGrowWithItsTables) {
  const auto size_of_header = [](std::uint32_t outputs) {
    PolicyTables tables(PolicyTables::Kind::stored, "graphs::robot::policy");
    const std::string text = header_of(
        network_of({10, outputs, counted(10 * outputs), counted(outputs), Activation::relu}),
        tables);
    EXPECT_EQ(tables.bytes().size(), 44 * outputs);
    return text.size();
  };
  EXPECT_LE(size_of_header(8000), size_of_header(1000) + 16);  // digits of sizes
}

TEST(StoredTables, BlocksGiveTheSameText) {
  Network network = network_of({3, 4, counted(12), counted(4), Activation::relu});
  network.layers.push_back(
      layer_of(Recurrence{true, counted(16), counted(8)}, 4, 2, counted(8), counted(32)));
  network.layers.push_back(layer_of(Elementwise{Elementwise::Operation::add}, 2, 2, counted(2)));
  PolicyTables text(PolicyTables::Kind::text);
  PolicyTables blocks(PolicyTables::Kind::blocks);
  const std::string marked = header_of(network, blocks);
  EXPECT_LT(marked.size(), header_of(network, text).size());
  EXPECT_EQ(blocks.put_blocks(marked), header_of(network, text));
}

}  // namespace
}  // namespace eagerx::gen
