// Nodes of walking robots: commands, pushes, motion of the trunk, errors of the speed.
#include <gtest/gtest.h>

#include <cmath>
#include <models/nodes/body_motion/body_motion.hpp>
#include <models/nodes/pushes/pushes.hpp>
#include <models/nodes/speed_errors/speed_errors.hpp>
#include <models/nodes/walking_commands/walking_commands.hpp>
#include <vector>

#include "tests/unit/models/walking_io.hpp"

namespace eagerx::models::testing {
namespace {

using Three = Array<float, 3>;

/// A window with one message.
template <class Message>
Skipped<Message> window(const Message& message) {
  return {&message, 1, 1};
}

TEST(WalkingCommands, FollowEachOtherAndMayBeToStand) {
  using Io = WalkingCommandsIo<float>;
  WalkingCommands<Io> node;
  node.reset({.speeds = {{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
              .durations = {{0.2F, 0.3F, 0.1F, 1.0F}},
              .stand = {{0.5F, 0.05F, 0.1F, 0.2F}}});
  std::vector<float> forward, turn;
  for (Seq i = 0; i < 8; ++i) {
    Three command;
    typename Io::Outputs out{command};
    node.callback({i}, {}, out);
    forward.push_back(command[0]);
    turn.push_back(command[2]);
  }
  EXPECT_EQ(forward, (std::vector<float>{1, 1, 0, 0, 0, 7, 10, 10}));
  EXPECT_EQ(turn, (std::vector<float>{3, 3, 0, 0, 0, 9, 12, 12}));
}

TEST(Pushes, LastForTheirDurationAfterEachWait) {
  using Io = PushesIo<float>;
  Pushes<Io> node;
  node.reset({.impulses = {{1, -2, 3, 4, 5, 6}}, .waits = {{0.25F, 0.4F, 9.0F}}});
  std::vector<float> x, y;
  for (Seq i = 0; i < 10; ++i) {
    Three force;
    typename Io::Outputs out{force};
    node.callback({i}, {}, out);
    x.push_back(force[0]);
    y.push_back(force[1]);
    EXPECT_EQ(force[2], 0.0F);
  }
  EXPECT_EQ(x, (std::vector<float>{0, 0, 0, 5, 5, 0, 0, 15, 15, 0})) << "impulse / duration";
  EXPECT_EQ(y, (std::vector<float>{0, 0, 0, -10, -10, 0, 0, 20, 20, 0}));
}

TEST(BodyMotion, IsInTheAxesOfTheBody) {
  using Io = BodyMotionIo<double>;
  BodyMotion<Io> node;
  node.reset({});
  // Turned to the left by 90 degrees, then nose down by 30: forward is y, tilted below the horizon.
  const double yaw = 0.25 * 3.141592653589793, pitch = 3.141592653589793 / 12.0;
  const Array<float, 7> pose{{0, 0, 1, static_cast<float>(std::cos(yaw) * std::cos(pitch)),
                              static_cast<float>(-std::sin(yaw) * std::sin(pitch)),
                              static_cast<float>(std::cos(yaw) * std::sin(pitch)),
                              static_cast<float>(std::sin(yaw) * std::cos(pitch))}};
  const Array<float, 6> twist{{0, 2, 0, 0, 0, 1}};
  Three velocity, spin, gravity;
  typename Io::Outputs out{velocity, spin, gravity};
  node.callback({0}, {window(pose), window(twist)}, out);
  const double s = 0.5, c = std::sqrt(0.75);
  const double expected[3][3] = {{2 * c, 0, 2 * s}, {-s, 0, c}, {s, 0, -c}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(velocity[i], expected[0][i], 1e-6) << i;
    EXPECT_NEAR(spin[i], expected[1][i], 1e-6) << i;
    EXPECT_NEAR(gravity[i], expected[2][i], 1e-6) << i;
  }
}

TEST(SpeedErrors, AverageOverWindowsWithoutANewCommand) {
  using Io = SpeedErrorsIo<float>;
  SpeedErrors<Io> node;
  node.reset({});
  float speed = 0, turn = 0, instant = 0;
  const auto tick = [&](float forward, float spin, float wanted) {
    const Three velocity{{forward, 0, 0}}, turning{{9, 9, spin}}, command{{wanted, 0, 0}};
    typename Io::Outputs out{speed, turn, instant};
    node.callback({0}, {window(velocity), window(turning), window(command)}, out);
  };
  tick(5, 0, 1);  // nothing was commanded before
  EXPECT_EQ(speed, 0.0F);
  EXPECT_EQ(instant, 0.0F);
  for (const float v : {0.5F, 1.0F, 2.1F}) tick(v, 0.3F, 1);  // mean 1.2 instead of 1
  EXPECT_NEAR(speed, 0.2F, 1e-6F);
  EXPECT_NEAR(turn, 0.3F, 1e-6F);
  EXPECT_NEAR(instant, (0.5F + 0.0F + 1.1F) / 3.0F, 1e-6F);
  tick(1, 0, 1);
  tick(1, 0, 2);  // a new command: this window does not count
  for (int i = 0; i < 3; ++i) tick(1.6F, -0.1F, 2);
  EXPECT_NEAR(speed, (0.2F + 0.4F) / 2.0F, 1e-6F);
  EXPECT_NEAR(turn, (0.3F + 0.1F) / 2.0F, 1e-6F);
}

}  // namespace
}  // namespace eagerx::models::testing
