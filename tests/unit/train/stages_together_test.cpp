// Stages of a task together with what else a training can have: each has the bits of one training,
// whatever its threads and ranks, and continues in a later stage.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "targets/environments/train/seeds.hpp"
#include "targets/environments/train/sweep.hpp"
#include "targets/environments/train/sweep_results.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"
#include "tests/unit/train/thread_ranks.hpp"

namespace eagerx::train {
namespace {

struct Combination {
  const char* name;
  std::uint64_t iterations;  // enough to pass a stage
  const char* algorithm = "ppo";
  bool has_critic = false;
  Memory memory = Memory::none;
  bool is_hard = false;
};

std::ostream& operator<<(std::ostream& out, const Combination& kind) {
  return out << kind.name;
}

class StagesTogether : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  static const Library& library(const Combination& kind) {
    static const Library plain(EAGERX_TEST_STAGES), critic(EAGERX_TEST_STAGED_CRITIC);
    return kind.has_critic ? critic : plain;
  }

  Options options(const Combination& kind, const std::string& name) const {
    Options result;
    Settings& settings = result.settings;
    settings.algorithm = kind.algorithm;
    settings.n_envs = 64;
    settings.n_steps = settings.max_n_steps = 32;
    settings.net_arch = {16, 16};
    settings.rnn = kind.memory;
    settings.rnn_hidden_size = 8;
    settings.n_minibatches = 4;
    settings.eval_interval = 2;
    settings.n_eval_episodes = 10;
    settings.failure_replay_fraction = 0.2;
    settings.until_return = 1.0;  // the reward is negative: it uses all steps
    result.output = path(name + ".safetensors");
    result.csv = path(name + ".csv");
    result.steps = steps(kind, kind.iterations);
    if (kind.is_hard) result.failure_replay = failure_replay();
    result.threads = 1;
    result.is_quiet = true;
    return result;
  }

  static std::uint64_t steps(const Combination& kind, std::uint64_t iterations) {
    return iterations * (kind.algorithm == std::string("ppo") ? 64 * 32 : 8 * 64);
  }

  /// A table of a campaign with two runs that have failed.
  std::string failure_replay() const {
    write_file(path("runs.csv"),
               "run,return,steps,success,terminated,truncated,state:pendulum.model_state[0],"
               "state:pendulum.model_state[1]\n1,-9,150,0,0,1,3,7.5\n2,-9,150,0,0,1,-2,-8.5\n");
    return path("runs.csv");
  }

  static std::string left_by(const Options& options) {
    return read_file(options.csv) + read_file(options.output);
  }

