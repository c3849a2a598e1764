// Trainings over settings, and the file of their results.
#include "targets/environments/train/sweep.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "targets/environments/client/intervals.hpp"
#include "targets/environments/train/sweep_results.hpp"
#include "targets/environments/train/sweep_table.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResultsHead =
    "training,settings,seed,succeeds,steps,successes,episodes,return,processor_s,problem\n";
constexpr const char* kResultsRow =
    "0123456789abcdef,\"clip_range=0.2\",1,1,8192,399,400,-12.5,0.75,\"\"\n";

class TrainSweep : public testing::Test {
 protected:
  void TearDown() override { unsetenv("EAGERX_TEST_BREAKS"); }
  std::string path(const std::string& name) const { return folder_.path(name); }

  Options options(const std::vector<std::string>& cases) const {
    std::vector<std::string> words = {"train",     EAGERX_TEST_PENDULUM,
                                      "--steps",   "24576",
                                      "--seeds",   "2",
                                      "--threads", "2",
                                      "--setting", "net_arch=8,8",
                                      "--output",  path("policy.safetensors"),
                                      "--csv",     path("table.csv"),
                                      "--quiet"};
    if (!cases.empty()) words.insert(words.end(), {"--results", path("sweep.csv")});
    for (const std::string& one : cases) words.insert(words.end(), {"--case", one});
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    return parse_options(static_cast<int>(pointers.size()), pointers.data());
  }
  std::string refused(const std::vector<std::string>& cases) const {
    try {
      options(cases);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return "nothing";
  }
  /// The message about a file of results.
  std::string said_of(const std::string& text) const {
    write_file(path("results.csv"), text);
    try {
      const SweepResults results(path("results.csv"));
      return std::to_string(results.size()) + " rows";
    } catch (const Problem& problem) {
      return std::string(problem.what()).substr(path("results.csv").size() + 3);
    }
  }

 private:
  TestFolder folder_;
};

TEST_F(TrainSweep, EachTrainingIsThatOfItsSettingsAndSeed) {
  const Options all = options({"clip_range=0.1", "clip_range=0.3"});
  check_files_of_sweep(all);
  EXPECT_EQ(train_sweep(all, pendulum(), never), kDone);
  const SweepResults results(path("sweep.csv"));
  ASSERT_EQ(results.size(), 4U);
  const std::string best = read_file(path("policy.safetensors"));
  bool is_one = false;
  for (const float clip : {0.1F, 0.3F}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      Options one = options({});
      one.settings.clip_range = clip;
      one.settings.seed = seed;
      one.output = path("one.safetensors");
      one.csv.clear();
      Training training(one, pendulum());
      training.run(never);
      is_one = is_one || read_file(one.output) == best;
      const std::string text = read_file(path("sweep.csv"));
      const std::string cell = fmt::format(
          "\"clip_range={}\",{},0,24576,{},{},{},", clip, seed, training.evaluation().successes,
          training.evaluation().episodes, training.evaluation().mean_return);
      EXPECT_NE(text.find(cell), std::string::npos) << cell << "\n" << text;
    }
  }
  EXPECT_TRUE(is_one);
  EXPECT_EQ(std::ranges::count(read_file(path("table.csv")), '\n'), 3);
}

TEST_F(TrainSweep, WhatIsThereIsNotMadeAgain) {
  EXPECT_EQ(train_sweep(options({"clip_range=0.1"}), pendulum(), never), kDone);
  const std::string first = read_file(path("sweep.csv"));
  // Processor times would differ.
  EXPECT_EQ(train_sweep(options({"clip_range=0.1"}), pendulum(), never), kDone);
  EXPECT_EQ(read_file(path("sweep.csv")), first);
  EXPECT_EQ(train_sweep(options({"clip_range=0.1", "clip_range=0.3"}), pendulum(), never), kDone);
  EXPECT_TRUE(read_file(path("sweep.csv")).starts_with(first));
  EXPECT_EQ(SweepResults(path("sweep.csv")).size(), 4U);
  Options longer = options({"clip_range=0.1"});
  longer.steps = 32768;
  EXPECT_EQ(train_sweep(longer, pendulum(), never), kDone);
  EXPECT_EQ(SweepResults(path("sweep.csv")).size(), 6U) << "other steps are another training";
}

