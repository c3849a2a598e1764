// The trained network is the deployed one: compares the trainer's networks with the generator's,
// which has the bits of programs on Linux and boards.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <tuple>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/policy.hpp"
#include "targets/environments/train/recurrent/states.hpp"

namespace eagerx::train {
namespace {

using Kind = std::tuple<Memory, Activation>;

class TrainOneNetwork : public testing::TestWithParam<Kind> {};

Description description_of(std::size_t inputs, std::size_t outputs) {
  Description result;
  result.graph = "sampled";
  result.hash = "0x0123456789abcdef";
  result.rate_hz = 30.0;
  result.observations = {
      {"x", "float32", inputs, std::vector(inputs, -1.0), std::vector(inputs, 1.0)}};
  result.actions = {
      {"u", "float32", outputs, std::vector(outputs, -2.0), std::vector(outputs, 2.0)}};
  return result;
}

/// Widths that fill panels and registers and such that do not; outputs that are alone.
std::size_t sampled_width(Random& random, float most) {
  return 1 + static_cast<std::size_t>(random.uniform(0.0F, most));
}

std::vector<float> with_biases(std::vector<float> parameters, Random& random) {
  for (float& x : parameters) x += random.normal(0.0F, 0.1F);
  return parameters;
}

std::vector<float> sampled_rows_of(std::size_t inputs, Random& random) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < kLanes * inputs; ++i) rows.push_back(random.normal(0.0F, 3.0F));
  return rows;
}

gen::Network read_back(const Policy& policy, const Description& description) {
  gen::Diagnostics diagnostics;
  const auto network = gen::read_policy_bytes(safetensors_of(policy, description, Settings()),
                                              "p.safetensors", {}, diagnostics);
  EXPECT_TRUE(network);
  return network.value();
}

/// Steps of an episode, so that memories remember.
void expect_the_same(const Policy& policy, const gen::Network& deployed, const Kernels& kernels,
                     Random random) {
  constexpr std::size_t kSteps = 3;
  const std::size_t inputs = policy.network.inputs();
  Simds row(policy.network.row());
  std::vector<gen::Memory<float>> memories(kLanes);
  for (std::size_t step = 0; step < kSteps; ++step) {
    const std::vector<float> rows = sampled_rows_of(inputs, random);
    policy.answer(kernels, rows.data(), row.data());
    for (std::size_t l = 0; l < kLanes; ++l) {
      const auto first = rows.begin() + static_cast<std::ptrdiff_t>(l * inputs);
      const auto answer = gen::evaluate(
          deployed, {first, first + static_cast<std::ptrdiff_t>(inputs)}, &memories[l]);
      ASSERT_EQ(answer.size(), policy.network.outputs());
      for (std::size_t k = 0; k < answer.size(); ++k) {
        const float trained = row[policy.network.output() + k].lane[l];
        ASSERT_EQ(std::bit_cast<std::uint32_t>(trained), std::bit_cast<std::uint32_t>(answer[k]))
            << kernels.name << " step " << step << " lane " << l << " output " << k << " of "
            << answer.size() << ": " << trained << " " << answer[k];
      }
    }
  }
}

TEST_P(TrainOneNetwork, HasTheBitsOfPrograms) {
  const auto [memory, activation] = GetParam();
  Random random({11, 0, 0}, 1);
  for (int network = 0; network < 40; ++network) {
    const std::size_t inputs = sampled_width(random, 40.0F), outputs = sampled_width(random, 18.0F);
    std::vector<std::size_t> layers(sampled_width(random, 3.0F));
    for (std::size_t& width : layers) width = sampled_width(random, 40.0F);
    const CellShape cell{memory, memory == Memory::none ? 0 : sampled_width(random, 20.0F)};
    const Network shape(inputs, layers, outputs, activation, cell);
    const Description description = description_of(inputs, outputs);
    const Policy policy{shape, with_biases(shape.sampled(random, 1.0F), random), Head(description)};
    const gen::Network deployed = read_back(policy, description);
    for (const Kernels* kernels : kernels_here())
      ASSERT_NO_FATAL_FAILURE(expect_the_same(policy, deployed, *kernels, random)) << network;
  }
}

INSTANTIATE_TEST_SUITE_P(All, TrainOneNetwork,
                         testing::Combine(testing::Values(Memory::none, Memory::gru, Memory::lstm),
                                          testing::Values(Activation::tanh, Activation::relu)));

}  // namespace
}  // namespace eagerx::train
