// Checkpoints whose check sum is right and whose contents are wrong: somebody has made them so.
#include "targets/environments/train/checkpoint.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "targets/environments/client/files.hpp"
#include "targets/environments/train/client.hpp"

namespace eagerx::train {
namespace {

class TrainCheckpoint : public testing::Test {
 protected:
  static Model model() {
    Description description;
    description.actions.push_back(
        {.name = "voltage", .dtype = "float32", .low = {-1.0}, .high = {1.0}});
    Settings settings;
    settings.net_arch = {3};
    return {settings, 2, Head(description)};
  }

  std::string bytes() const { return checkpoint_of("graph 0", "interface", learnt_, progressed_); }

  static std::string said(const std::string& bytes, const std::string& conditions = "graph 0") {
    Model model = TrainCheckpoint::model();
    Progressed progressed;
    try {
      restore(bytes, "it", conditions, model, progressed);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return "nothing";
  }

  Model learnt_ = model();
  Progressed progressed_;
};

/// With the value at `offset` behind the lines, and the check sum of that.
std::string changed(std::string bytes, std::size_t offset, char value) {
  std::size_t begin = 0;
  for (int line = 0; line < 4; ++line) begin = bytes.find('\n', begin) + 1;
  bytes[begin + offset] = value;
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : bytes.substr(begin))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  constexpr std::size_t kHashLine = 17;
  return bytes.replace(begin - kHashLine, kHashLine - 1, fmt::format("{:016x}", hash));
}

TEST_F(TrainCheckpoint, IsReadAgain) {
  progressed_.recent.resize(kRecent);
  progressed_.best.parameters = learnt_.actor_parameters;
  progressed_.succeeded = true;
  EXPECT_EQ(said(bytes()), "nothing");
}

TEST_F(TrainCheckpoint, AnotherGraphIsNamedWithoutItsHash) {
  EXPECT_EQ(
      said(checkpoint_of("graph 1; clip 0.1", "interface", learnt_, progressed_)),
      "`it` belongs to another training: another graph, or this one before a change, clip_range "
      "0.1 (here there is none)");
}

// Checkpoints of versions before 1.0.0 have other names of settings.
TEST_F(TrainCheckpoint, FormerNamesOfSettingsAreRead) {
  EXPECT_EQ(with_new_names("algorithm sac; layers 4,4; clip 0.1; tau 1; hard-starts 0a; future 7"),
            "algorithm sac; net_arch 4,4; clip_range 0.1; tau 1; failure-replay 0a; future 7");
  EXPECT_EQ(said(checkpoint_of("graph 0; clip 0.1", "interface", learnt_, progressed_),
                 "graph 0; clip_range 0.1"),
            "nothing");
}

TEST_F(TrainCheckpoint, ABestPolicyOfAnotherSizeIsRefused) {
  progressed_.best.parameters.resize(learnt_.actor_parameters.size() - 1);
  EXPECT_EQ(said(bytes()), "`it` is not complete");
}

TEST_F(TrainCheckpoint, MoreEpisodesThanAreKeptAreRefused) {
  progressed_.recent.resize(kRecent + 1);
  EXPECT_EQ(said(bytes()), "`it` is not complete");
}

TEST_F(TrainCheckpoint, ATruthValueThatIsNoneIsRefused) {
  constexpr std::size_t kSucceeded = sizeof(std::uint32_t);
  EXPECT_EQ(said(changed(bytes(), kSucceeded, 1)), "nothing");
  EXPECT_EQ(said(changed(bytes(), kSucceeded, 2)), "`it` is not complete");
}

/// Begins from a checkpoint of tests/data/stability, which every later version reads.
template <class SomeModel>
SomeModel expect_networks_in(const std::string& name, const Settings& settings) {
  Description description;
  for (const char* const channel : {"angle", "speed"})
    description.observations.push_back(
        {.name = channel, .dtype = "float32", .size = 2, .low = {}, .high = {}});
  description.actions.push_back(
      {.name = "voltage", .dtype = "float32", .size = 1, .low = {-2.0}, .high = {2.0}});
  constexpr std::size_t kObservations = 4;
  SomeModel model(settings, kObservations, Head(description));
  const std::vector<float> random = model.actor_parameters;
  begin_from(read_file(EAGERX_SOURCE_DIR "/tests/data/stability/1.0/" + name), "it",
             interface_of(settings, description), model);
  EXPECT_NE(model.actor_parameters, random);
  EXPECT_TRUE(
      std::ranges::all_of(model.actor_parameters, [](float x) { return std::isfinite(x); }));
  return model;
}

Settings of_corpus() {
  Settings settings;
  settings.net_arch = {4};
  return settings;
}

TEST(Stability, ReadsTheCheckpointOfAnEarlierVersion) {
  expect_networks_in<Model>("pendulum.checkpoint", of_corpus());
}

TEST(Stability, ReadsARecurrentCheckpointOfAnEarlierVersion) {
  Settings settings = of_corpus();
  settings.rnn = Memory::gru;
  settings.rnn_hidden_size = 4;
  expect_networks_in<Model>("memory.checkpoint", settings);
}

TEST(Stability, ReadsTheCheckpointOfSacOfAnEarlierVersion) {
  Settings settings = of_corpus();
  settings.algorithm = "sac";
  settings.sac.buffer_size = 1000;
  const auto model = expect_networks_in<sac::Model>("sac.checkpoint", settings);
  EXPECT_EQ(model.reward_scale, model.returns.scale(0)) << "what its critics have learned";
  EXPECT_NE(model.reward_scale, 1.0);
}

}  // namespace
}  // namespace eagerx::train