TEST_F(TrainSweep, AnInterruptedOneGoesOn) {
  const Interrupt at_once = true;
  EXPECT_EQ(train_sweep(options({"clip_range=0.1"}), pendulum(), at_once), 130);
  EXPECT_FALSE(fs::exists(path("policy.safetensors")));
  EXPECT_EQ(train_sweep(options({"clip_range=0.1"}), pendulum(), never), kDone);
  EXPECT_EQ(SweepResults(path("sweep.csv")).size(), 2U);
}

TEST_F(TrainSweep, ATrainingThatBreaksIsARow) {
  setenv("EAGERX_TEST_BREAKS", "evaluation", 1);
  Options some = options({"eval_interval=1 stagger=false", "eval_interval=3 stagger=false"});
  EXPECT_EQ(train_sweep(some, pendulum(), never), kDone);
  const std::string text = read_file(path("sweep.csv"));
  EXPECT_NE(text.find("a reward is not finite note: the training had made"), std::string::npos);
  EXPECT_EQ(SweepResults(path("sweep.csv")).size(), 4U) << "it can be read again";
}

TEST_F(TrainSweep, ForeignResultsAreRefused) {
  const std::string head = kResultsHead, row = kResultsRow;
  EXPECT_EQ(said_of(head + row), "1 rows");
  EXPECT_EQ(said_of(head), "0 rows");
  EXPECT_EQ(said_of(""), "0 rows");
  EXPECT_EQ(said_of("precious data\n"), "has no results of a sweep");
  EXPECT_EQ(said_of(head + row + row.substr(0, 30)), "is damaged: line 3 is not a result");
  for (const char* bad :
       {"0123456789abcdeg,\"a=1\",1,1,8192,399,400,-12.5,0.75,\"\"",
        "0123456789abcdef,a=1,1,1,8192,399,400,-12.5,0.75,\"\"",
        "0123456789abcdef,\"a\"=\"1\",1,1,8192,399,400,-12.5,0.75,\"\"",
        "0123456789abcdef,\"a=1\",-1,1,8192,399,400,-12.5,0.75,\"\"",
        "0123456789abcdef,\"a=1\",1,2,8192,399,400,-12.5,0.75,\"\"",
        "0123456789abcdef,\"a=1\",1,1,99999999999999999999,399,400,-12.5,0.75,\"\"",
        "0123456789abcdef,\"a=1\",1,1,8192,401,400,-12.5,0.75,\"\"",
        "0123456789abcdef,\"a=1\",1,1,8192,399,400,nan,0.75,\"\"",
        "0123456789abcdef,\"a=1\",1,1,8192,399,400,-12.5,-1,\"\"",
        "0123456789abcdef,\"a=1\",1,1,8192,0,0,-12.5,1,\"\"",
        "0123456789abcdef,\"a=1\",1,1,8192,399,400,-12.5,0.75,\"\",", ""})
    EXPECT_EQ(said_of(head + bad + "\n"), "is damaged: line 2 is not a result") << bad;
}

// At 9028afbf, the one that wrote last had its own rows only.
TEST_F(TrainSweep, TwoSweepsWithOneFileLoseNoRow) {
  const std::string shared = path("results.csv");
  SweepResults first(shared), second(shared);
  const auto add = [](SweepResults& to, int number) {
    EXPECT_EQ(to.add({.training = fmt::format("{:016x}", number),
                      .settings = "clip_range=0.1",
                      .successes = 1,
                      .episodes = 1,
                      .problem = ""}),
              "");
  };
  for (int i = 0; i < 4; ++i) add(i % 2 == 0 ? first : second, i);
  EXPECT_EQ(SweepResults(shared).size(), 4U);
  constexpr int kEach = 25;
  const auto more = [&](int from) {
    SweepResults own(shared);
    for (int i = 0; i < kEach; ++i) add(own, from + i);
  };
  std::thread one([&] { more(100); }), other([&] { more(200); });
  one.join();
  other.join();
  EXPECT_EQ(SweepResults(shared).size(), 4U + 2 * kEach);
}

