#include "targets/environments/train/network.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace eagerx::train {
namespace {

/// Sizes that fill no block and no register.
const Network& odd() {
  static const Network network(3, {21, 17}, 2, Activation::tanh);
  return network;
}

std::vector<float> parameters() {
  std::vector<float> result = odd().sampled(Random({7, 0, 0}, 1), 1.0F);
  Random random({8, 0, 0}, 1);
  for (float& x : result) x += random.normal(0.0F, 0.1F);  // biases are sampled too
  return result;
}

Simds inputs(std::size_t tiles) {
  Random random({9, 0, 0}, 1);
  Simds rows(tiles * odd().row());
  for (std::size_t t = 0; t < tiles; ++t) {
    for (std::size_t i = 0; i < odd().inputs(); ++i) {
      for (float& x : rows[t * odd().row() + i].lane) x = random.normal(0.0F, 1.0F);
    }
  }
  return rows;
}

/// The network in double, one sample at a time.
std::vector<double> in_double(const std::vector<double>& parameters, std::vector<double> x) {
  for (const auto& layer : odd().layers()) {
    std::vector<double> y;
    for (std::size_t j = 0; j < layer.sizes.outputs; ++j) {
      double sum = parameters[layer.bias + j];
      for (std::size_t i = 0; i < x.size(); ++i) {
        sum += parameters[layer.weights + j * x.size() + i] * x[i];
      }
      y.push_back(&layer == &odd().layers().back() ? sum : std::tanh(sum));
    }
    x = y;
  }
  return x;
}

std::vector<double> sample(const Simds& rows, std::size_t tile, std::size_t lane) {
  std::vector<double> x;
  for (std::size_t i = 0; i < odd().inputs(); ++i) {
    x.push_back(rows[tile * odd().row() + i].lane[lane]);
  }
  return x;
}

std::vector<double> to_double(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

TEST(TrainNetwork, ForwardIsTheNetworkInDouble) {
  const std::vector<float> weights = parameters();
  Simds rows = inputs(1);
  odd().forward(*kernels_here().back(), weights.data(), rows.data());
  for (std::size_t l = 0; l < kLanes; ++l) {
    const auto exact = in_double(to_double(weights), sample(rows, 0, l));
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_NEAR(rows[odd().output() + j].lane[l], exact[j], 2e-6);
    }
  }
}

/// Loss: half the squared outputs of all samples, so that an output is its own derivative.
double loss(const std::vector<double>& weights, const Simds& rows, std::size_t tiles) {
  double sum = 0.0;
  for (std::size_t t = 0; t < tiles; ++t) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      for (const double y : in_double(weights, sample(rows, t, l))) sum += 0.5 * y * y;
    }
  }
  return sum;
}

std::vector<float> gradient(const Kernels& kernels, std::size_t tiles) {
  const std::vector<float> weights = parameters();
  Simds rows = inputs(tiles);
  Simds deltas(rows.size());
  Simds scratch(tiles * kLanes);
  for (std::size_t t = 0; t < tiles; ++t) {
    Simd* row = &rows[t * odd().row()];
    odd().forward(kernels, weights.data(), row);
    for (std::size_t j = 0; j < odd().outputs(); ++j) {
      deltas[t * odd().row() + odd().output() + j] = row[odd().output() + j];
    }
  }
  std::vector<float> result(odd().parameters());
  odd().backward(kernels, weights.data(), rows.data(), deltas.data(), tiles, scratch.data(),
                 result.data());
  return result;
}

TEST(TrainNetwork, GradientIsTheDifferenceOfLosses) {
  constexpr std::size_t kTiles = 3;
  constexpr double kStep = 1e-5;
  const std::vector<float> ours = gradient(*kernels_here().back(), kTiles);
  const Simds rows = inputs(kTiles);
  std::vector<double> weights = to_double(parameters());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double before = weights[i];
    weights[i] = before + kStep;
    const double above = loss(weights, rows, kTiles);
    weights[i] = before - kStep;
    const double below = loss(weights, rows, kTiles);
    weights[i] = before;
    const double exact = (above - below) / (2 * kStep);
    EXPECT_NEAR(ours[i], exact, 1e-3 + 1e-4 * std::fabs(exact)) << "parameter " << i;
  }
}

TEST(TrainNetwork, EveryInstructionSetHasTheSameBits) {
  const std::vector<float> plain = gradient(*kernels_here().front(), 5);
  for (const Kernels* kernels : kernels_here()) {
    const std::vector<float> other = gradient(*kernels, 5);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(plain[i]), std::bit_cast<std::uint32_t>(other[i]))
          << kernels->name << ", parameter " << i;
    }
  }
}

TEST(TrainNetwork, AdamFollowsItsFormula) {
  // Against the paper's algorithm in double, three steps of a gradient that changes.
  Adam adam(1);
  std::vector<float> weights = {0.5F};
  double weight = 0.5, mean = 0.0, square = 0.0;
  for (int step = 1; step <= 3; ++step) {
    const float g = 0.3F * static_cast<float>(step) - 0.5F;
    adam.step(*kernels_here().front(), weights, {g}, 0.01F, 2.0F);
    mean = 0.9 * mean + 0.1 * 2.0 * g;
    square = 0.999 * square + 0.001 * 4.0 * g * g;
    weight -= 0.01 * (mean / (1 - std::pow(0.9, step))) /
              (std::sqrt(square / (1 - std::pow(0.999, step))) + 1e-8);
    EXPECT_NEAR(weights[0], weight, 1e-6);
  }
}

}  // namespace
}  // namespace eagerx::train
