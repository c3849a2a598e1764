// The graph of operators without any file format: what a front end gives it, and what it gives
// back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "generator/policy/network/graph/ends.hpp"
#include "generator/policy/network/graph/evaluate.hpp"
#include "generator/policy/network/graph/lower.hpp"
#include "generator/policy/network/graph/operators.hpp"

namespace eagerx::gen {
namespace {

using Kind = NetValue::Kind;
using testing::ElementsAre;
using testing::HasSubstr;

/// A policy that is built operator by operator. Its observation has shape [1, inputs].
class Policy {
 public:
  explicit Policy(std::int64_t inputs) : Policy(Dims{1, inputs}) {}
  explicit Policy(const Dims& shape) {
    state.observed = element_count(shape).value_or(0);
    observation.kind = Kind::data;
    observation.shape = shape;
  }

  NetValue constant(const char* name, const Dims& dims, const std::vector<float>& numbers) {
    return constant_value(made_tensor(state.made, name, numbers, dims));
  }
  /// A row of numbers that count up from `first`.
  NetValue counting(const char* name, const Dims& dims, float first) {
    std::vector<float> numbers(static_cast<std::size_t>(element_count(dims).value_or(0)));
    std::iota(numbers.begin(), numbers.end(), first);
    return constant(name, dims, numbers);
  }
  NetValue apply(const char* type, const std::vector<NetValue>& inputs,
                 std::vector<NetAttribute> attributes = {}) {
    const NetNode node{type, "here", {}, "result", 1, std::move(attributes)};
    std::vector<const NetValue*> given;
    given.reserve(inputs.size());
    for (const NetValue& input : inputs) given.push_back(&input);
    return evaluate(NetCall(node, std::move(given), state));
  }
  std::vector<Layer> layers(const NetValue& action) {
    const auto found = action_of(action, "help", problem);
    if (!found) return {};
    std::unordered_set<const NetTensor*> used;
    return make_layers(state.steps, found->step, static_cast<std::uint32_t>(state.observed), used,
                       problem)
        .value_or(std::vector<Layer>());
  }
  std::vector<Layer> lstm() {
    NetValue h;
    h.kind = Kind::state;
    h.shape = Dims{1, 1, 2};
    h.state.name = "h";
    h.slots = 1;
    NetValue c = h;
    c.state.name = "c";
    return layers(apply("LSTM", {observation, counting("w", {1, 8, 1}, 0),
                                 counting("r", {1, 8, 2}, 100), NetValue(), NetValue(), h, c}));
  }