TEST_F(TrainSweep, AFileOfSomethingElseStays) {
  write_file(path("sweep.csv"), "precious data\n");
  EXPECT_THROW(check_files_of_sweep(options({"clip_range=0.1"})), Problem);
  EXPECT_EQ(read_file(path("sweep.csv")), "precious data\n");
}

TEST_F(TrainSweep, SettingsThatAreWrong) {
  EXPECT_EQ(refused({"clip_range=0.1", "clip_range=0.2"}), "nothing");
  EXPECT_EQ(refused({"clip_range=0.1", "n_epochs=2"}), "--case: all name the same settings");
  EXPECT_EQ(refused({"clip_range=0.1 n_epochs=2", "clip_range=0.1"}),
            "--case: all name the same settings");
  EXPECT_EQ(refused({"clap=0.1"}), "there is no setting `clap`");
  EXPECT_EQ(refused({"clip_range=100"}), "clip_range: `100` is not a number from 0.001 to 10");
  EXPECT_EQ(refused({"batch_size=128"}),
            "batch_size is a setting of sac, and the algorithm is ppo");
  EXPECT_EQ(refused({"n_envs=300"}),
            "n_envs: 300 is neither 8, 16, 32, 64 nor a multiple of 128 (n_envs=300)");
}

SweepRow row(std::uint64_t successes, double mean_return) {
  return {.training = "0123456789abcdef",
          .settings = "",
          .seed = 1,
          .succeeds = successes == 400,
          .steps = 8192,
          .successes = successes,
          .episodes = 400,
          .mean_return = mean_return,
          .processor_s = 1.5,
          .problem = ""};
}

TEST(TrainSweepTable, TheBestIsFirst) {
  const SweepRow good = row(400, -1.0), better = row(400, -0.5), bad = row(100, -9.0);
  SweepRow broken = row(0, 0.0);
  broken.episodes = 0;
  broken.problem = "a reward is not finite";
  const std::vector<SweepCase> cases = {{"clip_range=0.1 net_arch=8,8", {&bad, &good}},
                                        {"clip_range=0.2 net_arch=8,8", {&good, &better}},
                                        {"clip_range=0.3 net_arch=8,8", {&better, &broken}},
                                        {"clip_range=0.4 net_arch=8,8", {}}};
  EXPECT_EQ(
      sweep_text(cases, true),
      "clip_range            seeds            success in %        return  steps  processor\n"
      "       0.2           2 of 2  100.00 (99.5 to 100.0)  -0.75 +- 3.2  8,190      1.5 s\n"
      "       0.1           1 of 2    62.50 (59.1 to 65.8)      -5 +- 51  8,190      1.5 s\n"
      "       0.3  1 of 2, 1 broke  100.00 (99.0 to 100.0)          -0.5  8,190      1.5 s\n");
  const std::string csv = sweep_csv(cases);
  EXPECT_TRUE(csv.starts_with("clip_range,net_arch,seeds,good,good_low,")) << csv;
  EXPECT_NE(csv.find("\n0.2,\"8,8\",2,2,"), std::string::npos) << csv;
  EXPECT_EQ(sweep_text({}, true), "");
}

TEST(TrainSweepTable, IntervalsOfFewValues) {
  EXPECT_EQ(client::mean_of({}).mean, 0.0);
  EXPECT_EQ(client::mean_of({3.0}).half, 0.0);
  const client::Mean two = client::mean_of({1.0, 3.0});
  EXPECT_DOUBLE_EQ(two.mean, 2.0);
  EXPECT_NEAR(two.half, 12.71, 1e-9);  // Student's factor of one degree of freedom
  // scipy.stats.t.interval(0.95, 4, ...): 3 +- 1.963
  EXPECT_NEAR(client::mean_of({1.0, 2.0, 3.0, 4.0, 5.0}).half, 1.963, 3e-3);
  EXPECT_EQ(client::text_of({-66.471, 158.3}), "-66.47 +- 158");
  EXPECT_EQ(client::text_of({0.5, 0.1234}), "0.5 +- 0.12");
  EXPECT_EQ(client::text_of({1.0, 99.7}), "1 +- 100");
}

}  // namespace
}  // namespace eagerx::train
