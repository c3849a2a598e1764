#include <gtest/gtest.h>

#include <models/engine_nodes/action_applied/action_applied.hpp>
#include <models/engine_nodes/custom_ode_input/custom_ode_input.hpp>
#include <models/engine_nodes/float_output/float_output.hpp>
#include <models/engine_nodes/ode_float_output/ode_float_output.hpp>
#include <models/engine_nodes/ode_input/ode_input.hpp>
#include <models/engine_nodes/ode_output/ode_output.hpp>
#include <models/engine_states/dummy_state/dummy_state.hpp>
#include <models/engine_states/ode_engine_state/ode_engine_state.hpp>
#include <models/engine_states/ode_parameters/ode_parameters.hpp>

#include "tests/unit/models/entity_io.hpp"

namespace eagerx::models::testing {
namespace {

template <class Real>
class EngineNodes : public ::testing::Test {
 protected:
  using Simulator = PendulumSimulator<Real>;
  EngineNodes() { simulator_.reset(); }
  Simulator simulator_;
  std::int64_t tick_ = 0;
};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(EngineNodes, Reals);

TYPED_TEST(EngineNodes, OdeInputSetsTheInputAndTellsIt) {
  using Io = OdeInputIo<PendulumSimulator<TypeParam>, Latest>;
  OdeInput<Io> node;
  node.reset({}, this->simulator_);
  EXPECT_EQ(this->simulator_.input[0], TypeParam(0.25));
  const Voltage action{{1.5F}};
  Voltage applied{};
  typename Io::Outputs out{applied};
  node.callback({0}, {{&this->tick_, 1, 1}, {&action, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(this->simulator_.input[0], TypeParam(1.5));
  EXPECT_EQ(applied, action);
}

TYPED_TEST(EngineNodes, OdeInputAppliesTheDefaultUntilAnActionComes) {
  using Io = OdeInputIo<PendulumSimulator<TypeParam>, Skipped>;
  OdeInput<Io> node;
  const Voltage unused{{1.5F}};
  Voltage applied{};
  typename Io::Outputs out{applied};
  node.callback({0}, {{&this->tick_, 1, 1}, {&unused, 0, 0}}, out, this->simulator_);
  EXPECT_EQ(this->simulator_.input[0], TypeParam(0.25));
  EXPECT_EQ(applied[0], 0.25F);
}

TYPED_TEST(EngineNodes, OdeOutputRoundsTheState) {
  using Io = OdeOutputIo<PendulumSimulator<TypeParam>>;
  OdeOutput<Io> node;
  node.reset({}, this->simulator_);
  this->simulator_.state = {{TypeParam(0.1), TypeParam(-7.3)}};
  TwoFloats observation{};
  typename Io::Outputs out{observation};
  node.callback({0}, {{&this->tick_, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(observation, (TwoFloats{{0.1F, -7.3F}}));
}

TYPED_TEST(EngineNodes, OdeFloatOutputRoundsOneElement) {
  using Io = OdeFloatOutputIo<PendulumSimulator<TypeParam>>;
  OdeFloatOutput<Io> node;
  node.reset({}, this->simulator_);
  this->simulator_.state = {{TypeParam(0.1), TypeParam(-7.3)}};
  float observation = 0.0F;
  typename Io::Outputs out{observation};
  node.callback({0}, {{&this->tick_, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(observation, -7.3F);
}

TYPED_TEST(EngineNodes, FloatOutputPicksAnElement) {
  using Io = FloatOutputIo<PendulumSimulator<TypeParam>, Latest>;
  FloatOutput<Io> node;
  node.reset({}, this->simulator_);
  const TwoFloats array{{3.0F, 4.0F}};
  float observation = 0.0F;
  typename Io::Outputs out{observation};
  node.callback({0}, {{&array, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(observation, 4.0F);
}

TYPED_TEST(EngineNodes, FloatOutputIsZeroUntilAnArrayComes) {
  using Io = FloatOutputIo<PendulumSimulator<TypeParam>, Skipped>;
  FloatOutput<Io> node;
  const TwoFloats unused{{3.0F, 4.0F}};
  float observation = 1.0F;
  typename Io::Outputs out{observation};
  node.callback({0}, {{&unused, 0, 0}}, out, this->simulator_);
  EXPECT_EQ(observation, 0.0F);
}

TYPED_TEST(EngineNodes, ActionAppliedIsZeroFirstAndThenTheLastAction) {
  using Io = ActionAppliedIo<PendulumSimulator<TypeParam>>;
  ActionApplied<Io> node;
  node.reset({}, this->simulator_);
  const Voltage action{{1.5F}};
  Voltage applied{{9.0F}};
  typename Io::Outputs out{applied};
  node.callback({0}, {{&this->tick_, 1, 1}, {&action, 0, 0}}, out, this->simulator_);
  EXPECT_EQ(applied[0], 0.0F);
  node.callback({1}, {{&this->tick_, 1, 1}, {&action, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(applied[0], 1.5F);
}

TYPED_TEST(EngineNodes, OdeEngineStateSetsTheState) {
  OdeEngineState<StateIo<PendulumSimulator<TypeParam>, TwoFloats>>::reset({{1.5F, -2.0F}},
                                                                          this->simulator_);
  EXPECT_EQ(this->simulator_.state[0], TypeParam(1.5));
  EXPECT_EQ(this->simulator_.state[1], TypeParam(-2.0));
}

TYPED_TEST(EngineNodes, OdeParametersSetsTheNamedOnesOnly) {
  const auto before = this->simulator_.parameters;
  OdeParameters<TwoParametersIo<PendulumSimulator<TypeParam>>>::reset({{0.5F, 0.25F}},
                                                                      this->simulator_);
  OdeParameters<OneParameterIo<PendulumSimulator<TypeParam>>>::reset(0.125F, this->simulator_);
  auto expected = before;
  expected[6] = TypeParam(0.5);
  expected[1] = TypeParam(0.25);
  expected[2] = TypeParam(0.125);
  EXPECT_EQ(this->simulator_.parameters, expected);
}

TYPED_TEST(EngineNodes, OdeParametersTakesItsElementsOfAllParameters) {
  using Io = AllParametersIo<PendulumSimulator<TypeParam>>;
  const auto before = this->simulator_.parameters;
  OdeParameters<Io>::reset({{1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F, 8.0F}}, this->simulator_);
  auto expected = before;
  expected[6] = TypeParam(7);
  expected[1] = TypeParam(2);
  EXPECT_EQ(this->simulator_.parameters, expected);
}

TYPED_TEST(EngineNodes, OdeEngineStateForgetsTheStepSize) {
  this->simulator_.step_s = TypeParam(0.01);
  OdeEngineState<StateIo<PendulumSimulator<TypeParam>, TwoFloats>>::reset({{1.5F, -2.0F}},
                                                                          this->simulator_);
  EXPECT_EQ(this->simulator_.step_s, TypeParam(0));
}

TYPED_TEST(EngineNodes, CustomOdeInputPassesItsDelayOn) {
  using Io = CustomOdeInputIo<PendulumSimulator<TypeParam>>;
  CustomOdeInput<Io> node;
  double delay_s = 0.03;
  node.reset({}, {delay_s}, this->simulator_);
  EXPECT_EQ(delay_s, 0.03);
  EXPECT_EQ(this->simulator_.input[0], TypeParam(0.25));
  node.reset({0.0625F}, {delay_s}, this->simulator_);
  EXPECT_EQ(delay_s, 0.0625);
  const Voltage action{{1.5F}};
  Voltage applied{};
  typename Io::Outputs out{applied};
  node.callback({0}, {{&this->tick_, 1, 1}, {&action, 1, 1}}, out, this->simulator_);
  EXPECT_EQ(this->simulator_.input[0], TypeParam(1.5));
  EXPECT_EQ(applied, action);
}

TYPED_TEST(EngineNodes, DummyStateChangesNothing) {
  const auto before = this->simulator_;
  DummyState<StateIo<PendulumSimulator<TypeParam>, float>>::reset(3.0F, this->simulator_);
  EXPECT_EQ(this->simulator_.state, before.state);
  EXPECT_EQ(this->simulator_.input, before.input);
  EXPECT_EQ(this->simulator_.parameters, before.parameters);
}

}  // namespace
}  // namespace eagerx::models::testing
