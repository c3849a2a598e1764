#include "targets/environments/train/training.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <limits>
#include <runtime/host/base/handover.hpp>
#include <sstream>
#include <utility>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/seeds.hpp"
#include "tests/unit/train/training_common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

TEST_F(TrainTraining, AnyNumberOfThreadsLearnsTheSameBits) {
  Options one = options(12);
  const std::string policy = trained(one);
  for (const unsigned threads : {2U, 3U}) {
    one.threads = threads;
    EXPECT_EQ(trained(one), policy) << threads << " threads";
  }
  one.settings.seed = 2;
  EXPECT_NE(trained(one), policy);
}

TEST_F(TrainTraining, AnyInstructionSetLearnsTheSameBits) {
  Options one = options(6);
  one.kernels = "plain";
  const std::string policy = trained(one);
  for (const Kernels* kernels : kernels_here()) {
    one.kernels = kernels->name;
    EXPECT_EQ(trained(one), policy) << kernels->name;
  }
}

TEST_F(TrainTraining, FewEnvironmentsLearnTheSameBits) {
  for (const std::size_t environments : {8, 16, 64}) {
    Options one = options(2);
    one.settings.n_envs = environments;
    one.settings.n_minibatches = 100;  // there are fewer
    one.kernels = "plain";
    one.threads = 1;
    const std::string policy = trained(one);
    one.threads = 3;
    for (const Kernels* kernels : kernels_here()) {
      one.kernels = kernels->name;
      EXPECT_EQ(trained(one), policy) << environments << " environments, " << kernels->name;
    }
  }
}

// On d78331f1 a row has a return only if an episode has ended in its iteration: every fifth one, as
// all episodes have 150 steps and an iteration has 32.
TEST_F(TrainTraining, TheReturnIsThatOfTheLastEpisodesWheneverTheyEnded) {
  Options some = options(12);
  some.settings.stagger = false;
  some.csv = path("curve.csv");
  trained(some);
  const std::vector<double> returns = column_of(read_file(some.csv), 1);
  ASSERT_EQ(returns.size(), 12);
  for (std::size_t i = 0; i < returns.size(); ++i)
    EXPECT_EQ(std::isnan(returns[i]), i < 4) << "episodes end in iteration 5, counted from 1";
  EXPECT_EQ(returns[5], returns[4]) << "none has ended since";
  EXPECT_NE(returns[9], returns[8]);
}

// On 2276f903 all episodes of one length end in the same iteration.
TEST_F(TrainTraining, EpisodesOfOneLengthEndInEveryIteration) {
  Options some = options(12);
  some.csv = path("curve.csv");
  trained(some);
  const std::vector<double> returns = column_of(read_file(some.csv), 1);
  for (std::size_t i = 0; i < returns.size(); ++i)
    EXPECT_EQ(std::isnan(returns[i]), i < 4) << "one that is cut is not an episode";
  for (std::size_t i = 5; i < returns.size(); ++i) EXPECT_NE(returns[i], returns[i - 1]) << i;
}

TEST_F(TrainTraining, OtherSettingsLearnSomethingElse) {
  Options one = small(options(3));
  // With 8 these three iterations end near the divergence that is wanted: no schedule would show.
  one.settings.n_epochs = 4;
  const std::string policy = trained(one);
  for (const auto& [name, value] :
       std::vector<std::pair<const char*, const char*>>{{"activation_fn", "relu"},
                                                        {"gae_lambda", "0.9"},
                                                        {"n_steps", "16"},
                                                        {"n_envs", "64"},
                                                        {"stagger", "false"},
                                                        {"n_minibatches", "4"},
                                                        {"n_epochs", "2"},
                                                        {"clip_range", "0.05"},
                                                        {"max_grad_norm", "0.001"},
                                                        {"learning_rate", "0.0005"},
                                                        {"schedule", "constant"},
                                                        {"target_kl", "0.0001"},
                                                        {"kl_stop_factor", "0.1"},
                                                        {"decay_steps", "1000"},
                                                        {"initial_std", "0.5"},
                                                        {"std_learning_rate_ratio", "1"},
                                                        {"norm_obs", "false"},
                                                        {"freeze_after", "1"},
                                                        {"ema_decay", "0"}}) {
    Options other = one;
    set(other.settings, name, value);
    const std::string learnt = trained(other);
    // Behind the metadata, which names the settings.
    EXPECT_NE(learnt.substr(learnt.size() - 64), policy.substr(policy.size() - 64)) << name;
  }
}

TEST_F(TrainTraining, TheDeviationStaysWhereItLearnsNothing) {
  for (const char* rate : {"0", "0.5"}) {
    Options one = small(options(3));
    one.csv = path("curve.csv");
    set(one.settings, "initial_std", "0.75");
    set(one.settings, "std_learning_rate_ratio", rate);
    trained(one);
    const double deviation = column_of(read_file(one.csv), 5).back();
    EXPECT_EQ(std::abs(deviation - 0.75) < 1e-5, rate == std::string("0")) << deviation;
  }
}