  NetCall::State state;
  NetValue observation;
  PolicyProblem problem;
};

TEST(NetGraph, OperatorsBecomeLayers) {
  Policy policy(2);
  const NetValue product = policy.apply(
      "Gemm",
      {policy.observation, policy.constant("w", {1, 2}, {3, 4}), policy.constant("b", {1}, {5})},
      {{"transB", 1}});
  const auto layers = policy.layers(policy.apply("Tanh", {product}));
  ASSERT_EQ(layers.size(), 1U) << policy.problem.message;
  EXPECT_THAT(layers[0].weights, ElementsAre(3, 4));
  EXPECT_THAT(layers[0].bias, ElementsAre(5));
  EXPECT_EQ(layers[0].activation, Activation::tanh);
}

TEST(NetGraph, GatesAreInTheOrderOfTheFrontEnd) {
  Policy torch(Dims{1, 1, 1});
  torch.state.has_gates_of_onnx = false;
  const auto same = torch.lstm();
  ASSERT_EQ(same.size(), 1U) << torch.problem.message;
  EXPECT_THAT(same[0].weights, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  Policy onnx(Dims{1, 1, 1});
  const auto moved = onnx.lstm();  // i, o, f, c to i, f, c, o
  ASSERT_EQ(moved.size(), 1U) << onnx.problem.message;
  EXPECT_THAT(moved[0].weights, ElementsAre(0, 1, 4, 5, 6, 7, 2, 3));
  EXPECT_EQ(moved[0].recurrence()->hidden_weights.front(), 100);
}

TEST(NetGraph, UnknownOperatorsAreRefusedWithTheirPlace) {
  Policy policy(2);
  EXPECT_TRUE(policy.layers(policy.apply("Fourier", {policy.observation})).empty());
  EXPECT_EQ(policy.problem.code, "E0612");
  EXPECT_THAT(policy.problem.message, HasSubstr("operator `Fourier` (node `here`)"));
  EXPECT_THAT(policy.problem.help, HasSubstr("Abs, Add, And"));
  EXPECT_THAT(policy.problem.help, testing::Not(HasSubstr("Reciprocal"))) << "of constants only";
}

TEST(NetGraph, ConstantsAreCalculated) {
  Policy policy(1);
  const NetValue two = policy.constant("two", {}, {2});
  const NetValue half = policy.apply("Reciprocal", {two});
  ASSERT_EQ(half.kind, Kind::constant);
  EXPECT_EQ(scalar_of(policy.apply("Sub", {half, two})), -1.5F);
  const NetValue sizes = policy.apply("Div", {integers_value({6, 8}), integers_value({2}, {})});
  EXPECT_EQ(integers_of(sizes), (Integers{3, 4}));
  EXPECT_NE(policy.apply("Div", {integers_value({6}), integers_value({0})}).kind, Kind::integers);
}

TEST(NetGraph, StepsOfASequenceAreFollowed) {
  Policy policy(Dims{1, 1, 2});
  policy.state.follows_time = true;
  policy.observation.time = 2;  // the second axis
  EXPECT_EQ(policy.apply("Relu", {policy.observation}).time, 2U);
  EXPECT_EQ(
      policy.apply("Transpose", {policy.observation}, {{"perm", {}, {}, Integers{1, 0, 2}}}).time,
      1U);
  const NetValue mixed = policy.apply("ReduceSum", {policy.observation},
                                      {{"axes", {}, {}, Integers{1}}, {"keepdims", 1}});
  EXPECT_EQ(mixed.kind, Kind::other);
  EXPECT_EQ(mixed.time, 0U);
  EXPECT_EQ(
      policy.apply("Concat", {policy.observation, policy.observation}, {{"axis", 1}}).problem.code,
      "E0613");
}

TEST(NetGraph, OnlyTheWayToTheActionIsRead) {
  Policy policy(1);
  const NetValue bad = policy.constant("bad", {}, {std::numeric_limits<float>::quiet_NaN()});
  const NetValue one = policy.constant("one", {}, {1});
  const NetValue aside = policy.apply("Mul", {policy.observation, bad});
  EXPECT_EQ(policy.layers(policy.apply("Add", {policy.observation, one})).size(), 1U);
  EXPECT_TRUE(policy.layers(aside).empty());
  EXPECT_EQ(policy.problem.code, "E0616");
  EXPECT_TRUE(policy.layers(one).empty());
  EXPECT_EQ(policy.problem.code, "E0620") << "constant";
}

TEST(NetGraph, PartsOfAnObservationComeOneBehindTheOther) {
  NetCall::State state;
  observation_part(state, "first", {1, 2});
  const NetValue second = observation_part(state, "second", {1, 3});
  EXPECT_EQ(state.observed, 5);
  EXPECT_THAT(state.steps.at(static_cast<std::size_t>(second.step)).form<Reorder>()->from,
              ElementsAre(2, 3, 4));
}

TEST(NetGraph, PlacesCountFromBothEnds) {
  EXPECT_EQ(place_in(0, 3), 0);
  EXPECT_EQ(place_in(-1, 3), 2);
  EXPECT_EQ(place_in(-3, 3), 0);
  EXPECT_EQ(place_in(3, 3), std::nullopt);
  EXPECT_EQ(place_in(-4, 3), std::nullopt);
  EXPECT_EQ(place_in(0, 0), std::nullopt);
}

TEST(NetGraph, WhatIsRefusedIsNothingOfAnyKind) {
  PolicyProblem problem;
  const bool truth = refuse(problem, "E0618", "does not fit", "export it again");
  const std::optional<double> number = refuse(problem, "E0618", "does not fit", "export it again");
  const int* place = refuse(problem, "E0618", "does not fit", "export it again");
  EXPECT_FALSE(truth);
  EXPECT_EQ(number, std::nullopt);
  EXPECT_EQ(place, nullptr);
  EXPECT_EQ(problem.code, "E0618");
  EXPECT_EQ(problem.message, "does not fit");
  EXPECT_EQ(problem.help, "export it again");
}

}  // namespace
}  // namespace eagerx::gen
