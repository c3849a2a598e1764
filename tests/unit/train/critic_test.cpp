// A critic that sees more than the policy.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/client.hpp"
#include "targets/environments/train/sight.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"

namespace eagerx::train {
namespace {

namespace fs = std::filesystem;

const Library& with_critic() {
  static const Library library(EAGERX_TEST_CRITIC);
  return library;
}
class TrainCritic : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  Options options(std::uint64_t iterations) const {
    Options result;
    result.settings = even_settings();
    result.output = path("policy.safetensors");
    result.steps = iterations * kIteration;
    result.settings.net_arch = {8, 8};
    result.threads = 1;
    result.is_quiet = true;
    return result;
  }
  static std::string trained(const Options& options, const Library& library) {
    Training(options, library).run(never);
    return read_file(options.output);
  }
  static std::string said(const Options& options, const Library& library) {
    try {
      trained(options, library);
    } catch (const Problem& problem) {
      return problem.what();
    }
    return "nothing";
  }

 private:
  TestFolder folder_;
};

TEST_F(TrainCritic, RowsHaveWhatItSees) {
  const Description& description = with_critic().description();
  ASSERT_EQ(description.critic_numbers(), 2U);
  Rows rows(description, 2);
  rows.final_observation = rows.observation;
  Sight sight(description, rows);
  EXPECT_EQ(sight.width(), 5U);
  EXPECT_EQ(sight.actor_width(), 3U);
  Environments environments(with_critic().functions(), 2, 0, 1, 0, EAGERX_SAME_STEP);
  environments.reset(1, rows.observation.data());
  sight.look(environments);
  const float luck = sight.now()[5 + 4];
  EXPECT_GT(luck, 0.0F);
  const float action[] = {0.0F, 0.0F};
  for (int step = 1; step <= 150; ++step) {
    ASSERT_TRUE(environments.step(action, rows.pointers()));
    sight.look(environments);
    sight.look_at_ends(environments);
    for (int k = 0; k < 2; ++k) {
      const float* row = sight.now() + 5 * k;
      EXPECT_EQ(row[0], rows.observation[3 * k]);
      EXPECT_NEAR(std::cos(row[3]), row[0], 1e-5F) << step;
    }
  }
  EXPECT_EQ(sight.at_end()[5 + 4], luck);
  EXPECT_NE(sight.now()[5 + 4], luck);
  EXPECT_NEAR(std::cos(sight.at_end()[3]), sight.at_end()[0], 1e-5F);
  sight.end(1);
  EXPECT_EQ(sight.at_end()[5 + 4], sight.now()[5 + 4]);
  EXPECT_NE(sight.at_end()[4], sight.now()[4]);
}

TEST_F(TrainCritic, AnyThreadsLearnTheSameBitsAndOthersThanWithoutIt) {
  Options one = options(6);
  const std::string policy = trained(one, with_critic());
  one.threads = 3;
  one.kernels = "plain";
  EXPECT_EQ(trained(one, with_critic()), policy);
  EXPECT_NE(trained(one, pendulum()), policy);
}

TEST_F(TrainCritic, ThePolicySeesNothingOfIt) {
  const std::string policy = trained(options(1), with_critic());
  EXPECT_NE(policy.find("\"obs\":\"angle (2), speed\""), std::string::npos);
  EXPECT_NE(policy.find("\"policy.hidden.0.weight\":{\"dtype\":\"F32\",\"shape\":[8,3]"),
            std::string::npos);
}

TEST_F(TrainCritic, WhatGoesOnIsOneTraining) {
  const std::string policy = trained(options(6), with_critic());
  Options first = options(3);
  first.checkpoint = path("checkpoint");
  trained(first, with_critic());
  Options rest = options(6);
  rest.resume = first.checkpoint;
  EXPECT_EQ(trained(rest, with_critic()), policy);
}

TEST_F(TrainCritic, SacSeesItToo) {
  Options one = options(1);
  one.settings.algorithm = "sac";
  one.steps = std::uint64_t{4} * 512;
  const std::string policy = trained(one, with_critic());
  EXPECT_NE(policy.find("\"policy.hidden.0.weight\":{\"dtype\":\"F32\",\"shape\":[8,3]"),
            std::string::npos);
  EXPECT_NE(trained(one, pendulum()), policy);
  one.threads = 3;
  one.kernels = "plain";
  EXPECT_EQ(trained(one, with_critic()), policy);
  Options first = one;
  first.steps = std::uint64_t{3} * 512;
  first.checkpoint = path("checkpoint");
  trained(first, with_critic());
  one.resume = first.checkpoint;
  EXPECT_EQ(trained(one, with_critic()), policy);
  one.resume.clear();
  one.replay = {first.output};
  EXPECT_NE(said(one, with_critic()).find("does not say what the critic sees"), std::string::npos);
}

TEST_F(TrainCritic, CheckpointsOfAnotherCriticAreRefused) {
  Options first = options(1);
  first.checkpoint = path("checkpoint");
  trained(first, with_critic());
  Options other = options(2);
  other.resume = first.checkpoint;
  EXPECT_EQ(said(other, pendulum()),
            "`" + first.checkpoint +
                "` belongs to another training: critic error[1] luck[1] (here there is none)");
  other.resume.clear();
  other.from = first.checkpoint;
  EXPECT_NE(said(other, pendulum()).find("is of other networks"), std::string::npos);
  EXPECT_EQ(said(other, with_critic()), "nothing");
}

}  // namespace
}  // namespace eagerx::train
