// Compares the results of generated tasks with the same computation in double from the messages of
// the trace and their send times.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <eagerx/random.hpp>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "gym.hpp"
#include "many_rates.hpp"
#include "tutorial.hpp"

namespace {

/// Every message of an episode, by channel.
template <class Graph>
struct Messages {
  std::map<std::string, std::vector<std::vector<double>>> of;

  void on_episode(std::uint32_t /*index*/) { of.clear(); }
  template <class Message>
  void on_message(std::uint32_t channel, eagerx::Seq seq, const Message& message) {
    auto& messages = of[Graph::kChannels[channel].name];
    ASSERT_EQ(messages.size(), seq);
    messages.emplace_back();
    for (std::size_t i = 0; i < eagerx::size_of<Message>; ++i)
      messages.back().push_back(static_cast<double>(eagerx::element(message, i)));
  }
  double at(const char* channel, std::uint64_t seq, std::size_t element = 0) const {
    return of.at(channel).at(seq).at(element);
  }
};

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

/// Runs episodes of at most `steps` steps; `check(program, step, outcome)` after each, and the
/// reset.
template <class Graph, class Program, class Check>
std::vector<std::uint64_t> run(Program& program, std::uint32_t episodes, std::uint64_t steps,
                               Check&& check) {
  std::vector<std::uint64_t> lengths;
  for (std::uint32_t episode = 0; episode < episodes; ++episode) {
    const eagerx::EpisodeKey key{.seed = 3, .environment = 0, .episode = episode};
    program.hooks.on_episode(episode);
    program.reset(Graph::sample(key));
    check(0, program.outcome());
    std::uint64_t step = 0;
    while (step < steps) {
      program.step(Graph::random(key, step));
      const auto outcome = program.outcome();
      check(++step, outcome);
      if (outcome.terminated || outcome.truncated) break;
    }
    lengths.push_back(step);
  }
  return lengths;
}

template <class Outcome>
void expect_nothing(const Outcome& outcome) {
  outcome.for_each(
      [](const char* name, auto value) { EXPECT_EQ(value, decltype(value){}) << name; });
}

TEST(Task, TheCostOfTheTutorials) {
  using Graph = graphs::tutorial::Graph;
  static_assert(Graph::kHasTask && Graph::kEpisodeSteps == 150);
  EXPECT_STREQ(Graph::kTermNames[2], "effort");
  EXPECT_STREQ(Graph::kTerminationNames[0], "spinning");
  EXPECT_STREQ(Graph::kSuccessNames[0], "hanging");
  graphs::tutorial::Program<Messages<Graph>> program;
  const auto& sent = program.hooks;
  int hanging = 0;
  bool succeeded = false, terminated = false;
  const auto lengths = run<Graph>(program, 30, 1000, [&](std::uint64_t n, const auto& outcome) {
    if (n == 0) {
      hanging = 0;
      return expect_nothing(outcome);
    }
    const double th = wrapped(sent.at("pendulum/theta/observation", n));
    const double thdot = sent.at("pendulum/theta_dot/observation", n);
    const double u = sent.at("environment/voltage", n - 1);
    const double reward = -th * th - 0.1 * thdot * thdot - 0.001 * u * u;
    ASSERT_NEAR(outcome.reward, reward, 1e-6 * std::abs(reward) + 1e-6);
    ASSERT_NEAR(outcome.terms[0], -th * th, 2e-5);
    ASSERT_NEAR(outcome.terms[1], -0.1 * thdot * thdot, 1e-5);
    ASSERT_NEAR(outcome.terms[2], -0.001 * u * u, 1e-9);
    ASSERT_EQ(outcome.reward, outcome.terms[0] + outcome.terms[1] + outcome.terms[2]);
    hanging = std::numbers::pi - std::abs(th) < 0.5 ? hanging + 1 : 0;
    ASSERT_EQ(outcome.success, hanging >= 15);
    ASSERT_EQ(outcome.terminated, std::abs(thdot) > 19.0);
    ASSERT_EQ(outcome.truncated, n >= 150);
    succeeded = succeeded || outcome.success;
    terminated = terminated || outcome.terminated;
    ASSERT_EQ(sent.at("task/reward", n), static_cast<double>(outcome.reward));
    ASSERT_EQ(sent.at("task/effort", n), static_cast<double>(outcome.terms[2]));
    ASSERT_EQ(sent.at("task/truncated", n) != 0.0, outcome.truncated);
  });
  EXPECT_TRUE(succeeded);
  EXPECT_TRUE(terminated);
  EXPECT_EQ(*std::ranges::max_element(lengths), 150U);
  EXPECT_LT(*std::ranges::min_element(lengths), 150U);
}

TEST(Task, SeesTheNewestMessagesOfAllRates) {
  using Graph = graphs::many_rates::Graph;
  static_assert(Graph::kEpisodeSteps == 38, "3 s at 12.5 Hz, rounded up");
  graphs::many_rates::Program<Messages<Graph>> program;
  const auto& sent = program.hooks;
  std::array<double, 2> both_before{};
  double u_before = 0.0;
  int done = 0;
  bool succeeded = false;
  run<Graph>(program, 20, 1000, [&](std::uint64_t n, const auto& outcome) {
    // theta, judge: 25 Hz, of the same instant. theta_dot: 5 Hz. smooth: 25 Hz, behind the action.
    const double theta = sent.at("pendulum/theta/observation", 2 * n);
    const std::array<double, 2> both = {std::cos(theta), std::sin(theta)};
    if (n == 0) {
      both_before = both;
      u_before = 0.0;
      done = 0;
      return expect_nothing(outcome);
    }
    const double slow = sent.at("pendulum/theta_dot/observation", 2 * n / 5);
    const double filtered = sent.at("smooth/filtered", 2 * n - 1);
    const double u = sent.at("environment/voltage", n - 1);
    const bool low = sent.at("judge/is_low", 2 * n) != 0.0;
    double worth = -1.0;
    for (std::uint64_t i = 0; i < 4 && i <= 2 * n; ++i)
      worth = std::max(worth, std::cos(sent.at("pendulum/theta/observation", 2 * n - i)));
    const double moved = std::hypot(both[0] - both_before[0], both[1] - both_before[1]);
    const double late = static_cast<double>(n) / 12.5 > 2.05 && !low ? 1.0 : -1.0;
    const std::array<double, 5> terms = {
        1.5 * std::exp(-2.0 * moved * moved), slow * slow * slow / 100.0,
        -0.25 * filtered * (u - u_before), worth,
        late + std::max(both[0], both[1]) - (both[0] + both[1]) / 2.0};
    double reward = 0.0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      ASSERT_NEAR(outcome.terms[i], terms[i], 1e-6 + 1e-6 * std::abs(terms[i])) << i << " at " << n;
      reward += outcome.terms[i];
    }
    ASSERT_EQ(outcome.reward, reward);
    ASSERT_EQ(outcome.terminated, std::abs(slow) > 19.5 && low);
    ASSERT_EQ(outcome.truncated, n >= 38);
    done = low && std::abs(slow) < 15.0 ? done + 1 : 0;
    ASSERT_EQ(outcome.success, done >= 3) << "0.2 s at 12.5 Hz, rounded up";
    succeeded = succeeded || outcome.success;
    both_before = both;
    u_before = u;
  });
  EXPECT_TRUE(succeeded);
}

