// How long iterations and eras are.
#include "targets/environments/train/pace.hpp"

#include <gtest/gtest.h>

#include "targets/environments/train/ppo.hpp"

namespace eagerx::train {
namespace {

TEST(TrainPace, IterationsAreAFortiethOfAllBefore) {
  Pace pace(16, 128, 1000);
  EXPECT_EQ(pace.horizon(), 16U) << "at first the least";
  while (pace.time < 40U * 32U) {
    EXPECT_EQ(pace.horizon(), 16U) << pace.time;
    pace.next();
  }
  while (pace.time < 100000) {
    EXPECT_EQ(pace.horizon(), std::clamp<std::uint64_t>(pace.time / 40 / 16 * 16, 16, 128));
    pace.next();
  }
  EXPECT_EQ(pace.horizon(), 128U) << "at last the most";
}

TEST(TrainPace, TheMostIsAMultipleOfTheLeast) {
  EXPECT_EQ(Pace(32, 100, 1).most, 96U);
  EXPECT_EQ(Pace(128, 32, 1).most, 128U) << "and never less";
}

TEST(TrainPace, ErasEndBetweenIterations) {
  Pace pace(32, 32, 1500);
  for (std::uint32_t i = 0; i < 200; ++i, pace.next()) {
    EXPECT_EQ(pace.iteration, i);
    EXPECT_EQ(pace.time, 32U * i);
    EXPECT_EQ(pace.eras[0].number, i / 47) << "47 iterations have 1504 steps";
    EXPECT_EQ(pace.eras[0].since, i % 47 * 32);
  }
}

TEST(TrainPace, PartsBeginTheirErasOneAfterTheOther) {
  Pace pace(32, 128, 1024, 8);
  EXPECT_TRUE(pace.begins_all());
  std::array<std::uint32_t, 8> begun{};
  for (int i = 0; i < 1000; ++i) {
    pace.next();
    std::size_t begin = 0;
    for (std::size_t part = 0; part < 8; ++part) {
      if (!pace.begins(part)) continue;
      ++begin;
      ++begun[part];
      EXPECT_EQ(pace.eras[part].number, begun[part]);
    }
    EXPECT_LE(begin, 2U) << "of " << pace.iteration << ", where iterations have become longer";
    EXPECT_EQ(pace.begins_any(), begin > 0);
    EXPECT_FALSE(pace.begins_all());
  }
  for (const std::uint32_t count : begun) EXPECT_GT(count, 80U);
}

// Where they are long enough, each of eight parts has at least the steps of an era.
TEST(TrainPace, NoEraIsShorter) {
  Pace pace(32, 128, 2500, 8);
  for (int i = 0; i < 1000; ++i) {
    const auto before = pace.eras;
    const std::uint32_t steps = pace.horizon();
    pace.next();
    for (std::size_t part = 0; part < 8; ++part) {
      if (pace.begins(part)) {
        EXPECT_GE(before[part].since + steps, 2500U);
      } else {
        EXPECT_EQ(pace.eras[part].since, before[part].since + steps);
        EXPECT_LT(pace.eras[part].since, 5000U);
      }
    }
  }
}

TEST(TrainPace, ItGoesToAnyIteration) {
  for (const std::size_t parts : {1U, 8U}) {
    Pace walked(16, 128, 1000, parts), gone = walked;
    for (int i = 0; i < 300; ++i) walked.next();
    gone.go_to(400);
    gone.go_to(300);
    EXPECT_EQ(gone.time, walked.time);
    for (std::size_t part = 0; part < parts; ++part) {
      EXPECT_EQ(gone.eras[part].number, walked.eras[part].number);
      EXPECT_EQ(gone.eras[part].since, walked.eras[part].since);
    }
  }
}

TEST(TrainPace, AStageBeginsWithAnEraThatThereHasNotBeen) {
  Pace pace(32, 32, 1024);  // 32 iterations
  pace.go_to(40);
  pace.end_eras();
  EXPECT_EQ(pace.eras[0].number, 2U);
  EXPECT_TRUE(pace.begins_all());
  Course course;
  course.go_on(pace.iteration, pace.eras[0].number);
  EXPECT_EQ(course.stage, 1U);
  pace.go_to(73, course);
  EXPECT_EQ(pace.eras[0].since, 32U);
  EXPECT_EQ(pace.eras[0].number, 3U);
  pace.go_to(104, course);  // at the end of an era
  pace.end_eras();
  EXPECT_EQ(pace.eras[0].number, 4U) << "it has ended anyway";
}

TEST(TrainPace, AStageBeginsInAllParts) {
  Pace pace(32, 32, 1024, 8);
  pace.go_to(90);
  std::uint32_t last = 0;
  for (const Era& era : pace.eras) last = std::max(last, era.number);
  EXPECT_EQ(last, 2U);
  EXPECT_EQ(pace.eras[7].number, 1U) << "its first one was longer";
  Course course;
  pace.end_eras();
  course.go_on(pace.iteration, pace.eras[0].number);
  for (const Era& era : pace.eras) EXPECT_EQ(era.number, 3U);
  pace.go_to(90, course);
  EXPECT_TRUE(pace.begins_all());
  for (const Era& era : pace.eras) EXPECT_EQ(era.number, 3U);
  pace.go_to(122, course);
  EXPECT_TRUE(pace.begins(0));
  EXPECT_FALSE(pace.begins(1)) << "again one after the other";
}

TEST(TrainPace, ThePolicyIsAMeanOfAGrowingTail) {
  Settings settings;
  settings.averaging = 0.8F;
  settings.averaging_share = 0.1F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 0), 1.0F) << "the first one";
  EXPECT_FLOAT_EQ(share_of_actor(settings, 4), 1.0F / 3.0F) << "the mean of all so far";
  EXPECT_FLOAT_EQ(share_of_actor(settings, 20), 0.2F);
  EXPECT_FLOAT_EQ(share_of_actor(settings, 50), 0.2F);
  EXPECT_FLOAT_EQ(share_of_actor(settings, 100), 0.1F);
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 0.01F);
  settings.averaging_share = 0.5F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 0.002F);
  settings.averaging_share = 0.0F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 0.2F);
  settings.averaging = 0.0F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 1.0F) << "no mean";
}

}  // namespace
}  // namespace eagerx::train
