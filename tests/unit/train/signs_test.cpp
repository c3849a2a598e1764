// Diagnoses of trainings from synthetic curves and evaluations.
#include "targets/environments/train/signs.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace eagerx::train {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

class TrainSigns : public testing::Test {
 protected:
  TrainSigns() {
    description_.terms = {"angle", "effort"};
    description_.has_success = true;
    description_.observations = {{"angle", "float32", 2, {}, {}}, {"speed", "float32", 1, {}, {}}};
    evaluation_.terms = {-3.0, -1.0};
    evaluation_.far = {0.0, 0.0, 0.0};
    for (int i = 1; i <= 40; ++i) add(i, -100.0 + 2.0 * i, i > 20 ? 0.1 : 0.0);
  }

  void add(int iteration, double value, double success) {
    curve_.push_back({8192.0 * iteration, value, success, iteration % 2 == 0 ? value : kNothing,
                      iteration % 2 == 0 ? success : kNothing, 1.0, 1e-3, 0.01});
  }
  std::vector<std::string> signs() const { return signs_of(curve_, evaluation_, description_); }

  std::vector<CurvePoint> curve_;
  Evaluation evaluation_;
  Description description_;
};

using Signs = std::vector<std::string>;

TEST_F(TrainSigns, NoneOfATrainingThatGoesWell) {
  EXPECT_EQ(signs(), Signs());
}

TEST_F(TrainSigns, NoneOfOneThatHasJustBegun) {
  curve_.clear();
  EXPECT_EQ(signs(), Signs{"no episode has succeeded yet: `success:` may be out of reach, or "
                           "episodes too short"});
}

TEST_F(TrainSigns, NoSuccess) {
  for (CurvePoint& point : curve_) point.success = point.evaluation_success = 0.0;
  ASSERT_EQ(signs().size(), 1);
  EXPECT_TRUE(signs().front().starts_with("no episode has succeeded yet"));
  description_.has_success = false;
  EXPECT_EQ(signs(), Signs());
}

TEST_F(TrainSigns, AFlatReturn) {
  for (std::size_t i = 20; i < curve_.size(); ++i) {
    double& value = curve_[i].evaluation_return;
    if (value == value) value = -60.0;
  }
  EXPECT_EQ(signs(), Signs{"the return has stayed at -60 since 164,000 steps"});
}

TEST_F(TrainSigns, AReturnThatRisesWhileSuccessFalls) {
  curve_[20].evaluation_success = curve_[21].evaluation_success = 0.96;
  for (int i = 41; i <= 46; ++i) add(i, -100.0 + 2.0 * i, 0.04);
  EXPECT_EQ(signs(), Signs{"success has fallen from 96 to 4 % of the episodes while the return has "
                           "risen from -56 to -8: the reward wants something else than "
                           "`success:`"});
  curve_.back().evaluation_return = -57.0;
  EXPECT_EQ(signs(), Signs()) << "it has not risen";
}

TEST_F(TrainSigns, EndsThatAreWorthMoreThanGoingOn) {
  description_.episode_steps = 200;
  evaluation_.mean_return = -67.0;
  evaluation_.mean_steps = 42.25;
  evaluation_.outcomes.assign(20, {1, 0, 42, -67.0, false});
  evaluation_.outcomes.front().steps = 200;
  EXPECT_EQ(signs(), Signs{"19 of 20 episodes end early, on average after 42.25 of 200 steps, and "
                           "the return is below 0: if each step costs and an end does not, ending "
                           "is learnt. A term that is below 0 where `terminated:` holds makes ends "
                           "costly"});
  evaluation_.mean_return = 67.0;
  EXPECT_EQ(signs(), Signs());
}

TEST_F(TrainSigns, NoneOfEndsThatSucceedOrAreFew) {
  description_.episode_steps = 200;
  evaluation_.mean_return = -67.0;
  evaluation_.outcomes.assign(20, {1, 0, 42, -67.0, true});
  EXPECT_EQ(signs(), Signs());
  evaluation_.outcomes.assign(20, {1, 0, 200, -67.0, false});
  for (std::size_t i = 0; i < 17; ++i) evaluation_.outcomes[i].steps = 42;
  EXPECT_EQ(signs(), Signs());
  description_.episode_steps = 0;
  for (Outcome& each : evaluation_.outcomes) each.steps = 42;
  EXPECT_EQ(signs(), Signs()) << "nothing else ends them";
}

TEST_F(TrainSigns, ActionsAtTheirBounds) {
  evaluation_.saturated = 0.97;
  EXPECT_EQ(signs(), Signs{"97 % of the actions are at their bounds"});
}

TEST_F(TrainSigns, AnObservationFarFromItsMean) {
  evaluation_.far = {0.0, 0.3, 0.0};
  EXPECT_EQ(signs(), Signs{"`angle[1]` is more than 8 deviations from its mean in 30 % of the "
                           "steps"});
}

TEST_F(TrainSigns, ATermThatIsNearlyAll) {
  evaluation_.terms = {-0.1, 90.0};
  EXPECT_EQ(signs(), Signs{"`effort` is 100 % of the reward: the other terms hardly count"});
}

}  // namespace
}  // namespace eagerx::train
