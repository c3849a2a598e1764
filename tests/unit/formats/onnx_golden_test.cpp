// Policies that were really trained: the network that is read computes what torch computed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <eagerx/policy.hpp>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/network.hpp"
#include "tests/support/plain_sum.hpp"

namespace eagerx::gen {
namespace {

using testing::Contains;

constexpr const char* kKnownPolicies = EAGERX_SOURCE_DIR "/tests/data/policy/";

/// The network by plain loops, in the order of eagerx/policy.hpp (tests/unit/runtime checks that
/// the layers have these bits).
std::vector<float> evaluate_plainly(const Network& network, std::vector<float> x) {
  for (const Layer& layer : network.layers) {
    std::vector<float> y(layer.bias);
    for (std::size_t out = 0; out < y.size(); ++out) {
      const float* weights = layer.weights.data() + out * layer.inputs;
      y[out] = eagerx::test::plain_sum(weights, x.data(), layer.inputs, y[out], out, y.size());
      if (layer.activation == Activation::relu) y[out] = y[out] < 0.0F ? 0.0F : y[out];
      if (layer.activation == Activation::tanh) y[out] = eagerx::tanh(y[out]);
    }
    x = std::move(y);
  }
  return x;
}

struct Errors {
  double ours = 0.0;
  double torch = 0.0;
  int rows = 0;
};

/// Largest errors against torch's float64 output, over the golden rows of `name`.
Errors largest_errors(const Network& network, const std::string& name) {
  std::ifstream file(kKnownPolicies + name + "_golden.csv");
  std::string line;
  std::getline(file, line);  // header
  Errors errors;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    const std::vector<float> observation = {static_cast<float>(row.at(0)),
                                            static_cast<float>(row.at(1)),
                                            static_cast<float>(row.at(2))};
    const double reference = row.at(4);
    const double ours = static_cast<double>(evaluate_plainly(network, observation).front());
    errors.ours = std::max(errors.ours, std::abs(ours - reference));
    errors.torch = std::max(errors.torch, std::abs(row.at(3) - reference));
    ++errors.rows;
  }
  return errors;
}

Network read_known(const std::string& name) {
  Diagnostics diagnostics;
  const auto network =
      read_policy(kKnownPolicies + name + ".onnx", name + ".onnx", {}, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.all().front().message;
  return network.value();
}

TEST(OnnxGolden, SacActorIsReadWithoutItsStandardDeviation) {
  const Network network = read_known("sac_64");
  ASSERT_EQ(network.layers.size(), 3U);
  EXPECT_EQ(network.inputs(), 3U);
  EXPECT_EQ(network.layers[0].outputs, 64U);
  EXPECT_EQ(network.layers[1].outputs, 64U);
  EXPECT_EQ(network.outputs(), 1U);
  EXPECT_EQ(network.layers[0].activation, Activation::relu);
  EXPECT_EQ(network.layers[1].activation, Activation::relu);
  EXPECT_EQ(network.layers[2].activation, Activation::tanh);
  EXPECT_EQ(network.file, "sac_64.onnx");
  EXPECT_EQ(network.format, "ONNX opset 17, exported by pytorch 1.13.0");
  EXPECT_THAT(network.ignored, Contains("tensor `a.log_std.weight` [1, 64]"));
  EXPECT_EQ(network.ignored.size(), 2U);
}

TEST(OnnxGolden, PpoActorIsReadWithoutItsCritic) {
  const Network network = read_known("ppo_64");
  ASSERT_EQ(network.layers.size(), 3U);
  EXPECT_EQ(network.layers[0].activation, Activation::tanh);
  EXPECT_EQ(network.layers[1].activation, Activation::tanh);
  EXPECT_EQ(network.layers[2].activation, Activation::identity);
  EXPECT_THAT(network.ignored, Contains("output `24`"));
  EXPECT_THAT(network.ignored, Contains("tensor `p.value_net.weight` [1, 64]"));
}

TEST(OnnxGolden, SacActorIsAsExactAsTorch) {
  const Errors errors = largest_errors(read_known("sac_64"), "sac_64");
  EXPECT_GE(errors.rows, 200);
  EXPECT_GT(errors.torch, 1e-7);
  EXPECT_LE(errors.ours, 2.0 * errors.torch);
}

TEST(OnnxGolden, PpoActorIsAsExactAsTorch) {
  const Errors errors = largest_errors(read_known("ppo_64"), "ppo_64");
  EXPECT_GE(errors.rows, 200);
  EXPECT_GT(errors.torch, 1e-7);
  EXPECT_LE(errors.ours, 2.0 * errors.torch);
}

}  // namespace
}  // namespace eagerx::gen
