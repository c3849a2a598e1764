// Which differences from known answers are rounding, and which are another function.
#include "generator/policy/network/golden.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generator/policy/network/evaluate.hpp"

namespace eagerx::gen {
namespace {

/// y = x0 + x1 in float32, from inputs whose sum is not exact.
Network sum_of_two() {
  Layer layer;
  layer.inputs = 2;
  layer.outputs = 1;
  layer.weights = {1.0F, 1.0F};
  layer.bias = {0.0F};
  Network network{"sum.onnx", "", {layer}, {}};
  network.action = ActionKind::raw;
  return network;
}

GoldenRows rows_of(const Network& network, double offset) {
  GoldenRows rows;
  for (const auto& row : sampled_rows(50, network.inputs())) {
    rows.observations.emplace_back(row.begin(), row.end());
    rows.outputs.push_back(evaluate_in_double(network, row));
    for (double& value : rows.outputs.back()) value += offset;
  }
  return rows;
}

std::optional<GoldenResult> judged(const Network& network, const GoldenRows& rows) {
  Diagnostics diagnostics;
  auto result = compare(network, rows, "rows.csv", {}, diagnostics);
  EXPECT_EQ(diagnostics.error_count(), result ? 0U : 1U);
  return result;
}

TEST(Golden, AnErrorCountsAgainstTheRangeOfTheOutput) {
  const Network network = sum_of_two();  // outputs from -2 to 2: 5e-5 of 4 is 2e-4
  EXPECT_TRUE(judged(network, rows_of(network, 1e-4)).has_value());
  EXPECT_FALSE(judged(network, rows_of(network, 3e-4)).has_value());
}

TEST(Golden, SmallOutputsAreJudgedBySmallErrors) {
  Network network = sum_of_two();
  network.layers[0].weights = {1e-2F, 1e-2F};  // 5e-5 of 0.04 is 2e-6
  EXPECT_TRUE(judged(network, rows_of(network, 1e-6)).has_value());
  EXPECT_FALSE(judged(network, rows_of(network, 1e-5)).has_value());
  GoldenRows printed = rows_of(network, 1e-5);
  printed.printed = 5e-5;  // four digits behind the point
  EXPECT_TRUE(judged(network, printed).has_value());
}

TEST(Golden, LargeOutputsAreJudgedByTheirValue) {
  Network network = sum_of_two();
  network.layers[0].bias = {1e4F};
  EXPECT_TRUE(judged(network, rows_of(network, 0.09)).has_value());
  EXPECT_FALSE(judged(network, rows_of(network, 0.2)).has_value());
}

TEST(Golden, WhatIsNearerToFloat64ThanTheFileNeverFails) {
  Network network = sum_of_two();
  network.layers[0].weights = {1e6F, -1e6F};  // float32 loses digits where they cancel
  GoldenRows rows;
  for (int i = 1; i <= 9; ++i) {
    const double x = static_cast<float>(0.1 * i);
    rows.observations.push_back({x, static_cast<double>(static_cast<float>(x + 1e-7))});
    std::vector<float> input(rows.observations.back().begin(), rows.observations.back().end());
    const auto exact = evaluate_in_double(network, input);
    const auto ours = evaluate(network, input);
    const double error = std::fabs(static_cast<double>(ours[0]) - exact[0]);
    rows.outputs.push_back({exact[0] + 1.5 * error});
  }
  const auto result = judged(network, rows);
  ASSERT_TRUE(result.has_value());
  EXPECT_LE(result->outputs.ours, result->outputs.theirs);
}

TEST(Golden, ActionsAreJudgedLikeOutputs) {
  Network network = sum_of_two();
  network.contract.action_low = {-10.0};
  network.contract.action_high = {10.0};
  GoldenRows rows = rows_of(network, 1e-4);
  rows.actions.swap(rows.outputs);
  const auto result = judged(network, rows);
  ASSERT_TRUE(result.has_value());
  EXPECT_FALSE(result->has_outputs);
  EXPECT_NEAR(result->actions->off, 1e-4, 1e-6);
  rows = rows_of(network, 1e-3);
  rows.actions.swap(rows.outputs);
  EXPECT_FALSE(judged(network, rows).has_value());
}

TEST(Golden, AnEquallyGoodChoiceIsRight) {
  Network network = sum_of_two();
  network.layers[0].outputs = 2;
  network.layers[0].weights = {1.0F, 0.0F, 0.0F, 1.0F};
  network.layers[0].bias = {0.0F, 0.0F};
  network.action = ActionKind::argmax;
  GoldenRows rows;
  rows.observations = {{1.0, 0.0}, {0.5, 0.5}};
  rows.actions = {{0.0}, {1.0}};
  EXPECT_TRUE(judged(network, rows).has_value()) << "the scores of the second row are equal";
  rows.actions = {{1.0}, {1.0}};
  EXPECT_FALSE(judged(network, rows).has_value());
  rows.actions = {{0.0}, {2.0}};
  EXPECT_FALSE(judged(network, rows).has_value()) << "there is no such action";
}

TEST(Golden, AnOutputThatIsNotANumberIsWrong) {
  Network network = sum_of_two();
  const GoldenRows rows = rows_of(network, 0.0);
  network.layers[0].weights = {3e38F, 3e38F};
  network.layers[0].bias = {-3e38F};
  EXPECT_FALSE(judged(network, rows).has_value());
}

}  // namespace
}  // namespace eagerx::gen