TEST_F(TrainTraining, SeveralSeeds) {
  Options all = small(options(5));
  all.seeds = 2;
  all.csv = path("all.csv");
  all.curve = path("all.svg");
  EXPECT_EQ(train_seeds(all, pendulum(), never), kProblems) << "not successful so soon";
  const std::string best = read_file(all.output);
  std::vector<std::string> policies;
  for (const std::uint64_t seed : {1U, 2U}) {
    Options one = small(options(5));
    one.settings.seed = seed;
    one.output = path("one.safetensors");
    policies.push_back(trained(one));
    EXPECT_EQ(read_file(path_of_seed(all.output, seed)), policies.back());
  }
  EXPECT_TRUE(best == policies[0] || best == policies[1]);
  EXPECT_TRUE(read_file(all.csv).starts_with("seed,steps,return,"));
  for (const char* row : {"\n1,40960,", "\n2,40960,"})
    EXPECT_NE(read_file(all.csv).find(row), std::string::npos) << row;
  EXPECT_NE(read_file(all.curve).find("2 seeds"), std::string::npos);
}

// Before, --seeds took no --checkpoint.
TEST_F(TrainTraining, SeveralSeedsGoOn) {
  Options all = small(options(8));
  all.seeds = 3;
  train_seeds(all, pendulum(), never);
  std::vector<std::string> policies;
  for (const std::uint64_t seed : {1U, 2U, 3U})
    policies.push_back(read_file(path_of_seed(all.output, seed)));
  all.steps = options(3).steps;
  all.checkpoint = path("checkpoint");
  train_seeds(all, pendulum(), never);
  fs::remove(path("checkpoint.seed2"));  // was killed before it wrote one
  all.steps = options(8).steps;
  all.resume = all.checkpoint;
  check_files(all);
  train_seeds(all, pendulum(), never);
  for (const std::uint64_t seed : {1U, 2U, 3U})
    EXPECT_EQ(read_file(path_of_seed(all.output, seed)), policies[seed - 1]) << seed;
  all.resume = path("elsewhere");
  EXPECT_NE(said_by([&] { check_files(all); }).find("elsewhere.seed1`: No such file"),
            std::string::npos);
}

TEST_F(TrainTraining, ASeedThatFailsEndsTheOthers) {
  Options all = small(options(1'000'000));
  all.settings.until_return = 1.0;  // the reward is negative
  all.seeds = all.threads = 3;
  fs::create_directories(path("checkpoint.seed3"));  // cannot be written over
  all.checkpoint = path("checkpoint");
  all.resume = path("checkpoint");
  EXPECT_NE(said_by([&] { train_seeds(all, pendulum(), never); }).find("checkpoint.seed3"),
            std::string::npos);
}

TEST_F(TrainTraining, LearnsToSwingUp) {
  Options all = options(200);
  all.threads = 2;
  all.csv = path("curve.csv");
  all.curve = path("curve.svg");
  EXPECT_EQ(Training(all, pendulum()).run(never), kDone);  // 99 of 100 succeed, four times
  EXPECT_TRUE(read_file(all.csv).starts_with("steps,return,success_rate,"));
  EXPECT_TRUE(read_file(all.curve).starts_with("<svg "));
  EXPECT_TRUE(fs::exists(path("policy.golden.csv")));
}

TEST_F(TrainTraining, LearnsToChoose) {
  Options all = options(200);
  all.threads = 2;
  EXPECT_EQ(Training(all, choices()).run(never), kDone);
  EXPECT_EQ(Training(all, several()).run(never), kDone);
}

/// Of the last row of a learning curve that has one.
double last_evaluation(const std::string& csv) {
  double result = std::numeric_limits<double>::quiet_NaN();
  std::istringstream rows(csv);
  std::string row, cell;
  std::getline(rows, row);  // names
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
    if (!cell.empty()) result = std::stod(cell);
  }
  return result;
}

TEST_F(TrainTraining, GoesOnUntilTheReturnIsGoodToo) {
  Options all = options(200);
  all.csv = path("curve.csv");
  ASSERT_EQ(Training(all, pendulum()).run(never), kDone);
  const double more = last_evaluation(read_file(all.csv)) + 0.5;  // than the first that succeeds
  all.settings.until_return = more;
  EXPECT_EQ(Training(all, pendulum()).run(never), kDone);
  EXPECT_GE(last_evaluation(read_file(all.csv)), more);
  all = options(40);
  all.settings.until_return = 1.0;  // the reward is negative
  EXPECT_EQ(Training(all, pendulum()).run(never), kProblems);
}

TEST_F(TrainTraining, AnyThreadsAndInstructionsLearnToChooseTheSameBits) {
  for (const Library* library : {&choices(), &several()}) {
    Options one = options(4);
    const std::string policy = trained(one, *library);
    one.threads = 3;
    one.kernels = "plain";
    EXPECT_EQ(trained(one, *library), policy);
  }
}

