// Training of policies that remember: the promises of all trainings, and a task that needs it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/ppo.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train::recurrent_test {
namespace {

namespace fs = std::filesystem;

const Interrupt never = false;

/// The pendulum whose speed is not observed.
const Library& hidden() {
  static const Library library(EAGERX_TEST_HIDDEN);
  return library;
}

class TrainMemory : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  /// Quick, and does not succeed so soon.
  Options small(std::uint64_t iterations, const char* memory = "gru") const {
    Options result;
    result.settings = even_settings();
    result.library = EAGERX_TEST_HIDDEN;
    result.output = path("policy.safetensors");
    result.threads = 2;
    result.is_quiet = true;
    result.settings.net_arch = {8};
    set(result.settings, "rnn", memory);
    result.settings.rnn_hidden_size = 6;
    result.steps = iterations * result.settings.n_envs * result.settings.n_steps;
    return result;
  }

  /// The bytes of the policy.
  static std::string trained(const Options& options) {
    Training(options, hidden()).run(never);
    return read_file(options.output);
  }

  static std::string said(const Options& options) {
    try {
      Training(options, hidden()).run(never);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return "nothing";
  }

 private:
  TestFolder folder_;
};

TEST_F(TrainMemory, AnyThreadsAndInstructionsLearnTheSameBits) {
  for (const char* memory : {"gru", "lstm"}) {
    Options one = small(6, memory);
    const std::string policy = trained(one);
    one.threads = 3;
    for (const Kernels* kernels : kernels_here()) {
      one.kernels = kernels->name;
      EXPECT_EQ(trained(one), policy) << memory << ' ' << kernels->name;
    }
  }
}

// In the middle of an era what is remembered depends on all networks that there were since it
// began.
TEST_F(TrainMemory, WhatGoesOnFromACheckpointIsOneTraining) {
  const std::vector<std::tuple<const char*, std::uint64_t, std::uint64_t>> trainings = {
      {"gru", 5, 8}, {"gru", 33, 35}, {"lstm", 5, 8}};
  for (const auto& [memory, until, end] : trainings) {
    Options whole = small(end, memory);
    const std::string policy = trained(whole);
    Options first = small(until, memory);
    first.checkpoint = path("checkpoint");
    trained(first);
    whole.resume = first.checkpoint;
    EXPECT_EQ(trained(whole), policy) << memory << ' ' << until;
  }
}

/// A policy learns from what was done: as long as nothing has been learnt, going through the
/// sequences again gives the same probabilities, behind the ends of episodes, too. Eight
/// environments are one in each part, whose sequences are side by side.
TEST_F(TrainMemory, SequencesAreThoseOfTheRollout) {
  const std::vector<std::tuple<const char*, std::size_t, std::size_t>> trainings = {
      {"gru", 256, 32}, {"lstm", 256, 32}, {"gru", 8, 256}, {"lstm", 32, 128}, {"none", 16, 128}};
  for (const auto& [memory, environments, horizon] : trainings) {
    Settings settings = small(1, memory).settings;
    settings.n_epochs = settings.n_minibatches = 1;
    settings.n_envs = environments;
    settings.n_steps = horizon;
    ThreadPool pool(1, ThreadPool::Size::at_most);
    Ppo ppo(settings, hidden(), *kernels_here().back(), pool, 0);
    ppo.begin_era();
    std::size_t ended = 0;
    for (int i = 0; i < 8; ++i) {
      const Algorithm::Result result = ppo.iterate();
      EXPECT_LT(std::abs(result.divergence), 1e-8) << memory << ' ' << environments << ' ' << i;
      ended += result.episodes.size();
    }
    EXPECT_GT(ended, environments / 2) << memory << ' ' << environments;
  }
}

TEST_F(TrainMemory, ACheckpointOfAnotherMemoryIsRefused) {
  Options first = small(1);
  first.checkpoint = path("checkpoint");
  trained(first);
  Options second = small(2, "lstm");
  second.resume = first.checkpoint;
  EXPECT_EQ(said(second),
            "`" + first.checkpoint + "` belongs to another training: rnn gru (here lstm)");
  second.resume.clear();
  second.from = first.checkpoint;
  EXPECT_EQ(said(second),
            "`" + first.checkpoint + "` is of other networks: rnn gru 6 (here lstm 6)");
  Options third = small(1, "none");
  third.from = first.checkpoint;
  EXPECT_EQ(said(third),
            "`" + first.checkpoint + "` is of other networks: rnn gru 6 (here there is none)");
  third = small(1);
  third.settings.n_envs = 128;  // what is remembered of environments is not taken over
  third.settings.n_minibatches = 4;
  third.from = first.checkpoint;
  EXPECT_EQ(said(third), "nothing");
}

// Its check sum is right: somebody has made it so.
TEST_F(TrainMemory, StatesOfOtherEnvironmentsAreRefused) {
  const Options options = small(1);
  const Head head(hidden().description());
  Model learnt(options.settings, 2, head);
  const Progressed progressed;
  for (const int more : {0, 1, -1}) {
    Model other = learnt;
    other.remembered.resize(learnt.remembered.size() + static_cast<std::size_t>(more));
    const std::string bytes = checkpoint_of("graph 0", "interface", other, progressed);
    Model model = learnt;
    Progressed read;
    std::string what = "nothing";
    try {
      restore(bytes, "it", "graph 0", model, read);
    } catch (const Problem& problem) {
      what = problem.what();
    }
    EXPECT_EQ(what, more == 0 ? "nothing" : "`it` is not complete");
  }
}

TEST_F(TrainMemory, SwingsUpWithoutSeeingTheSpeed) {
  Options options = small(200);
  options.settings.net_arch = {32};
  options.settings.rnn_hidden_size = 32;
  EXPECT_EQ(Training(options, hidden()).run(never), kDone);
  options.settings.rnn = Memory::none;
  options.steps /= 2;
  EXPECT_EQ(Training(options, hidden()).run(never), kProblems);
}

}  // namespace
}  // namespace eagerx::train::recurrent_test
