// Gym's classic environments against steps that Gymnasium made.
#include <gtest/gtest.h>

#include <models/engines/gym_engine/gym_simulator.hpp>
#include <models/objects/gym_acrobot/gym_acrobot.hpp>
#include <models/objects/gym_cart_pole/gym_cart_pole.hpp>
#include <models/objects/gym_mountain_car/gym_mountain_car.hpp>
#include <models/objects/gym_mountain_car_continuous/gym_mountain_car_continuous.hpp>

#include "tests/unit/models/csv.hpp"
#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {
namespace {

template <class Model>
constexpr const char* kName = "";
template <class Io>
constexpr const char* kName<GymCartPole<Io>> = "CartPole-v1";
template <class Io>
constexpr const char* kName<GymMountainCar<Io>> = "MountainCar-v0";
template <class Io>
constexpr const char* kName<GymMountainCarContinuous<Io>> = "MountainCarContinuous-v0";
template <class Io>
constexpr const char* kName<GymAcrobot<Io>> = "Acrobot-v1";

template <class Model>
class GymClassics : public ::testing::Test {};
using F = PendulumModelIo<float>;
using D = PendulumModelIo<double>;
using Models = ::testing::Types<GymCartPole<F>, GymCartPole<D>, GymMountainCar<F>,
                                GymMountainCar<D>, GymMountainCarContinuous<F>,
                                GymMountainCarContinuous<D>, GymAcrobot<F>, GymAcrobot<D>>;
TYPED_TEST_SUITE(GymClassics, Models);

TYPED_TEST(GymClassics, StepAsGymnasiumDoes) {
  using Real = typename TypeParam::Real;
  constexpr std::size_t kStates = TypeParam::kStates;
  const double tolerance = sizeof(Real) == sizeof(double) ? 1e-11 : 3e-6;
  std::size_t steps = 0, ends = 0;
  for (const Row& row : read_csv("gymnasium.csv")) {
    if (row[0] != kName<TypeParam>) continue;
    ASSERT_EQ(row.size(), 2 * kStates + 4);
    const auto number = [&](std::size_t i) { return std::stod(row[i]); };
    Array<Real, kStates> state{};
    for (std::size_t i = 0; i < kStates; ++i) state[i] = static_cast<Real>(number(1 + i));
    const Array<Real, 1> action{{static_cast<Real>(number(1 + kStates))}};
    const auto outcome = TypeParam::step(state, action, TypeParam::default_attributes());
    for (std::size_t i = 0; i < kStates; ++i) {
      const double expected = number(2 + kStates + i);
      EXPECT_NEAR(static_cast<double>(state[i]), expected, tolerance * (1.0 + std::abs(expected)));
    }
    EXPECT_NEAR(static_cast<double>(outcome.reward), number(2 + 2 * kStates), 100.0 * tolerance);
    EXPECT_EQ(outcome.terminated, row.back() == "1");
    EXPECT_FALSE(outcome.truncated);
    ++steps;
    ends += outcome.terminated ? 1 : 0;
  }
  EXPECT_GE(steps, 20U);
  EXPECT_GE(ends, 1U);
}

/// Gymnasium's TimeLimit of each.
TYPED_TEST(GymClassics, AreTruncatedAtGymnasiumsLimit) {
  const std::string name = kName<TypeParam>;
  const std::uint32_t limit = name == "MountainCar-v0"             ? 200
                              : name == "MountainCarContinuous-v0" ? 999
                                                                   : 500;
  GymSimulator<TypeParam> simulator;
  simulator.reset();
  for (std::uint32_t i = 0; i < limit; ++i) {
    EXPECT_FALSE(simulator.truncated);
    simulator.step();
  }
  EXPECT_TRUE(simulator.truncated);
}

TEST(GymCartPole, IsWorthNothingAfterItsEnd) {
  GymSimulator<GymCartPole<F>> simulator;
  simulator.reset();
  simulator.state = {{2.39F, 1.0F, 0.0F, 0.0F}};
  for (const float worth : {1.0F, 0.0F, 0.0F}) {  // the first step ends it
    simulator.step();
    EXPECT_TRUE(simulator.terminated);
    EXPECT_EQ(simulator.take_reward(), worth);
  }
}

}  // namespace
}  // namespace eagerx::models::testing
