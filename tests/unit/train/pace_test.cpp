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
    EXPECT_EQ(pace.era, i / 47) << "47 iterations have 1504 steps";
    EXPECT_EQ(pace.since_era, i % 47 * 32);
  }
}

TEST(TrainPace, ItGoesToAnyIteration) {
  Pace walked(16, 128, 1000), gone = walked;
  for (int i = 0; i < 300; ++i) walked.next();
  gone.go_to(400);
  gone.go_to(300);
  EXPECT_EQ(gone.time, walked.time);
  EXPECT_EQ(gone.era, walked.era);
  EXPECT_EQ(gone.since_era, walked.since_era);
}

TEST(TrainPace, AStageBeginsWithAnEraThatThereHasNotBeen) {
  Pace pace(32, 32, 1024);  // 32 iterations
  pace.go_to(40);
  pace.end_era();
  EXPECT_EQ(pace.era, 2U);
  EXPECT_EQ(pace.since_era, 0U);
  Course course;
  course.go_on(pace.iteration, pace.era);
  EXPECT_EQ(course.stage, 1U);
  pace.go_to(73, course);
  EXPECT_EQ(pace.since_era, 32U);
  EXPECT_EQ(pace.era, 3U);
  pace.go_to(104, course);  // at the end of an era
  pace.end_era();
  EXPECT_EQ(pace.era, 4U) << "it has ended anyway";
}

TEST(TrainPace, ThePolicyIsAMeanOfAGrowingTail) {
  Settings settings;
  settings.ema_decay = 0.8F;
  settings.ema_window_fraction = 0.1F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 0), 1.0F) << "the first one";
  EXPECT_FLOAT_EQ(share_of_actor(settings, 4), 1.0F / 3.0F) << "the mean of all so far";
  EXPECT_FLOAT_EQ(share_of_actor(settings, 20), 0.2F);
  EXPECT_FLOAT_EQ(share_of_actor(settings, 50), 0.2F);
  EXPECT_FLOAT_EQ(share_of_actor(settings, 100), 0.1F);
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 0.01F);
  settings.ema_window_fraction = 0.5F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 0.002F);
  settings.ema_window_fraction = 0.0F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 0.2F);
  settings.ema_decay = 0.0F;
  EXPECT_FLOAT_EQ(share_of_actor(settings, 1000), 1.0F) << "no mean";
}

}  // namespace
}  // namespace eagerx::train