 private:
  TestFolder folder_;
};

class TrainStagesTogether : public StagesTogether,
                            public testing::WithParamInterface<Combination> {};
class TrainStagesInRanks : public TrainStagesTogether {};

/// How many iterations were made in the first stage; 0 if it was not passed.
std::uint64_t first_of(const std::vector<CurvePoint>& curve) {
  const auto later =
      std::ranges::find_if(curve, [](const CurvePoint& point) { return point.stage > 1.0; });
  return later == curve.end() ? 0 : static_cast<std::uint64_t>(later - curve.begin());
}

TEST_P(TrainStagesTogether, HaveTheBitsOfOneTraining) {
  const Options whole = options(GetParam(), "whole");
  Training training(whole, library(GetParam()));
  training.run(never);
  const std::string expected = left_by(whole);
  const std::uint64_t first = first_of(training.curve());
  ASSERT_GT(first, 0U) << "no stage was passed";
  ASSERT_LT(first + 2, training.curve().size());

  // Into the second stage and on from there, with more threads.
  Options begun = options(GetParam(), "begun");
  begun.steps = steps(GetParam(), first + 2);
  begun.checkpoint = path("checkpoint");
  Training(begun, library(GetParam())).run(never);
  Options rest = options(GetParam(), "rest");
  rest.resume = begun.checkpoint;
  rest.threads = 2;
  Training(rest, library(GetParam())).run(never);
  EXPECT_TRUE(left_by(rest) == expected);
}

TEST_P(TrainStagesInRanks, HaveTheBitsOfOneProcess) {
  const Options whole = options(GetParam(), "whole");
  Training(whole, library(GetParam())).run(never);
  const std::string expected = left_by(whole);
  const Options shared = options(GetParam(), "shared");
  in_ranks(2, [&](Ranks& ranks) {
    Options own = shared;
    if (!ranks.is_first()) own.csv.clear();  // as take_job() does
    Training(own, library(GetParam()), {}, ranks).run(never);
  });
  EXPECT_TRUE(left_by(shared) == expected);
}

const auto kName = [](const auto& kind) { return std::string(kind.param.name); };
constexpr Combination kPlain{.name = "plain", .iterations = 34};
constexpr Combination kCritic{.name = "critic", .iterations = 16, .has_critic = true};
constexpr Combination kHard{.name = "hard", .iterations = 60, .is_hard = true};
constexpr Combination kAll{.name = "memory_critic_hard",
                           .iterations = 80,
                           .has_critic = true,
                           .memory = Memory::gru,
                           .is_hard = true};
constexpr Combination kSac{.name = "sac", .iterations = 15, .algorithm = "sac"};
constexpr Combination kSacAll{.name = "sac_critic_hard",
                              .iterations = 15,
                              .algorithm = "sac",
                              .has_critic = true,
                              .is_hard = true};

INSTANTIATE_TEST_SUITE_P(Kinds, TrainStagesTogether,
                         testing::Values(kPlain, kCritic, kHard, kAll, kSac, kSacAll), kName);
INSTANTIATE_TEST_SUITE_P(Kinds, TrainStagesInRanks, testing::Values(kPlain, kCritic, kHard, kAll),
                         kName);

TEST_F(StagesTogether, SeveralSeedsGoOnInALaterStage) {
  const auto of_two = [&](const std::string& name) {
    Options result = options(kCritic, name);
    result.seeds = result.threads = 2;
    return result;
  };
  const auto policies = [&](const Options& all) {
    return read_file(path_of_seed(all.output, 1)) + read_file(path_of_seed(all.output, 2));
  };
  const Options whole = of_two("whole");
  train_seeds(whole, library(kCritic), never);
  for (const std::uint64_t seed : {1U, 2U}) {
    Options alone = options(kCritic, "alone");
    alone.settings.seed = seed;
    Training training(alone, library(kCritic));
    training.run(never);
    EXPECT_GT(first_of(training.curve()), 0U) << "no stage was passed";
    EXPECT_TRUE(read_file(alone.output) == read_file(path_of_seed(whole.output, seed)));
  }
  Options begun = of_two("begun");
  begun.steps = steps(kCritic, kCritic.iterations - 1);
  begun.checkpoint = path("checkpoint");
  train_seeds(begun, library(kCritic), never);
  Options rest = of_two("rest");
  rest.resume = begun.checkpoint;
  train_seeds(rest, library(kCritic), never);
  EXPECT_TRUE(policies(rest) == policies(whole));
  EXPECT_TRUE(read_file(rest.csv) == read_file(whole.csv));
}

TEST_F(StagesTogether, EachOfASweepIsThatOfItsSettings) {
  Options all = options(kCritic, "all");
  all.library = EAGERX_TEST_STAGED_CRITIC;
  all.results = path("sweep.csv");
  for (const char* clip : {"clip_range=0.1", "clip_range=0.3"}) {
    all.cases.push_back({clip, all.settings});
    all.cases.back().settings.clip_range = clip == std::string("clip_range=0.1") ? 0.1F : 0.3F;
  }
  EXPECT_EQ(train_sweep(all, library(kCritic), never), kDone);
  for (const Case& one : all.cases) {
    Options alone = options(kCritic, "alone");
    alone.settings = one.settings;
    Training training(alone, library(kCritic));
    training.run(never);
    EXPECT_NE(read_file(all.results)
                  .find(fmt::format("\"{}\",1,0,{},{},{},{},", one.words, alone.steps,
                                    training.evaluation().successes, training.evaluation().episodes,
                                    training.evaluation().mean_return)),
              std::string::npos)
        << one.words;
  }
}

}  // namespace
}  // namespace eagerx::train
