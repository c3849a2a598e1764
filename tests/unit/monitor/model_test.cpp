// The state of a stream without a clock: tests give the times.
#include "generator/tools/monitor/model.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

#include "generator/tools/monitor/lines.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A graph with an action between -2 and 2, whose safe value is 0, and a sensor.
Expected swing() {
  Expected expected;
  expected.file = "swing.yaml";
  expected.graph = "swing";
  expected.hash = 0xff;
  expected.step_hz = 10.0;
  const auto add = [&](const char* name, std::uint64_t size, std::uint64_t rate) {
    ExpectedChannel each;
    each.channel = {name, trace_log::Dtype::float32, size, rate, 1};
    expected.places.emplace(name, expected.channels.size());
    expected.channels.push_back(std::move(each));
  };
  add("environment/u", 1, 10);
  add("arm/q", 3, 40);
  expected.channels[0].low = {-2.0};
  expected.channels[0].high = {2.0};
  expected.channels[0].safe = {0.0};
  return expected;
}

class Watched : public testing::Test {
 protected:
  void send(const char* channel, std::vector<double> values, std::int64_t time_ms,
            std::int64_t real_ms, std::uint32_t episode = 0) {
    model_.now(real_ms * kMs);
    StreamMessage message;
    message.channel = channel;
    message.values = values;
    message.elements = values.size();
    message.episode = episode;
    message.time_ns = time_ms * kMs;
    message.real_ns = real_ms * kMs;
    model_.message(message);
  }
  const WatchedChannel& channel(const char* name) const {
    for (const auto& each : model_.channels())
      if (each.name == name) return each;
    ADD_FAILURE() << "there is no channel " << name;
    std::abort();
  }
  ChannelState state(const char* name) const { return model_.state(channel(name)); }

  Expected expected_ = swing();
  Model model_{&expected_};
};

