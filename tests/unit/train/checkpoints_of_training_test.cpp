// The checkpoints of a training, and how another one continues from them.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "tests/unit/train/training_common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

// On 0d2dc587 only iteration 32 of these has a checkpoint: an era begins there.
TEST_F(TrainTraining, WhatGoesOnFromACheckpointIsOneTraining) {
  Options whole = small(options(38));
  whole.csv = path("whole.csv");
  const std::string policy = trained(whole);
  const std::string curve = read_file(whole.csv);
  for (const std::uint64_t iterations : {1, 5, 32, 34}) {
    Options first = small(options(iterations));
    first.checkpoint = path("checkpoint");
    trained(first);
    Options second = small(options(36));
    second.resume = second.checkpoint = first.checkpoint;
    trained(second);
    Options third = whole;
    third.resume = first.checkpoint;
    EXPECT_EQ(trained(third), policy) << iterations;
    EXPECT_EQ(read_file(third.csv), curve) << iterations;
  }
}

// Iterations of 32, 64, … 160 steps of 16 environments, in eras of 1024 steps.
TEST_F(TrainTraining, IterationsOfAnyLengthGoOnToo) {
  Options whole = small(options(15));
  whole.threads = 1;  // two wait for each other at every minibatch, long where other tests run
  whole.settings.n_envs = 16;
  whole.settings.max_n_steps = 160;
  whole.settings.n_minibatches = 4;
  whole.csv = path("whole.csv");
  const std::string policy = trained(whole);
  const std::string curve = read_file(whole.csv);
  for (const std::uint64_t thousands : {1, 30, 64, 65, 100}) {
    Options first = whole;
    first.csv.clear();
    first.steps = thousands * 1000;
    first.checkpoint = path("checkpoint");
    trained(first);
    Options second = whole;
    second.resume = first.checkpoint;
    EXPECT_EQ(trained(second), policy) << thousands;
    EXPECT_EQ(read_file(second.csv), curve) << thousands;
  }
}

TEST_F(TrainTraining, ChoicesGoOnToo) {
  Options some;
  for (const Library* library : {&choices(), &several()}) {
    some = small(options(3));
    some.checkpoint = path("checkpoint");
    trained(some, *library);
    some = small(options(6));
    const std::string policy = trained(some, *library);
    some.resume = path("checkpoint");
    EXPECT_EQ(trained(some, *library), policy);
  }
}

TEST_F(TrainTraining, AKilledOneGoesOnFromWhatItHasWritten) {
  Options endless = small(options(1'000'000));
  endless.settings.until_return = 1.0;  // the reward is negative
  endless.threads = 1;                  // no others in a process that forks
  endless.checkpoint = path("checkpoint");
  endless.checkpoint_every_s = 0.0;
  const pid_t child = fork();
  if (child == 0) _exit(Training(endless, pendulum()).run(never));
  while (!fs::exists(endless.checkpoint) && waitpid(child, nullptr, WNOHANG) == 0) usleep(1000);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  Options rest = small(options(40));
  rest.settings.until_return = 1.0;
  const std::string policy = trained(rest);
  rest.resume = endless.checkpoint;
  EXPECT_EQ(trained(rest), policy);
}

TEST_F(TrainTraining, AnInterruptLeavesACheckpoint) {
  Options some = small(options(4));
  const std::string policy = trained(some);
  some.checkpoint = path("checkpoint");
  const Interrupt at_once = true;
  EXPECT_EQ(Training(some, pendulum()).run(at_once), 130);
  some.resume = some.checkpoint;
  EXPECT_EQ(trained(some), policy);
}

