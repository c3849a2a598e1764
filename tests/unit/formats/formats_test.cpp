// The same policy in every format that it was saved in: the same network, and golden rows.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/formats/statistics.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/problem.hpp"

namespace eagerx::gen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kSavedPolicies = EAGERX_SOURCE_DIR "/tests/data/policy/";

Network read_saved(const std::string& name, const std::string& statistics = {}) {
  PolicyRequest request;
  request.path = kSavedPolicies + name;
  request.name = name;
  request.normalize_path = kSavedPolicies + statistics;
  request.normalize_name = statistics;
  if (statistics.empty()) request.normalize_path.clear();
  Diagnostics diagnostics;
  auto network = read_policy(request, diagnostics);
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << name << ": " << problem.message;
  return network ? *network : Network{{}, {}, {Layer{1, 1, {0}, {0}}}, {}};
}

void expect_same(const Network& a, const Network& b) {
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_EQ(a.layers[i].weights, b.layers[i].weights);
    EXPECT_EQ(a.layers[i].bias, b.layers[i].bias);
    EXPECT_EQ(a.layers[i].activation, b.layers[i].activation);
    EXPECT_FALSE(b.layers[i].norm.has_value());
  }
}

GoldenResult golden(const Network& network, const std::string& name) {
  Diagnostics diagnostics;
  const auto rows = read_golden(kSavedPolicies + name, name, {}, diagnostics);
  const auto result =
      rows ? compare(network, *rows, name, {}, diagnostics) : std::optional<GoldenResult>();
  for (const auto& problem : diagnostics.all()) ADD_FAILURE() << problem.message;
  return result.value_or(GoldenResult{});
}

class Formats : public testing::TestWithParam<const char*> {};

TEST_P(Formats, AreTheSameNetwork) {
  const std::string name = GetParam();
  const Network onnx = read_saved(name + ".onnx");
  for (const char* ending : {".zip", ".safetensors", ".npz"}) {
    SCOPED_TRACE(name + ending);
    const Network network = read_saved(name + ending);
    expect_same(onnx, network);
    const GoldenResult result = golden(network, name + "_sb3.csv");
    EXPECT_EQ(result.rows, 200U);
    EXPECT_LE(result.outputs.ours, 2.0 * result.outputs.theirs);
    EXPECT_GT(result.outputs.theirs, 1e-7);
  }
}
INSTANTIATE_TEST_SUITE_P(Policies, Formats, testing::Values("sac_64", "ppo_64"));

TEST(Sb3Zip, SaysWhatItWasTrainedWith) {
  const Network sac = read_saved("sac_64.zip");
  EXPECT_EQ(sac.format, "Stable-Baselines3 2.3.2, Stable-Baselines3's SAC");
  EXPECT_EQ(sac.contract.algorithm, "SAC");
  EXPECT_EQ(sac.action_kind(), ActionKind::squashed);
  EXPECT_THAT(sac.contract.action_low, ElementsAre(-2.0));
  EXPECT_THAT(sac.contract.action_high, ElementsAre(2.0));
  EXPECT_EQ(read_saved("ppo_64.zip").action_kind(), ActionKind::raw);
}

TEST(Statistics, OfThePickleAreThoseOfTheOtherFiles) {
  const Network pickle = read_saved("ppo_64.zip", "ppo_64_vecnormalize.pkl");
  ASSERT_TRUE(pickle.normalization.has_value());
  EXPECT_EQ(pickle.normalization->clip, 10.0);
  EXPECT_EQ(pickle.normalization->epsilon, 1e-8);
  for (const char* other : {"ppo_64.npz", "ppo_64.safetensors"}) {
    const Network network = read_saved(other);
    ASSERT_TRUE(network.normalization.has_value());
    EXPECT_EQ(network.normalization->mean, pickle.normalization->mean);
    EXPECT_EQ(network.normalization->variance, pickle.normalization->variance);
  }
  expect_same(pickle, read_saved("ppo_64.onnx", "ppo_64.npz"));
}

