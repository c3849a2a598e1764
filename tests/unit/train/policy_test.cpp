#include "targets/environments/train/policy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/golden.hpp"
#include "targets/environments/train/choice.hpp"
#include "targets/environments/train/export.hpp"

namespace eagerx::train {
namespace {

Description description() {
  Description result;
  result.graph = "arm";
  result.hash = "0x0123456789abcdef";
  result.rate_hz = 30.0;
  result.observations = {{"joint", "float32", 2, {-1, -1}, {1, 1}},
                         {"speed", "float32", 1, {-50}, {50}}};
  result.actions = {{"voltage", "float32", 2, {-2, 0}, {2, 10}}};
  return result;
}

/// Observations of different sizes, and one that never changes.
Statistics seen() {
  Sums sums(3);
  Random random({3, 0, 0}, 1);
  for (int i = 0; i < 1000; ++i) {
    sums.add(0, random.normal(0.5, 0.1));
    sums.add(1, 4.0);
    sums.add(2, random.normal(-20.0, 8.0));
  }
  sums.count = 1000.0;
  Statistics result(3);
  result.add(sums);
  return result;
}

std::vector<float> rows() {
  Random random({4, 0, 0}, 1);
  std::vector<float> result;
  for (std::size_t l = 0; l < kLanes; ++l) {
    result.push_back(random.normal(0.5F, 0.1F));
    result.push_back(4.0F);
    result.push_back(random.normal(-20.0F, 8.0F));
  }
  return result;
}

const Network& actor() {
  static const Network network(3, {24, 16}, 2, Activation::tanh);
  return network;
}

Policy policy() {
  return {actor(), folded(actor(), actor().sampled(Random({5, 0, 0}, 1), 1.0F), seen()),
          Head(description())};
}

TEST(TrainStatistics, AreThoseOfAllRows) {
  Statistics parts(1), whole(1);
  Sums all(1);
  for (int part = 0; part < 3; ++part) {
    Sums sums(1);
    for (int i = 0; i < 10; ++i) {
      const double x = 100.0 + part * 7 + i * i;
      sums.add(0, x);
      all.add(0, x);
    }
    sums.count = 10;
    parts.add(sums);
  }
  all.count = 30;
  whole.add(all);
  EXPECT_NEAR(parts.mean[0], all.sum[0] / 30, 1e-9);
  const double variance = all.squares[0] / 30 - std::pow(all.sum[0] / 30, 2);
  EXPECT_NEAR(1 / std::pow(parts.scale(0), 2), variance, 1e-6);
  EXPECT_NEAR(1 / std::pow(whole.scale(0), 2), variance, 1e-6);
}

TEST(TrainPolicy, NormalisationIsFoldedIntoTheFirstLayer) {
  const Kernels& kernels = *kernels_here().back();
  const std::vector<float> trained = actor().sampled(Random({5, 0, 0}, 1), 1.0F);
  Simds normalised(actor().row()), raw(actor().row());
  Normaliser(seen()).load(rows().data(), normalised.data());
  actor().forward(kernels, trained.data(), normalised.data());
  kernels.tanh(&normalised[actor().output()], 2);
  policy().answer(kernels, rows().data(), raw.data());
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      EXPECT_NEAR(raw[actor().output() + j].lane[l], normalised[actor().output() + j].lane[l],
                  2e-6);
    }
  }
}