TEST_F(TrainTraining, WithoutSuccessTheExitCodeSaysSo) {
  const Interrupt at_once = true;
  EXPECT_EQ(Training(options(1), pendulum()).run(never), kProblems);
  EXPECT_EQ(Training(options(1), pendulum()).run(at_once), 130);
  EXPECT_TRUE(fs::exists(path("policy.safetensors")));  // the one that it began with
}

TEST_F(TrainTraining, FilesThatCannotBeWrittenAreRefusedBefore) {
  Options bad = options(1);
  bad.output = path("nowhere/policy.safetensors");
  EXPECT_NE(said_by([&] { check_files(bad); }).find("No such file"), std::string::npos);
  bad.output = path("");
  EXPECT_NE(said_by([&] { check_files(bad); }).find("is a folder"), std::string::npos);
  bad = options(1);
  bad.csv = "/proc/curve.csv";
  EXPECT_NE(said_by([&] { check_files(bad); }).find("cannot write `/proc/curve.csv`"),
            std::string::npos);
}

TEST_F(TrainTraining, AFileIsThereAsAWholeOrNotAtAll) {
  write_file(path("file"), "before");
  // As a disk that is full behind the third byte.
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit little{3, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &little);
  const std::string said = said_by([&] { write_file(path("file"), "after"); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(said.find("cannot write"), std::string::npos);
  EXPECT_EQ(read_file(path("file")), "before");
  EXPECT_EQ(std::distance(fs::directory_iterator(path("")), fs::directory_iterator()), 1);
}

TEST(TrainLibrary, OfAnotherGraphIsRefusedOnce) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  setenv(host::kOutputLocks, (std::to_string(ends[0]) + "," + std::to_string(ends[1])).c_str(), 1);
  setenv(host::kExpectedGraph, "0x0000000000000001", 1);
  EXPECT_NE(said_by([] { Library(EAGERX_TEST_PENDULUM); }).find("built from another graph"),
            std::string::npos);
  EXPECT_EQ(fcntl(ends[0], F_GETFD), -1) << "others may build now";
  EXPECT_EQ(fcntl(ends[1], F_GETFD), -1);
  EXPECT_EQ(said_by([] { Library(EAGERX_TEST_PENDULUM); }), "nothing");
}

TEST(TrainLibrary, AnythingElseIsRefused) {
  EXPECT_NE(said_by([] { Library("/dev/null"); }).find("cannot load"), std::string::npos);
  EXPECT_NE(said_by([] { Library("libm.so.6/"); }).find("cannot load"), std::string::npos);
  EXPECT_NE(said_by([] { read_description("{}"); }).find("describes itself"), std::string::npos);
  EXPECT_NE(said_by([] { read_description("no JSON"); }).find("describes itself"),
            std::string::npos);
}

TEST(TrainOptions, WrongOnesAreRefused) {
  const auto parse = [](std::vector<const char*> words) {
    words.insert(words.begin(), "eagerx-train");
    return said_by([&] { parse_options(static_cast<int>(words.size()), words.data()); });
  };
  EXPECT_EQ(parse({"lib.so"}), "nothing");
  EXPECT_EQ(parse({}), "LIBRARY is missing");
  EXPECT_EQ(parse({"a.so", "b.so"}), "there is one LIBRARY only, `b.so` is another");
  EXPECT_EQ(parse({"a.so", "--steps", "0"}),
            "--steps: `0` is not a number from 1 to 1000000000000");
  EXPECT_EQ(parse({"a.so", "--steps"}), "`--steps` needs a value");
  EXPECT_EQ(parse({"a.so", "--until-return", "--steps", "3"}), "`--until-return` needs a value");
  EXPECT_EQ(parse({"a.so", "--seed=1x"}),
            "--seed: `1x` is not a number from 0 to 4611686018427387903");
  EXPECT_EQ(parse({"a.so", "--gamma", "nan"}), "--gamma: `nan` is not a number from 0 to 0.99999");
  EXPECT_EQ(parse({"a.so", "--until-return", "inf"}),
            "--until-return: `inf` is not a number from -1e+30 to 1e+30");
  EXPECT_EQ(parse({"a.so", "--hidden", "64,"}), "--hidden: `` is not a number from 1 to 1024");
  EXPECT_EQ(parse({"a.so", "--algorithm", "td3"}),
            "--algorithm: there is no algorithm `td3`, only ppo and sac");
  EXPECT_EQ(parse({"a.so", "--quiet=1"}), "`--quiet` takes no value");
  EXPECT_EQ(parse({"--help", "--more"}), "nothing");
  EXPECT_EQ(parse({"a.so", "--more"}), "there is no option `--more`");
}

}  // namespace
}  // namespace eagerx::train
