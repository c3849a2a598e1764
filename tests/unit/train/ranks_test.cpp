// Ranks are threads here, so that this needs no MPI: tests/train/mpi has it.
#include <gtest/gtest.h>

#include <algorithm>

#include "targets/environments/train/ranks/gradient_sum.hpp"
#include "targets/environments/train/ranks/together.hpp"
#include "targets/environments/train/training.hpp"
#include "tests/unit/train/common.hpp"
#include "tests/unit/train/thread_ranks.hpp"

namespace eagerx::train {
namespace {

const Library& one_pendulum() {
  static const Library library(EAGERX_TEST_PENDULUM);
  return library;
}

const Model& its_model() {
  static const Model model(Settings(), 3, Head(one_pendulum().description()));
  return model;
}

std::vector<Gradient> gradients() {
  std::vector<Gradient> all(kParts, Gradient(its_model()));
  Random random({5, 0, 0}, 1);
  for (Gradient& one : all) {
    for (std::vector<float>* values : one.vectors()) {
      for (float& x : *values) x = random.normal(0.0F, 1.0F);
    }
    one.divergence = double{random.uniform(0.0F, 1.0F)};
    one.count = double{random.uniform(1.0F, 9.0F)};
  }
  return all;
}

std::vector<float> numbers_of(const Gradient& gradient) {
  Gradient copy = gradient;
  std::vector<float> all;
  for (std::vector<float>* values : copy.vectors())
    all.insert(all.end(), values->begin(), values->end());
  return all;
}

TEST(TrainRanks, AnyNumberOfThemAddsInTheOrderOfParts) {
  std::vector<Gradient> one = gradients();
  for (std::size_t part = 1; part < kParts; ++part) one.front().add(one[part]);
  // In another order the sums are others, so that this test can fail.
  std::vector<Gradient> other = gradients();
  for (std::size_t part = kParts - 1; part > 0; --part) other.front().add(other[part]);
  ASSERT_NE(numbers_of(other.front()), numbers_of(one.front()));
  for (const std::uint32_t count : {2U, 3U, 5U, 8U}) {
    in_ranks(count, [&](Ranks& ranks) {
      std::vector<Gradient> all = gradients();
      const auto share = environments::share_of(kParts, ranks.rank(), count);
      std::vector<Gradient*> own;
      for (std::size_t part = share.first; part < share.end; ++part) own.push_back(&all[part]);
      GradientSum sum(ranks, its_model());
      for (int again = 0; again < 2; ++again) {
        const Gradient& total = sum.of(own);
        EXPECT_EQ(numbers_of(total), numbers_of(one.front())) << count;
        EXPECT_EQ(total.divergence, one.front().divergence);
        EXPECT_EQ(total.count, one.front().count);
      }
    });
  }
}

TEST(TrainRanks, TheProblemOfTheFirstIsThatOfAll) {
  in_ranks(4, [](Ranks& ranks) {
    const auto work = [&] {
      if (ranks.rank() >= 2)
        throw Problem(kProblems, "of " + std::to_string(ranks.rank()), "no help");
    };
    try {
      together(ranks, work, [] { return std::string(); });
      FAIL() << "rank " << ranks.rank();
    } catch (const Problem& problem) {
      EXPECT_EQ(std::string(problem.what()), "of 2");
      EXPECT_EQ(problem.help, "no help");
      EXPECT_EQ(problem.code, kProblems);
    }
  });
}

TEST(TrainRanks, BytesOfAllAreInOrder) {
  in_ranks(3, [](Ranks& ranks) {
    const auto all = together(
        ranks, [] {}, [&] { return std::string(ranks.rank(), 'x'); });
    EXPECT_EQ(all, (std::vector<std::string>{"", "x", "xx"}));
    EXPECT_TRUE(ranks.is_any(ranks.rank() == 1));
    EXPECT_FALSE(ranks.is_any(false));
  });
}

class TrainRanksTraining : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  Options options(const std::string& name, std::uint64_t iterations) const {
    Options result;
    result.settings = even_settings();
    result.library = EAGERX_TEST_PENDULUM;
    result.output = path(name + ".safetensors");
    result.checkpoint = path(name + ".checkpoint");
    result.steps = iterations * 128 * 32;
    result.threads = 1;
    result.is_quiet = true;
    result.settings.n_envs = 128;
    result.settings.net_arch = {8, 8};
    return result;
  }

  /// One that is cut in two, each with other ranks.
  void expect_the_same_bits(Memory memory, std::initializer_list<std::uint32_t> counts) const {
    const Interrupt never = false;
    const auto of_memory = [&](Options options) {
      options.settings.rnn = memory;
      options.settings.rnn_hidden_size = 6;
      options.settings.n_minibatches = 4;
      return options;
    };
    const Options whole = of_memory(options("whole", 9));
    Training(whole, one_pendulum()).run(never);
    const std::string policy = read_file(whole.output), checkpoint = read_file(whole.checkpoint);
    for (const std::uint32_t count : counts) {
      Options first = of_memory(options("first", 6));
      in_ranks(count, [&](Ranks& ranks) { Training(first, one_pendulum(), {}, ranks).run(never); });
      Options second = of_memory(options("second", 9));
      second.resume = first.checkpoint;
      in_ranks(10 - count,
               [&](Ranks& ranks) { Training(second, one_pendulum(), {}, ranks).run(never); });
      EXPECT_TRUE(read_file(second.output) == policy) << count;
      EXPECT_TRUE(read_file(second.checkpoint) == checkpoint) << count;
    }
  }

 private:
  TestFolder folder_;
};

TEST_F(TrainRanksTraining, AnyNumberOfThemLearnsTheSameBits) {
  expect_the_same_bits(Memory::none, {2, 3, 8});
}

TEST_F(TrainRanksTraining, WhatIsRememberedGoesToAll) {
  expect_the_same_bits(Memory::gru, {2, 7});
}

}  // namespace
}  // namespace eagerx::train