// On 2276f903 a cart that drifts moves the mean, and the policy with it: it drifts on.
TEST(TrainPolicy, AnswersDoNotMoveWithTheStatistics) {
  const Kernels& kernels = *kernels_here().back();
  Statistics wider = seen();
  Sums more(3);
  for (std::size_t i = 0; i < 3; ++i) more.add(i, 40.0);
  more.count = 1;
  wider.add(more);
  ASSERT_GT(std::abs(wider.mean[0] - seen().mean[0]), 0.001);
  const std::vector<float> before = actor().sampled(Random({5, 0, 0}, 1), 1.0F);
  std::vector<float> after = before;
  keep_answers(actor(), after, seen(), wider);
  EXPECT_NE(after, before);
  const std::vector<float> old = folded(actor(), before, seen());
  const std::vector<float> now = folded(actor(), after, wider);
  const Policy policies[] = {{actor(), old, Head(description())},
                             {actor(), now, Head(description())}};
  Simds rows_of[2] = {Simds(actor().row()), Simds(actor().row())};
  for (int i = 0; i < 2; ++i) policies[i].answer(kernels, rows().data(), rows_of[i].data());
  for (std::size_t j = 0; j < 2; ++j) {
    for (std::size_t l = 0; l < kLanes; ++l)
      EXPECT_NEAR(rows_of[0][actor().output() + j].lane[l],
                  rows_of[1][actor().output() + j].lane[l], 1e-4);
  }
}

// SAC's critics have actions there, which are not normalised.
TEST(TrainPolicy, AnswersStayWithInputsBehindTheObservations) {
  const Kernels& kernels = *kernels_here().back();
  const Network critic(4, {8}, 1, Activation::tanh);
  Statistics wider = seen();
  Sums more(3);
  for (std::size_t i = 0; i < 3; ++i) more.add(i, 40.0);
  more.count = 1;
  wider.add(more);
  const std::vector<float> before = critic.sampled(Random({5, 0, 0}, 1), 1.0F);
  std::vector<float> after = before;
  keep_answers(critic, after, seen(), wider);
  const auto answers = [&](const std::vector<float>& parameters, const Statistics& statistics) {
    Simds row(critic.row());
    Normaliser(statistics).load(rows().data(), row.data());
    for (std::size_t l = 0; l < kLanes; ++l) row[3].lane[l] = 0.1F * static_cast<float>(l);
    critic.forward(kernels, parameters.data(), row.data());
    return row[critic.output()];
  };
  const Simd old = answers(before, seen()), now = answers(after, wider);
  for (std::size_t l = 0; l < kLanes; ++l) EXPECT_NEAR(old.lane[l], now.lane[l], 1e-4);
  EXPECT_NE(before, after);
}

TEST(TrainPolicy, WhatDoesNotChangeIsNotScaled) {
  EXPECT_EQ(seen().scale(1), 1.0);
  EXPECT_NEAR(seen().scale(0), 10.0, 1.0);
}

TEST(TrainPolicy, ActionsStayWithinTheirBounds) {
  const Head head(description());
  EXPECT_EQ(head.scaled(0, -1.0F), -2.0F);
  EXPECT_EQ(head.scaled(1, 0.0F), 5.0F);
  EXPECT_EQ(head.scaled(1, 7.0F), 10.0F);
}

TEST(TrainExport, TheReaderOfPoliciesGivesTheSameAnswers) {
  const Policy ours = policy();
  gen::Diagnostics diagnostics;
  const auto theirs = gen::read_policy_bytes(safetensors_of(ours, description(), Settings()),
                                             "p.safetensors", {}, diagnostics);
  ASSERT_TRUE(theirs) << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  EXPECT_EQ(theirs->action_kind(), gen::ActionKind::squashed);
  EXPECT_EQ(theirs->contract.rate_hz, 30.0);
  ASSERT_EQ(theirs->contract.observations.size(), 2U);
  EXPECT_EQ(theirs->contract.observations[0].name, "joint");
  EXPECT_EQ(theirs->contract.observations[0].size, 2U);
  EXPECT_EQ(theirs->contract.action_low, (std::vector<double>{-2, 0}));
  EXPECT_EQ(theirs->contract.action_high, (std::vector<double>{2, 10}));
  Simds row(actor().row());
  ours.answer(*kernels_here().back(), rows().data(), row.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<float> all = rows();
    const auto answer = gen::evaluate(*theirs, {&all[l * 3], &all[l * 3] + 3});
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_EQ(answer[j], row[actor().output() + j].lane[l]);
    }
  }
}

