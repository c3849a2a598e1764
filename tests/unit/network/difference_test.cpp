// How far two policies are apart, and observations with the answers of one.
#include "generator/policy/network/difference.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "generator/policy/network/int8.hpp"
#include "generator/policy/network/observations.hpp"

namespace eagerx::gen {
namespace {

/// y = 2 relu(x0 + x1)
Network two_layers() {
  Layer first;
  first.inputs = 2;
  first.outputs = 1;
  first.weights = {1.0F, 1.0F};
  first.bias = {0.0F};
  first.activation = Activation::relu;
  Layer second;
  second.inputs = second.outputs = 1;
  second.weights = {2.0F};
  second.bias = {0.0F};
  Network network{"two.onnx", "", {first, second}, {}};
  network.action = ActionKind::raw;
  return network;
}

Normalization statistics(std::vector<double> mean) {
  Normalization result;
  result.mean = std::move(mean);
  result.variance = {4.0, 1.0};
  return result;
}

std::optional<PolicyDifference> differ(const Network& a, const Network& b,
                                       std::optional<double> tolerance = {}) {
  Diagnostics diagnostics;
  if (!check_sizes(a, b, diagnostics)) return std::nullopt;
  return difference_of(a, b, sampled_observations(a, {100, 1}), tolerance, diagnostics);
}

TEST(Difference, OfAPolicyWithItselfIsNothing) {
  const auto result = differ(two_layers(), two_layers(), 0.0);
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->within());
  EXPECT_EQ(result->outputs[0].largest, 0.0);
  EXPECT_EQ(result->layers.size(), 2U);
}

TEST(Difference, IsFoundInItsLayer) {
  const Network a = two_layers();
  Network b = a;
  b.layers[1].bias[0] = 0.25F;
  const auto result = differ(a, b);
  ASSERT_TRUE(result.has_value());
  EXPECT_FALSE(result->within());
  EXPECT_NEAR(result->outputs[0].largest, 0.25, 1e-6);
  EXPECT_NEAR(result->outputs[0].mean, 0.25, 1e-6);
  EXPECT_EQ(result->layers[0].weights, 0.0);
  EXPECT_EQ(result->layers[0].largest, 0.0);
  EXPECT_EQ(result->layers[1].weights, 0.25);
  EXPECT_NEAR(result->second[0] - result->first[0], 0.25, 1e-6);
  EXPECT_TRUE(differ(a, b, 0.26)->within());
  EXPECT_FALSE(differ(a, b, 0.24)->within());
}

TEST(Difference, WeightsOfEightBitsCountAsWhatTheyAreTimesTheirScale) {
  const Network a = two_layers();
  Network b = a;
  b.layers[0].weights = {1.0F, 0.503F};
  const auto result = differ(b, with_int8_weights(b));
  ASSERT_TRUE(result.has_value());
  EXPECT_GT(result->layers[0].weights, 0.0);
  EXPECT_LE(result->layers[0].weights, 0.5 / 127.0 + 1e-9);
}

TEST(Difference, OfOtherLayersIsNotSaidLayerByLayer) {
  const Network a = two_layers();
  Network b = a;
  b.layers[0].activation = Activation::tanh;
  EXPECT_EQ(differ(a, b)->layers_differ, "layer 1 is 2 -> 1 relu in one, 2 -> 1 tanh in the other");
  b.layers.push_back(b.layers[1]);
  EXPECT_EQ(differ(a, b)->layers_differ, "one has 2 layers, the other 3");
  b.layers[0].inputs = 1;
  EXPECT_FALSE(differ(a, b).has_value());  // E0757
}

TEST(Difference, AnAnswerThatIsNotFiniteIsNone) {
  const Network a = two_layers();
  Network b = a;
  b.layers[1].weights[0] = std::numeric_limits<float>::max();
  b.layers[1].bias[0] = std::numeric_limits<float>::max();
  b.layers[0].bias[0] = 4.0F;
  Diagnostics diagnostics;
  EXPECT_FALSE(difference_of(a, b, sampled_observations(a, {100, 1}), {}, diagnostics).has_value());
  EXPECT_EQ(diagnostics.all().front().code, "E0759");
  GoldenRows rows = sampled_observations(b, {1, 1});
  rows.observations[0] = {1e38, 1e38};
  b.normalization = statistics({0.0, 0.0});
  b.normalization->clip = 1e308;
  b.layers[0].weights = {1.0F, 1.0F};
  EXPECT_TRUE(add_answers(b, rows, diagnostics)) << "float64 holds what float32 does not";
  b.layers[0].activation = Activation::identity;
  b.layers[0].weights[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(add_answers(b, rows, diagnostics));
  EXPECT_EQ(diagnostics.all().back().code, "E0759");
}

TEST(Observations, AreSampledWhereTheFileSaysThatTheyAre) {
  Network network = two_layers();
  const auto all_within = [&](double low, double high, std::size_t i) {
    for (const auto& row : sampled_observations(network, {200, 3}).observations) {
      if (row[i] < low || row[i] > high) return false;
    }
    return true;
  };
  EXPECT_TRUE(all_within(-1.0, 1.0, 0));
  network.contract.observation_low = {5.0, -1e30};
  network.contract.observation_high = {7.0, 1e30};
  EXPECT_TRUE(all_within(5.0, 7.0, 0));
  EXPECT_TRUE(all_within(-1.0, 1.0, 1));
  network.normalization = statistics({100.0, 0.0});
  EXPECT_TRUE(all_within(95.9, 104.1, 0));
  EXPECT_FALSE(all_within(98.0, 102.0, 0));
  EXPECT_NE(sampled_observations(network, {1, 1}).observations,
            sampled_observations(network, {1, 2}).observations);
}

TEST(Observations, WithAnswersAreGoldenRows) {
  Network network = two_layers();
  network.normalization = statistics({0.5, 0.0});
  GoldenRows rows = sampled_observations(network, {10, 1});
  Diagnostics diagnostics;
  ASSERT_TRUE(add_answers(network, rows, diagnostics));
  EXPECT_EQ(rows.outputs_double.size(), 10U);
  EXPECT_EQ(rows.normalized.size(), 10U);
  EXPECT_TRUE(compare(network, rows, "rows", {}, diagnostics).has_value());
  rows.outputs_double[3][0] += 0.1;
  EXPECT_FALSE(compare(network, rows, "rows", {}, diagnostics).has_value());
}

}  // namespace
}  // namespace eagerx::gen