TEST_F(Watched, ShowsWhatIsMissing) {
  EXPECT_EQ(model_.channels().size(), 2U);
  EXPECT_EQ(state("arm/q").words(), "missing");
  send("arm/q", {1, 2, 3}, 0, 0);
  EXPECT_EQ(channel("arm/q").values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(state("environment/u").words(), "missing");
}

TEST_F(Watched, MeasuresRatesAgainstThePlan) {
  for (int i = 0; i <= 20; ++i) send("environment/u", {1}, i * 100, 5'000 + i * 100);
  EXPECT_NEAR(*state("environment/u").measured_hz, 10.0, 1e-6);
  EXPECT_EQ(channel("environment/u").planned_hz, 10.0);
  EXPECT_EQ(state("environment/u").words(), "ok");
  for (int i = 0; i <= 20; ++i) send("arm/q", {1, 2, 3}, i * 50, 10'000 + i * 50);
  EXPECT_NEAR(*state("arm/q").measured_hz, 20.0, 1e-6);
  EXPECT_EQ(state("arm/q").words(), "rate");
}

TEST_F(Watched, WhatComesSeldomHasARateToo) {
  send("environment/u", {1}, 0, 0);
  EXPECT_FALSE(state("environment/u").measured_hz);
  send("environment/u", {1}, 5'000, 5'000);
  EXPECT_NEAR(*state("environment/u").measured_hz, 0.2, 1e-9);
  model_.now(55'000 * kMs);
  EXPECT_NEAR(*state("environment/u").measured_hz, 0.02, 1e-9);
}

TEST_F(Watched, OfUdpEveryStepHasOneMessageAtMost) {
  StreamFacts facts;
  facts.hash = 0xff;
  facts.one_message_a_step = true;
  ASSERT_TRUE(model_.begin(facts));
  EXPECT_EQ(channel("arm/q").planned_hz, 10.0);
}

TEST_F(Watched, TellsAgesAndSilence) {
  send("environment/u", {1}, 0, 1'000);
  model_.now(1'250 * kMs);
  EXPECT_NEAR(*state("environment/u").age_s, 0.25, 1e-9);
  EXPECT_FALSE(state("environment/u").is_silent);
  model_.now(1'600 * kMs);
  EXPECT_EQ(state("environment/u").words(), "silent");
}

TEST_F(Watched, LatenessIsAgainstTheEarliestOfTheEpisode) {
  send("environment/u", {1}, 0, 1'000);
  send("environment/u", {1}, 100, 1'098);
  EXPECT_EQ(channel("environment/u").late_ns, 0);
  send("environment/u", {1}, 200, 1'230);
  EXPECT_EQ(channel("environment/u").late_ns, 32 * kMs);
  send("environment/u", {1}, 300, 1'300);
  EXPECT_EQ(channel("environment/u").late_ns, 2 * kMs);
  EXPECT_EQ(model_.worst_late_ns(), 32 * kMs);
  send("environment/u", {1}, 400, 9'000, 1);  // a reset took long
  EXPECT_EQ(channel("environment/u").late_ns, 0);
}

TEST_F(Watched, SaysWhichLimitIsNear) {
  send("environment/u", {1.5}, 0, 0);
  auto limit = state("environment/u").limit;
  ASSERT_TRUE(limit);
  EXPECT_TRUE(limit->is_high);
  EXPECT_EQ(limit->bound, 2.0);
  EXPECT_EQ(limit->left, 0.125);
  EXPECT_EQ(state("environment/u").words(), "ok");
  send("environment/u", {-1.99}, 100, 100);
  EXPECT_EQ(state("environment/u").words(), "low");
  send("environment/u", {2.4}, 200, 200);
  EXPECT_NEAR(state("environment/u").limit->left, -0.1, 1e-12);
  EXPECT_EQ(state("environment/u").words(), "high");
  send("environment/u", {kNan}, 300, 300);
  EXPECT_FALSE(state("environment/u").limit);
}

TEST_F(Watched, KnowsTheSafeAction) {
  send("environment/u", {0.0}, 0, 0);
  EXPECT_EQ(state("environment/u").words(), "safe");
  send("environment/u", {1e-9}, 100, 100);
  EXPECT_EQ(state("environment/u").words(), "ok");
}

TEST_F(Watched, RefusesAnotherGraph) {
  StreamFacts facts;
  facts.hash = 0xfe;
  EXPECT_FALSE(model_.begin(facts));
  EXPECT_NE(model_.refusal().find("0x00000000000000fe"), std::string::npos);
  EXPECT_NE(model_.refusal().find("0x00000000000000ff"), std::string::npos);
  EXPECT_NE(model_.refusal().find("swing.yaml"), std::string::npos);
  EXPECT_FALSE(model_.begin({}));
  EXPECT_NE(model_.refusal().find("does not say"), std::string::npos);
  facts = {};
  facts.graph = "swing";
  facts.channels = {{"arm/q", trace_log::Dtype::float32, 2, 40, 1}};
  EXPECT_FALSE(model_.begin(facts));
  EXPECT_EQ(model_.refusal(),
            "`arm/q` is float32 [2] at 40 Hz, in `swing.yaml` float32 [3] at 40 Hz");
  facts.channels = {{"arm/w", trace_log::Dtype::float32, 2, 40, 1}};
  EXPECT_FALSE(model_.begin(facts));
  EXPECT_EQ(model_.refusal(), "`swing.yaml` has no channel `arm/w`");
}

TEST(Model, WithoutAGraphChannelsAreAsTheyCome) {
  Model model(nullptr);
  model.begin({});
  for (std::size_t i = 0; i < kMostStreamChannels + 3; ++i) {
    const std::string name = "c" + std::to_string(i);
    const std::vector<double> value = {1.0};
    model.message({.channel = name, .values = value, .elements = 1});
  }
  EXPECT_EQ(model.channels().size(), kMostStreamChannels);
  EXPECT_EQ(model.faults(StreamFault::crowded_out), 3U);
}

TEST(Model, KeepsTheLastMessagesOnly) {
  Model model(nullptr);
  const std::vector<double> values(40, 0.5);
  for (std::size_t i = 0; i < 2 * kHistory; ++i)
    model.message({.channel = "c", .values = values, .elements = 40});
  ASSERT_EQ(model.channels().front().history.size(), kMostHistories);
  EXPECT_EQ(model.channels().front().history.front().size(), kHistory);
  EXPECT_EQ(model.channels().front().values.size(), 40U);
}

TEST_F(Watched, LinesHaveAllColumns) {
  send("environment/u", {1.5}, 0, 0);
  model_.step({0, 4, 0, 0});
  model_.fault(StreamFault::damaged, 2);
  EXPECT_EQ(lines_text(model_),
            "# graph swing, episode 0, step 4, time 0 s, damaged 2\n"
            "environment/u\t1.5\t1\t-\t10\t0\t0\thigh=2\t0.125\tok\n"
            "arm/q\t-\t0\t-\t40\t-\t-\t-\t-\tmissing\n");
}

}  // namespace
}  // namespace eagerx::gen