TEST(TrainExport, GoldenRowsAreAnsweredByThePolicy) {
  const std::string text = golden_rows(policy(), *kernels_here().back(), rows());
  EXPECT_TRUE(text.starts_with("obs0,obs1,obs2,network_out0,network_out1,action0,action1\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 17);
}

/// Three choices that begin with 3.
Description choosing() {
  Description result = description();
  result.actions = {{"gear", "int64", 1, {3}, {5}}};
  return result;
}
Policy choosing_policy() {
  const Network network(3, {24, 16}, 3, Activation::tanh);
  return {network, folded(network, network.sampled(Random({5, 0, 0}, 1), 1.0F), seen()),
          Head(choosing())};
}

TEST(TrainChoice, ProbabilitiesAreThoseOfTheScores) {
  Simd scores[3] = {};
  scores[0].lane[7] = 100.0F;  // only differences count, however large the scores are
  scores[1].lane[7] = 100.0F + std::log(2.0F);
  scores[2].lane[7] = 100.0F + std::log(5.0F);
  const Choice choice(scores, 3, 7);
  const float expected[] = {0.125F, 0.25F, 0.625F};
  float entropy = 0.0F;
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(choice.probability(j), expected[j], 1e-5F);
    EXPECT_NEAR(choice.log_probability(j), std::log(expected[j]), 2e-5F);
    entropy -= expected[j] * std::log(expected[j]);
  }
  EXPECT_NEAR(choice.entropy(), entropy, 1e-4F);
  EXPECT_EQ(choice.at(0.0F), 0U);
  EXPECT_EQ(choice.at(0.12F), 0U);
  EXPECT_EQ(choice.at(0.13F), 1U);
  EXPECT_EQ(choice.at(0.38F), 2U);
  EXPECT_EQ(choice.at(1.0F), 2U);
}

TEST(TrainChoice, TheLargestAnswerIsTakenAndTheFirstOfEqualOnes) {
  const Head head(choosing());
  EXPECT_TRUE(head.chooses);
  EXPECT_EQ(head.outputs, 3U);
  Simd answers[3] = {};
  float action = 0.0F;
  head.act(answers, 2, &action);
  EXPECT_EQ(action, 3.0F);
  answers[1].lane[2] = answers[2].lane[2] = 0.5F;
  head.act(answers, 2, &action);
  EXPECT_EQ(action, 4.0F);
}

TEST(TrainExport, TheReaderOfPoliciesMakesTheSameChoice) {
  const Policy ours = choosing_policy();
  gen::Diagnostics diagnostics;
  const auto theirs = gen::read_policy_bytes(safetensors_of(ours, choosing(), Settings()),
                                             "p.safetensors", {}, diagnostics);
  ASSERT_TRUE(theirs) << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  EXPECT_EQ(theirs->action_kind(), gen::ActionKind::argmax);
  EXPECT_EQ(theirs->contract.first_choice(), 3);
  Simds row(ours.network.row());
  ours.answer(*kernels_here().back(), rows().data(), row.data());
  std::set<float> chosen;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<float> all = rows();
    const auto answer = gen::evaluate(*theirs, {&all[l * 3], &all[l * 3] + 3});
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(answer[j], row[ours.network.output() + j].lane[l], 1e-5);
    float action = 0.0F;
    ours.head.act(&row[ours.network.output()], l, &action);
    EXPECT_EQ(gen::action_of(*theirs, {answer.begin(), answer.end()})->front(), action);
    chosen.insert(action);
  }
  EXPECT_GT(chosen.size(), 1U);
  const std::string golden = golden_rows(ours, *kernels_here().back(), rows());
  EXPECT_TRUE(
      golden.starts_with("obs0,obs1,obs2,network_out0,network_out1,network_out2,action0\n"));
}

/// Two actions: three gears from 3 on, and two numbers of which one has two values and one four.
Description choosing_several() {
  Description result = description();
  result.actions = {{"gear", "int64", 1, {3}, {5}}, {"lights", "int32", 2, {-1, 0}, {0, 3}}};
  return result;
}

