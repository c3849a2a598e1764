// Safety layers: ActionLimits, SlewLimit, NanGuard, FallbackController, PidController.
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <models/nodes/action_limits/action_limits.hpp>
#include <models/nodes/fallback_controller/fallback_controller.hpp>
#include <models/nodes/nan_guard/nan_guard.hpp>
#include <models/nodes/pid_controller/pid_controller.hpp>
#include <models/nodes/slew_limit/slew_limit.hpp>
#include <numbers>
#include <optional>
#include <string>

#include "tests/unit/models/safety_io.hpp"

namespace eagerx::models::testing {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

template <class Node>
std::map<std::string, std::uint64_t> counts(const Node& node) {
  std::map<std::string, std::uint64_t> result;
  node.for_each_count([&](const char* name, std::uint64_t count) { result[name] = count; });
  return result;
}

/// A node with one input and one output of one number, tick by tick.
template <template <class> class Node, class Io>
struct OneNumber {
  Node<Io> node;
  OneNumber() { node.reset({}); }
  /// Without a number nothing has come yet.
  float next(std::optional<float> x) {
    const float ring[1] = {x.value_or(0.0F)};
    const Seq received = x ? 1 : 0;
    float y = 99.0F;
    typename Io::Outputs out{y};
    node.callback({0}, {{ring, received, received}}, out);
    return y;
  }
};

TEST(ActionLimits, MovesIntoTheLimits) {
  OneNumber<ActionLimits, ActionLimitsIo<float, float>> limits;
  EXPECT_EQ(limits.next(std::nullopt), 0.0F);
  EXPECT_EQ(limits.next(1.5F), 1.5F);
  EXPECT_EQ(limits.next(-2.0F), -2.0F);
  EXPECT_EQ(counts(limits.node)["limited"], 0U);
  EXPECT_EQ(limits.next(3.5F), 3.0F);
  EXPECT_EQ(limits.next(-kInfinity), -2.0F);
  EXPECT_EQ(limits.next(kNaN), 0.0F);
  EXPECT_EQ(counts(limits.node)["limited"], 3U);
}

TEST(SlewLimit, FollowsAsFastAsItMay) {
  OneNumber<SlewLimit, SlewLimitIo<float, float>> slew;
  EXPECT_EQ(slew.next(std::nullopt), 0.25F);
  EXPECT_EQ(slew.next(0.5F), 0.5F);
  EXPECT_EQ(slew.next(2.0F), 1.0F);
  EXPECT_EQ(slew.next(2.0F), 1.5F);
  EXPECT_EQ(slew.next(2.0F), 2.0F);
  EXPECT_EQ(counts(slew.node)["limited"], 2U);
  EXPECT_EQ(slew.next(-kInfinity), 1.5F);
  EXPECT_EQ(slew.next(kNaN), 1.5F);
  EXPECT_EQ(counts(slew.node)["limited"], 4U);
  slew.node.reset({});
  EXPECT_EQ(slew.next(std::nullopt), 0.25F);
}

TEST(NanGuard, HoldsThenSafe) {
  OneNumber<NanGuard, NanGuardIo<float, float>> guard;
  EXPECT_EQ(guard.next(std::nullopt), 0.5F);
  EXPECT_EQ(guard.next(kNaN), 0.5F) << "there was no finite one yet";
  EXPECT_EQ(guard.next(3.0F), 3.0F);
  EXPECT_EQ(guard.next(kNaN), 3.0F);
  EXPECT_EQ(guard.next(kInfinity), 3.0F);
  EXPECT_EQ(guard.next(kNaN), 0.5F);
  EXPECT_EQ(guard.next(kNaN), 0.5F);
  EXPECT_EQ(guard.next(4.0F), 4.0F);
  EXPECT_EQ(counts(guard.node)["replaced"], 5U);
  EXPECT_EQ(counts(guard.node)["safe"], 3U);
}

TEST(NanGuard, ReplacesWholeMessages) {
  using Message = Array<float, 2>;
  using Io = NanGuardIo<double, Message>;
  NanGuard<Io> guard;
  guard.reset({});
  Message y{};
  Io::Outputs out{y};
  for (const Message& x : {Message{{1.0F, 2.0F}}, Message{{3.0F, kNaN}}}) {
    guard.callback({0}, {{&x, 1, 1}}, out);
    EXPECT_EQ(y, (Message{{1.0F, 2.0F}}));
  }
}

class FallbackTest : public ::testing::Test {
 protected:
  void SetUp() override { node.reset({}); }
  /// Another message on every input, but for those that are stale.
  float next(float primary, float watched = 0.0F, float fallback = -1.0F) {
    if (!primary_is_stale) ++primary_sent;
    if (!watched_is_stale) ++watched_sent;
    float chosen = 99.0F;
    Io::Outputs out{chosen, active};
    node.callback(
        {0}, {{&primary, primary_sent, 1}, {&fallback, 1, 1}, {&watched, watched_sent, 1}}, out);
    return chosen;
  }
  using Io = FallbackIo<float, float>;
  FallbackController<Io> node;
  Seq primary_sent = 0, watched_sent = 0;
  bool primary_is_stale = false, watched_is_stale = false;
  bool active = false;
};

TEST_F(FallbackTest, NaNChangesAfterTwoAndBackAfterThree) {
  EXPECT_EQ(next(1.0F), 1.0F);
  EXPECT_EQ(next(kNaN), -1.0F) << "NaN is never passed on";
  EXPECT_FALSE(active);
  EXPECT_EQ(next(1.0F), 1.0F);
  EXPECT_EQ(next(kNaN), -1.0F);
  EXPECT_EQ(next(kNaN), -1.0F);
  EXPECT_TRUE(active);
  EXPECT_EQ(next(1.0F), -1.0F);
  EXPECT_EQ(next(1.0F), -1.0F);
  EXPECT_EQ(next(1.0F), 1.0F);
  EXPECT_FALSE(active);
  EXPECT_EQ(counts(node)["fallbacks"], 1U);
  EXPECT_EQ(counts(node)["fallback ticks"], 3U);
  EXPECT_EQ(counts(node)["not finite"], 3U);
}

TEST_F(FallbackTest, RangeHasHysteresis) {
  next(1.0F, 10.0F);
  EXPECT_EQ(next(1.0F, 11.0F), 1.0F);
  EXPECT_EQ(next(1.0F, 11.0F), -1.0F);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(next(1.0F, 9.0F), -1.0F) << "within the margin";
  next(1.0F, 8.0F);
  next(1.0F, 8.0F);
  EXPECT_EQ(next(1.0F, 8.0F), 1.0F);
  EXPECT_EQ(next(1.0F, 9.5F), 1.0F);
  EXPECT_EQ(counts(node)["out of range"], 12U);
}

TEST_F(FallbackTest, StaleInputs) {
  for (bool* stale : {&primary_is_stale, &watched_is_stale}) {
    *stale = true;
    EXPECT_EQ(next(1.0F), 1.0F);
    EXPECT_EQ(next(1.0F), 1.0F) << "two ticks are borne";
    EXPECT_EQ(next(1.0F), 1.0F);
    EXPECT_EQ(next(1.0F), -1.0F) << "two wrong ones";
    *stale = false;
    next(1.0F);
    next(1.0F);
    EXPECT_EQ(next(1.0F), 1.0F);
  }
  EXPECT_EQ(counts(node)["stale"], 4U);
}

TEST_F(FallbackTest, SafeIfBothAreBad) {
  EXPECT_EQ(next(kNaN, 0.0F, kNaN), 0.5F);
  EXPECT_EQ(counts(node)["safe"], 1U);
}

TEST(FallbackController, UntilTheNextEpisode) {
  using Io = PlainFallbackIo<double, Array<float, 1>>;
  FallbackController<Io> node;
  for (int episode = 0; episode < 2; ++episode) {
    node.reset({});
    const Array<float, 1> good{{1.0F}}, bad{{kNaN}}, fallback{{-1.0F}};
    Array<float, 1> chosen{};
    Io::Outputs out{chosen};
    node.callback({0}, {{&good, 1, 1}, {&fallback, 1, 1}}, out);
    EXPECT_EQ(chosen[0], 1.0F);
    node.callback({1}, {{&bad, 2, 1}, {&fallback, 2, 1}}, out);
    for (Seq tick = 2; tick < 100; ++tick) {
      node.callback({tick}, {{&good, tick + 1, 1}, {&fallback, tick + 1, 1}}, out);
      EXPECT_EQ(chosen[0], -1.0F);
    }
  }
}

template <class Io>
struct Pid {
  PidController<Io> node;
  Pid() { node.reset({}); }
  float next(float measured) {
    Array<float, 1> u{};
    typename Io::Outputs out{u};
    node.callback({0}, {{&measured, 1, 1}}, out);
    return u[0];
  }
};

TEST(PidController, ProportionalWithinLimits) {
  Pid<PidIo<float>> pid;
  EXPECT_EQ(pid.next(0.5F), -1.0F);
  EXPECT_EQ(pid.next(-7.0F), 4.0F);
  EXPECT_EQ(pid.next(kNaN), 0.0F);
}

struct IntegralConfig : PidConfig {
  static constexpr double kp = 0.0;
  static constexpr double ki = 10.0;
  static constexpr double setpoint = 1.0;
};
TEST(PidController, TheIntegralStopsAtTheLimit) {
  Pid<PidIo<double, IntegralConfig>> pid;
  EXPECT_FLOAT_EQ(pid.next(0.0F), 1.0F);
  EXPECT_FLOAT_EQ(pid.next(0.0F), 2.0F);
  for (int i = 0; i < 100; ++i) EXPECT_LE(pid.next(0.0F), 4.0F);
  EXPECT_FLOAT_EQ(pid.next(2.0F), 3.0F) << "at once";
}

struct AngleConfig : PidConfig {
  static constexpr double kd = 0.1;
  static constexpr double turn = 2.0 * std::numbers::pi;
};
TEST(PidController, AnglesByWholeTurnsAndTheDerivativeOfWhatIsMeasured) {
  Pid<PidIo<double, AngleConfig>> pid;
  EXPECT_NEAR(pid.next(static_cast<float>(2.0 * std::numbers::pi + 0.1)), -0.2F, 1e-6);
  EXPECT_NEAR(pid.next(0.1F), -0.2F, 1e-6) << "no jump at a turn";
  EXPECT_NEAR(pid.next(0.2F), -0.4F - 0.1F, 1e-6) << "0.1 in 0.1 s";
}

TEST(PidController, StateFeedback) {
  using Io = StateFeedbackIo<float, AngleConfig>;
  PidController<Io> node;
  node.reset({});
  const float angle = 0.5F;
  const Array<float, 1> speed{{2.0F}}, bad{{kNaN}};
  Array<float, 1> u{};
  Io::Outputs out{u};
  node.callback({0}, {{&angle, 1, 1}, {&speed, 1, 1}}, out);
  EXPECT_FLOAT_EQ(u[0], -1.2F);
  node.callback({0}, {{&angle, 1, 1}, {&bad, 1, 1}}, out);
  EXPECT_EQ(u[0], 0.0F);
}

}  // namespace
}  // namespace eagerx::models::testing
