// Episodes that begin where a campaign's runs have failed.
#include "targets/environments/train/failure_replay.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRunsHead =
    "run,return,steps,success,terminated,truncated,state:pendulum.model_state[0],"
    "state:pendulum.model_state[1]\n";

/// Two runs of four have failed.
std::string table() {
  return std::string(kRunsHead) +
         "0,-1,150,1,0,1,0.5,0.25\n1,-9,150,0,0,1,3,7.5\n2,-9,150,0,0,1,-2,-8.5\n3,-1,9,1,0,1,,\n";
}

std::string said(const std::string& text) {
  try {
    const FailureReplay starts(text, "runs.csv", pendulum().description());
    return std::to_string(starts.size()) + " starts";
  } catch (const Problem& problem) {
    return problem.what();
  }
}

TEST(FailureReplay, AreTheRunsThatFailed) {
  const FailureReplay starts(table(), "runs.csv", pendulum().description());
  ASSERT_EQ(starts.size(), 2U);
  ASSERT_EQ(starts.width(), 2U);
  EXPECT_EQ(starts.at(0)[0], 3.0F);
  EXPECT_EQ(starts.at(1)[1], -8.5F);
}

TEST(FailureReplay, UnsetStatesAreSampled) {
  const FailureReplay starts(std::string(kRunsHead) + "1,-9,150,0,0,1,,7.5\n", "runs.csv",
                             pendulum().description());
  EXPECT_TRUE(std::isnan(starts.at(0)[0]));
}

TEST(FailureReplay, OtherFilesAreRefused) {
  EXPECT_EQ(said(table()), "2 starts");
  EXPECT_EQ(said(""), "`runs.csv` is not a table of a campaign, or cut off");
  EXPECT_EQ(said("steps,return\n"), "`runs.csv` is not a table of a campaign");
  EXPECT_EQ(said(table().substr(0, table().size() - 3)),
            "`runs.csv` is not a table of a campaign, or cut off");
  EXPECT_EQ(said(std::string(kRunsHead) + "0,-1,150,1,0,1,0.5,0.25\n"),
            "`runs.csv` has no run that failed");
  EXPECT_EQ(said(std::string(kRunsHead) + "1,-9,150,0,0,1,3\n"),
            "`runs.csv` is damaged: line 2 is not a run");
  EXPECT_EQ(said(std::string(kRunsHead) + "1,-9,150,2,0,1,3,4\n"),
            "`runs.csv` is damaged: line 2 is not a run");
  for (const char* number : {"x", "nan", "inf", "1e99", "3 "})
    EXPECT_EQ(said(std::string(kRunsHead) + "1,-9,150,0,0,1,3," + number + "\n"),
              std::string("`runs.csv` is damaged: line 2: `") + number + "` is not a number");
  const std::string first = "run,return,steps,success,terminated,truncated";
  EXPECT_EQ(said(first + ",state:arm.angle\n"),
            "`runs.csv` is of a graph with other states: `state:pendulum.model_state[0]` is not "
            "where it should be");
  std::string more = kRunsHead;
  more.pop_back();
  EXPECT_EQ(said(more + ",state:mass\n"), "`runs.csv` is of a graph with more states");
  EXPECT_EQ(said(more + ",fault:voltage=nan\n"),
            "`runs.csv` is of a campaign with faults, which trainings do not have");
}

/// The angles that the episodes of eight environments begin with, [episodes][8].
std::vector<std::vector<float>> angles(const Settings& settings, int episodes) {
  constexpr std::uint32_t kCount = 8, kWidth = 3;
  Environments environments(pendulum().functions(), kCount, 0, 1, 0, EAGERX_SAME_STEP);
  ReplayedEnvironments hard(settings, pendulum(), 0, kCount);
  Rows rows(pendulum().description(), kCount);
  const std::vector<float> action(kCount);
  std::vector<std::vector<float>> result;
  const auto note = [&] {
    std::vector<float> all;
    for (std::size_t e = 0; e < kCount; ++e)
      all.push_back(std::atan2(rows.observation[e * kWidth + 1], rows.observation[e * kWidth]));
    result.push_back(all);
  };
  hard.reset(environments, 5, rows.observation.data());
  note();
  while (result.size() < static_cast<std::size_t>(episodes)) {
    EXPECT_TRUE(environments.step(action.data(), rows.pointers()));
    for (std::size_t e = 0; e < kCount; ++e) {
      if (rows.ended(e)) hard.note(e);
    }
    hard.set(environments);
    if (rows.ended(0)) note();
  }
  return result;
}

TEST(FailureReplay, AShareOfTheEnvironmentsBeginsThere) {
  Settings settings;
  settings.failure_replay_fraction = 0.25;
  const auto sampled = angles(settings, 6);
  settings.failure_replay =
      std::make_shared<const FailureReplay>(table(), "runs.csv", pendulum().description());
  const auto hard = angles(settings, 6);
  std::set<float> of_hard;
  for (std::size_t episode = 0; episode < hard.size(); ++episode) {
    for (std::size_t e = 0; e < 8; ++e) {
      if (e == 3 || e == 7) {
        of_hard.insert(std::round(hard[episode][e]));
      } else {
        EXPECT_EQ(hard[episode][e], sampled[episode][e]) << episode << ", environment " << e;
      }
    }
  }
  EXPECT_EQ(of_hard, (std::set<float>{-2.0F, 3.0F}));
}

class TrainHardStarts : public testing::TestWithParam<const char*> {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  Options options(std::uint64_t iterations) const {
    Options result;
    result.settings = even_settings();
    result.settings.algorithm = GetParam();
    result.settings.net_arch = {8, 8};
    result.settings.sac.learning_starts = 100;
    result.settings.n_eval_episodes = 10;
    result.output = path("policy.safetensors");
    result.failure_replay = path("runs.csv");
    const bool is_sac = result.settings.algorithm == "sac";
    result.steps = iterations * (is_sac ? 8U * 64U : kIteration);
    result.threads = 2;
    result.is_quiet = true;
    return result;
  }
  std::string trained(const Options& options) const {
    Training(options, pendulum()).run(never);
    return read_file(options.output);
  }

 private:
  TestFolder folder_;
};

TEST_P(TrainHardStarts, GoOnFromACheckpointAsOneTraining) {
  write_file(path("runs.csv"), table());
  Options whole = options(5);
  const std::string policy = trained(whole);
  Options first = options(3);
  first.checkpoint = path("checkpoint");
  trained(first);
  whole.resume = first.checkpoint;
  EXPECT_EQ(trained(whole), policy);
  whole.resume.clear();
  whole.failure_replay.clear();
  EXPECT_NE(trained(whole), policy);
}

TEST_P(TrainHardStarts, OfOtherRunsBelongToAnotherTraining) {
  write_file(path("runs.csv"), table());
  Options one = options(1);
  one.checkpoint = path("checkpoint");
  trained(one);
  write_file(path("runs.csv"), table() + "4,-9,150,0,0,1,1,1\n");
  one.resume = one.checkpoint;
  EXPECT_THROW(Training(one, pendulum()), Problem);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, TrainHardStarts, testing::Values("ppo", "sac"));

}  // namespace
}  // namespace eagerx::train
