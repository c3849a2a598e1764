// The push at the reset of a real object: how long, how strong, and what ends it.
#include <gtest/gtest.h>

#include <models/engine_states/random_action_and_sleep/random_action_and_sleep.hpp>

#include "tests/unit/models/real_engine_io.hpp"

namespace eagerx::models::testing {
namespace {

class Push : public RealEngineTest {};

struct PushIo {
  using Real = float;
  using Simulator = testing::Simulator;
  using State = Array<float, 2>;
  struct Config {
    static constexpr std::array<double, 1> low = {-2.0};
    static constexpr std::array<double, 1> high = {2.0};
    static constexpr std::array<double, 1> rest_action = {0.0};
    static constexpr double action_time = 0.5;
    static constexpr double sleep_time = 1.0;
  };
};

TEST_F(Push, RandomActionThenRest) {
  const std::int64_t start = FakeClock::now;
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  EXPECT_EQ(FakeClock::now - start, 1500 * kMs);
  ASSERT_EQ(FakeLink::sent.size(), 150U);
  const std::string push = FakeLink::sent[0];
  EXPECT_EQ(push, FakeLink::sent[49]);
  EXPECT_EQ(FakeLink::sent[50], "run act0 measure");
  FakeLink::sent.clear();
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  EXPECT_EQ(push, FakeLink::sent[0]) << "equal values push equally";
  FakeLink::sent.clear();
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.1F}}, simulator);
  EXPECT_NE(push, FakeLink::sent[0]);
}

TEST_F(Push, ErrorsOfTheLinkEndAPushAtOnce) {
  begin();
  FakeLink::sent.clear();
  FakeLink::results = {BusError::none, BusError::timeout};
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  ASSERT_EQ(FakeLink::sent.size(), 3U);
  EXPECT_EQ(FakeLink::sent[2], "post act5");
  EXPECT_EQ(count("safe actions in resets"), 1U);
}

TEST_F(Push, SensorsThatSayNothingEndAPush) {
  begin();
  FakeLink::sent.clear();
  FakeLink::sensor = BusError::parity;
  RandomActionAndSleep<PushIo>::reset({{1.0F, 2.0F}}, simulator);
  ASSERT_EQ(FakeLink::sent.size(), 3U) << "one is borne, the second is the last";
  EXPECT_EQ(FakeLink::sent[2], "post act5");
}

}  // namespace
}  // namespace eagerx::models::testing