TEST(Task, TakesTheRewardOfAnEngine) {
  using Graph = graphs::gym::Graph;
  static_assert(Graph::kEpisodeSteps == 0, "the engine says when");
  graphs::gym::Program<Messages<Graph>> program;
  const auto& sent = program.hooks;
  const auto lengths = run<Graph>(program, 2, 1000, [&](std::uint64_t n, const auto& outcome) {
    if (n == 0) return expect_nothing(outcome);
    EXPECT_EQ(outcome.reward, static_cast<float>(sent.at("pendulum/reward/reward", n)));
    EXPECT_LT(outcome.reward, 0.0F);
    EXPECT_FALSE(outcome.terminated);
    // The step's own reward: of the state before it, and of its torque.
    const double th = std::atan2(sent.at("pendulum/observation/observation", n - 1, 1),
                                 sent.at("pendulum/observation/observation", n - 1, 0));
    const double thdot = sent.at("pendulum/observation/observation", n - 1, 2);
    const double u = sent.at("environment/torque", n - 1);
    EXPECT_NEAR(outcome.reward, -(th * th + 0.1 * thdot * thdot + 0.001 * u * u), 1e-4);
  });
  EXPECT_EQ(lengths, std::vector<std::uint64_t>(2, 200));
}

}  // namespace