TEST(Statistics, OfAnotherTrainingAreRefused) {
  const std::string path = testing::TempDir() + "/other.json";
  PolicyRequest request;
  request.path = kSavedPolicies + "ppo_64.npz";
  request.name = "ppo_64.npz";
  request.normalize_path = request.normalize_name = path;
  const std::size_t count = read_saved("ppo_64.npz").inputs();
  std::ofstream(path) << fmt::format(R"({{"mean": [{0}], "var": [{0}]}})",
                                     fmt::join(std::vector<int>(count, 1), ","));
  Diagnostics diagnostics;
  EXPECT_FALSE(read_policy(request, diagnostics).has_value());
  ASSERT_EQ(diagnostics.error_count(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0631");
  EXPECT_THAT(diagnostics.all().front().message, HasSubstr("`ppo_64.npz` holds itself"));
}

TEST(Statistics, NormaliseWithNumPysBits) {
  const Network network = read_saved("ppo_64.zip", "ppo_64_vecnormalize.pkl");
  Diagnostics diagnostics;
  const auto rows = read_golden(kSavedPolicies + "ppo_64_sb3.csv", "rows", {}, diagnostics);
  ASSERT_TRUE(rows.has_value());
  for (std::size_t i = 0; i < rows->observations.size(); ++i) {
    std::vector<float> observation;
    std::vector<float> wanted;
    for (const double x : rows->observations[i]) observation.push_back(static_cast<float>(x));
    for (const double x : rows->normalized[i]) wanted.push_back(static_cast<float>(x));
    EXPECT_EQ(normalized(network, observation), wanted) << "row " << i;
  }
}

TEST(Statistics, JsonSaysEverythingOrIsRefused) {
  PolicyProblem problem;
  const auto nested =
      read_statistics(R"({"obs_rms":{"mean":[0,1],"var":[1,2],"clip_obs":3}})", problem);
  ASSERT_TRUE(nested.has_value()) << problem.message;
  EXPECT_EQ(nested->clip, 3.0);
  for (const char* text : {R"({"mean":[0],"var":[1],"clip":3})", R"({"mean":[0],"std":[1]})",
                           R"({"mean":[0],"var":[1],"epsilon":-0.5})"}) {
    EXPECT_FALSE(read_statistics(text, problem).has_value()) << text;
    EXPECT_EQ(problem.code, "E0627");
  }
}

TEST(Golden, RowsWithoutNumbersAreRefused) {
  const std::string path = testing::TempDir() + "/rows.csv";
  for (const char* text :
       {"obs0,network_out\n1,nan\n", "obs0,network_out\ninf,1\n", "cos,out\n1,2\n", "1,2\n3,4\n"}) {
    std::ofstream(path) << text;
    Diagnostics diagnostics;
    EXPECT_FALSE(read_golden(path, "rows.csv", {}, diagnostics).has_value()) << text;
    ASSERT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(diagnostics.all().front().code, "E0632");
  }
}

TEST(Golden, RowsThatWereNormalisedNeedStatistics) {
  Diagnostics diagnostics;
  const auto rows = read_golden(kSavedPolicies + "ppo_64_sb3.csv", "rows.csv", {}, diagnostics);
  ASSERT_TRUE(rows.has_value());
  const Network with = read_saved("ppo_64.zip", "ppo_64_vecnormalize.pkl");
  EXPECT_TRUE(check_normalized(with, *rows, "rows.csv", {}, diagnostics));
  EXPECT_FALSE(check_normalized(read_saved("ppo_64.zip"), *rows, "rows.csv", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0633");
}

TEST(Golden, RowsOfAnotherPolicyAreRefused) {
  Diagnostics diagnostics;
  const auto rows = read_golden(kSavedPolicies + "ppo_64_sb3.csv", "rows.csv", {}, diagnostics);
  ASSERT_TRUE(rows.has_value());
  EXPECT_FALSE(compare(read_saved("sac_64.zip"), *rows, "rows.csv", {}, diagnostics).has_value());
  ASSERT_EQ(diagnostics.all().size(), 1U);
  EXPECT_EQ(diagnostics.all().front().code, "E0633");
}

}  // namespace
}  // namespace eagerx::gen