// An error in the middle of an iteration, and one in an evaluation.
TEST_F(TrainTraining, AnErrorLeavesWhatWasLearntBefore) {
  Options whole = small(options(38));
  whole.settings.stagger = false;  // the library counts whole episodes
  const std::string policy = trained(whole);
  for (const auto& [where, steps] : {std::pair("rollout", "253952"), {"evaluation", "81920"}}) {
    Options first = whole;
    first.checkpoint = path("checkpoint");
    setenv("EAGERX_TEST_BREAKS", where, 1);
    const std::string what = said_by([&] { Training(first, pendulum()).run(never); });
    unsetenv("EAGERX_TEST_BREAKS");
    EXPECT_NE(what.find("a reward is not finite\nnote: the training had made " +
                        std::string(steps) + " steps"),
              std::string::npos)
        << what;
    EXPECT_NE(what.find("; what it had learnt is in `" + first.checkpoint + "`"), std::string::npos)
        << what;
    Options second = whole;
    second.resume = first.checkpoint;
    EXPECT_EQ(trained(second), policy) << where;
    fs::remove(first.checkpoint);
  }
}

TEST_F(TrainTraining, ACheckpointThatCannotBeWrittenDoesNotCostThePolicy) {
  Options some = small(options(34));
  const std::string policy = trained(some);
  fs::remove(some.output);
  some.checkpoint = path("checkpoint");
  fs::create_directories(path("checkpoint"));  // nothing can be written there
  EXPECT_NE(said_by([&] { Training(some, pendulum()).run(never); }).find("cannot write"),
            std::string::npos);
  EXPECT_EQ(read_file(some.output), policy);
}

TEST_F(TrainTraining, FineTuningBeginsWithWhatWasLearnt) {
  Options first = options(200);
  first.threads = 2;
  first.checkpoint = path("checkpoint");
  const std::string learnt = trained(first);  // succeeds
  Options again = first;
  again.resume = first.checkpoint;
  EXPECT_EQ(trained(again), learnt) << "a successful training does not continue";
  Options second = options(5);
  second.settings.seed = 7;
  EXPECT_EQ(Training(second, pendulum()).run(never), kProblems) << "not from nothing";
  second.from = first.checkpoint;
  EXPECT_EQ(Training(second, pendulum()).run(never), kDone);
  const std::string tuned = read_file(second.output);
  second.threads = 3;
  EXPECT_EQ(trained(second), tuned);
}

TEST_F(TrainTraining, OtherSettingsDoNotGoOn) {
  Options first = small(options(1));
  first.checkpoint = path("checkpoint");
  trained(first);
  Options second = first;
  second.resume = first.checkpoint;
  second.settings.clip_range = 0.3F;
  EXPECT_EQ(said_by([&] { Training(second, pendulum()); }),
            "`" + first.checkpoint + "` belongs to another training: clip_range 0.2 (here 0.3)");
}

TEST_F(TrainTraining, ACheckpointOfAnotherTrainingIsRefused) {
  Options first = options(33);
  first.settings.net_arch = {8};
  first.checkpoint = path("checkpoint");
  trained(first);
  Options other = first;
  other.resume = first.checkpoint;
  other.settings.seed = 5;
  EXPECT_NE(said_by([&] { Training(other, pendulum()); }).find("belongs to another training"),
            std::string::npos);
  Options wider = options(1);
  wider.settings.net_arch = {9};
  wider.from = first.checkpoint;
  EXPECT_NE(said_by([&] { Training(wider, pendulum()); }).find("is of other networks"),
            std::string::npos);
  std::string bytes = read_file(first.checkpoint);
  bytes.back() = static_cast<char>(bytes.back() + 1);
  write_file(first.checkpoint, bytes);
  other.settings.seed = 1;
  EXPECT_NE(said_by([&] { Training(other, pendulum()); }).find("is damaged"), std::string::npos);
  bytes.replace(0, bytes.find('\n'), "eagerx-train checkpoint 3");
  write_file(first.checkpoint, bytes);
  EXPECT_NE(said_by([&] { Training(other, pendulum()); }).find("was written by another version"),
            std::string::npos);
  write_file(first.checkpoint, "something else");
  EXPECT_NE(said_by([&] { Training(other, pendulum()); }).find("is not a checkpoint"),
            std::string::npos);
}
}  // namespace
}  // namespace eagerx::train
