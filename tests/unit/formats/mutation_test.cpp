// Damaged files at random: each is either read or refused with one diagnostic, and nothing else
// happens (the debug preset runs this under the address and undefined-behaviour sanitizers).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/problem.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace eagerx::gen {
namespace {

std::string file_bytes(const char* name) {
  std::ifstream file(std::string(EAGERX_SOURCE_DIR "/tests/data/policy/") + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A few bytes changed, removed, repeated or cut off; half of them near the names and sizes at the
/// end of the file or its start, where they hurt most.
std::string damaged(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const auto position = [&] {
    const std::size_t edge = std::min<std::size_t>(bytes.size(), 2500);
    const std::size_t place = below(4);
    if (place == 0) return below(edge);
    return place == 1 ? bytes.size() - 1 - below(edge) : below(bytes.size());
  };
  const std::size_t changes = 1 + below(6);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = position();
    switch (below(6)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes.erase(at, 1 + below(16));
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, 1 + below(64)));
        break;
      case 3:
        bytes[at] = static_cast<char>(0xff);
        break;
      default:
        bytes[at] = static_cast<char>(random());
        break;
    }
  }
  return bytes;
}

void check(const std::string& bytes, const ReadContext& context = {}) {
  Diagnostics diagnostics;
  const auto network = read_policy_bytes(bytes, "damaged.onnx", {}, diagnostics, context);
  ASSERT_EQ(diagnostics.all().size(), network ? 0U : 1U);
  if (!network) {
    const std::string code = diagnostics.all().front().code;
    EXPECT_TRUE(code.starts_with("E06") || code.starts_with("E075")) << code;
    return;
  }
  ASSERT_FALSE(network->layers.empty());
  std::uint32_t inputs = network->inputs();
  std::size_t work = 0;
  for (const Layer& layer : network->layers) {
    if (network->is_chain()) {
      EXPECT_EQ(layer.inputs, inputs);
    }
    work += cost_of(layer).multiply_adds + layer.outputs;
    if (layer.is_dense()) {
      EXPECT_EQ(layer.weights.size(), std::size_t{layer.inputs} * layer.outputs);
      EXPECT_EQ(layer.bias.size(), layer.outputs);
    }
    for (const float weight : layer.weights) ASSERT_TRUE(std::isfinite(weight));
    inputs = layer.outputs;
  }
  // A network that was read can be evaluated: layers read within their inputs.
  constexpr std::size_t kMostWork = 100'000;
  if (work > kMostWork) return;
  Memory<float> memory;
  for (int i = 0; i < 2; ++i) {
    const std::vector<float> observation(network->inputs(), 0.5F);
    EXPECT_EQ(evaluate(*network, observation, &memory).size(), network->outputs());
  }
}

TEST(Mutation, ThousandDamagedSacFiles) {
  const std::string good = file_bytes("sac_64.onnx");
  ASSERT_GT(good.size(), 20000U);
  std::mt19937 random(1);  // the same sequence with every library
  for (int i = 0; i < 1000; ++i) check(damaged(good, random));
}

TEST(Mutation, ThousandDamagedPpoFiles) {
  const std::string good = file_bytes("ppo_64.onnx");
  ASSERT_GT(good.size(), 40000U);
  std::mt19937 random(2);
  for (int i = 0; i < 1000; ++i) check(damaged(good, random));
}

TEST(Mutation, DamagedFilesOfOtherFormats) {
  std::mt19937 random(3);
  for (const char* name : {"sac_64.zip", "ppo_64.safetensors", "ppo_64.npz"}) {
    const std::string good = file_bytes(name);
    ASSERT_GT(good.size(), 10000U);
    for (int i = 0; i < 500; ++i) check(damaged(good, random));
  }
}

TEST(Mutation, DamagedFilesOfOtherArchitectures) {
  std::mt19937 random(4);
  for (const char* name : {"gru.onnx", "lstm.onnx", "frames.onnx", "image.onnx", "scaled.onnx",
                           "recurrent_ppo.zip", "gru_state_dict.npz"}) {
    const std::string good = file_bytes((std::string("architectures/") + name).c_str());
    ASSERT_GT(good.size(), 1000U);
    ReadContext context;
    if (good.starts_with("PK")) context.output_activation = Activation::identity;
    if (std::string(name).ends_with(".zip")) context = {};
    for (int i = 0; i < 700; ++i) check(damaged(good, random), context);
  }
}

/// One entry damaged, at any depth, under the right checksum.
std::string damaged_archive(const std::string& bytes, std::mt19937& random) {
  PolicyProblem problem;
  const auto archive = Archive::open(bytes, problem);
  if (!archive) return damaged(bytes, random);
  const std::vector<std::string> names = archive->names();
  const std::size_t which = random() % names.size();
  std::vector<test::ZipEntry> entries;
  for (const std::string& name : names) {
    std::string buffer;
    const auto content = archive->read(name, buffer, problem);
    entries.push_back({name, std::string(content.value_or(""))});
    if (entries.size() - 1 != which) continue;
    entries.back().content = damaged_archive(std::string(entries.back().content), random);
  }
  return test::zip(entries);
}

TEST(Mutation, DamagedEntriesOfArchives) {
  std::mt19937 random(5);
  for (const char* name :
       {"ppo_cnn.zip", "crossq.zip", "qrdqn.zip", "ars_linear.zip", "rsl_rl.pt", "rl_games.pth",
        "skrl.pt", "cleanrl_td3.pth", "rsl_rl_legacy.pt", "td3_legacy.zip", "ppo_dict_obs.zip",
        "ppo_multi_discrete_obs.zip", "safe_control_gym.pt", "sample_factory.pth"}) {
    const std::string good = file_bytes((std::string("libraries/") + name).c_str());
    ASSERT_GT(good.size(), 1000U);
    ReadContext context;
    if (!std::string(name).ends_with("zip")) context.activation = Activation::elu;
    for (int i = 0; i < 400; ++i) check(damaged_archive(good, random), context);
  }
}

TEST(Mutation, EveryTruncationOfTheFirstAndLastBytes) {
  const std::string good = file_bytes("sac_64.onnx");
  for (std::size_t length = 0; length < 600; ++length) check(good.substr(0, length));
  for (std::size_t cut = 1; cut < 600; ++cut) check(good.substr(0, good.size() - cut));
}

}  // namespace
}  // namespace eagerx::gen