TEST(TrainChoice, OfSeveralNumbersEachHasItsOwnScores) {
  const Head head(choosing_several());
  EXPECT_TRUE(head.chooses);
  EXPECT_EQ(head.counts, (std::vector<std::size_t>{3, 2, 4}));
  EXPECT_EQ(head.outputs, 9U);
  Simd answers[9] = {};
  answers[1].lane[2] = answers[4].lane[2] = answers[8].lane[2] = 0.5F;
  float action[3] = {};
  head.act(answers, 2, action);
  EXPECT_EQ(action[0], 4.0F);
  EXPECT_EQ(action[1], 0.0F);
  EXPECT_EQ(action[2], 3.0F);
}

TEST(TrainExport, TheReaderOfPoliciesMakesTheSameChoices) {
  const Network network(3, {24, 16}, 9, Activation::tanh);
  const Policy ours{network, folded(network, network.sampled(Random({5, 0, 0}, 1), 1.0F), seen()),
                    Head(choosing_several())};
  const std::string bytes = safetensors_of(ours, choosing_several(), Settings());
  gen::Diagnostics diagnostics;
  const auto theirs = gen::read_policy_bytes(bytes, "p.safetensors", {}, diagnostics);
  ASSERT_TRUE(theirs) << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  EXPECT_EQ(theirs->contract.groups, (std::vector<std::uint32_t>{3, 2, 4}));
  EXPECT_EQ(theirs->contract.first_choices, (std::vector<std::int64_t>{3, -1, 0}));
  Simds row(ours.network.row());
  ours.answer(*kernels_here().back(), rows().data(), row.data());
  std::set<std::vector<double>> chosen;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const std::vector<float> all = rows();
    const auto answer = gen::evaluate(*theirs, {&all[l * 3], &all[l * 3] + 3});
    float action[3] = {};
    ours.head.act(&row[ours.network.output()], l, action);
    const auto read = *gen::action_of(*theirs, {answer.begin(), answer.end()});
    EXPECT_EQ(read, std::vector<double>(action, action + 3));
    chosen.insert(read);
  }
  EXPECT_GT(chosen.size(), 1U);
  // Counts that the network's outputs do not have.
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {R"("choices":"3, 2, 4")", R"("choices":"3, 2, 5")"},
           {R"("choices":"3, 2, 4")", R"("choices":"3, 2, 0")"},
           {R"("choices":"3, 2, 4")", R"("choices":"3,2.5,4")"},
           {R"("first_choice":"3, -1, 0")", R"("first_choice":"3, -1   ")"}}) {
    std::string wrong = bytes;
    ASSERT_NE(wrong.find(from), std::string::npos) << from;
    ASSERT_EQ(from.size(), to.size());
    wrong.replace(wrong.find(from), from.size(), to);
    gen::Diagnostics problems;
    EXPECT_FALSE(gen::read_policy_bytes(wrong, "p.safetensors", {}, problems)) << to;
    EXPECT_TRUE(problems.has_errors()) << to;
  }
}

TEST(TrainExport, AFirstChoiceThatIsNoWholeNumberIsRefused) {
  std::string bytes = safetensors_of(choosing_policy(), choosing(), Settings());
  const std::string note = R"("first_choice":"3")";
  bytes.replace(bytes.find(note), note.size(), R"("first_choice":"x")");
  gen::Diagnostics diagnostics;
  EXPECT_FALSE(gen::read_policy_bytes(bytes, "p.safetensors", {}, diagnostics));
  ASSERT_FALSE(diagnostics.all().empty());
  EXPECT_EQ(diagnostics.all().front().code, std::string("E0626"));
}

TEST(TrainExport, GoldenRowsAreNextToThePolicy) {
  EXPECT_EQ(golden_path("a/policy.safetensors"), "a/policy.golden.csv");
  EXPECT_EQ(golden_path("policy"), "policy.golden.csv");
}

}  // namespace
}  // namespace eagerx::train
