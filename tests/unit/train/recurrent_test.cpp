// Networks with a memory: against the formulas in double, and against what reads their files.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <eagerx/policy/recurrent.hpp>
#include <fstream>

#include "generator/policy/formats/golden.hpp"
#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/golden.hpp"
#include "targets/environments/train/export.hpp"
#include "targets/environments/train/network.hpp"
#include "targets/environments/train/recurrent/states.hpp"

namespace eagerx::train::recurrent_test {
namespace {

constexpr std::size_t kInputs = 3, kUnits = 5, kOutputs = 2, kSteps = 6;

/// Sizes that fill no block and no register.
class TrainRecurrent : public testing::TestWithParam<Memory> {
 protected:
  const Network network_{kInputs, {7}, kOutputs, Activation::tanh, {GetParam(), kUnits}};
  const Cell& cell_ = *network_.memory();

  std::vector<float> parameters() const {
    std::vector<float> result = network_.sampled(Random({7, 0, 0}, 1), 1.0F);
    Random random({8, 0, 0}, 1);
    for (float& x : result) x += random.normal(0.0F, 0.2F);  // biases are sampled too
    return result;
  }

  /// Rows of a sequence with inputs, and the state that the first one begins with.
  Simds sequence() const {
    Random random({9, 0, 0}, 1);
    Simds rows(kSteps * network_.row());
    const auto sample = [&](Simd& simd) {
      for (float& x : simd.lane) x = random.normal(0.0F, 1.0F);
    };
    for (std::size_t t = 0; t < kSteps; ++t) {
      for (std::size_t i = 0; i < kInputs; ++i) sample(rows[t * network_.row() + i]);
    }
    for (std::size_t i = 0; i < cell_.shape().state(); ++i) sample(rows[cell_.before() + i]);
    return rows;
  }

  /// Episodes end here and there, each lane's elsewhere.
  static Simds continues() {
    Simds result(kSteps);
    for (std::size_t t = 0; t < kSteps; ++t) {
      for (std::size_t l = 0; l < kLanes; ++l)
        result[t].lane[l] = (t + l) % 4 == 0 && l % 5 != 0 ? 0.0F : 1.0F;
    }
    return result;
  }

  void forward(const Kernels& kernels, Simds& rows) const {
    const std::vector<float> weights = parameters();
    const Simds links = continues();
    for (std::size_t t = 0; t < kSteps; ++t) {
      Simd* row = &rows[t * network_.row()];
      if (t > 0) recall(network_, links[t], row - network_.row() + cell_.after(), row);
      network_.forward(kernels, weights.data(), row);
    }
  }

  /// Loss: half the squared outputs of all steps, so that an output is its own derivative.
  std::vector<float> gradient(const Kernels& kernels) const {
    Simds rows = sequence();
    forward(kernels, rows);
    Simds deltas(rows.size());
    for (std::size_t t = 0; t < kSteps; ++t) {
      for (std::size_t j = 0; j < kOutputs; ++j) {
        const std::size_t at = t * network_.row() + network_.output() + j;
        deltas[at] = rows[at];
      }
    }
    Simds scratch(kSteps * kLanes);
    const Simds links = continues();
    std::vector<float> result(network_.parameters());
    network_.backward(kernels, parameters().data(), rows.data(), deltas.data(), kSteps,
                      scratch.data(), result.data(), links.data());
    return result;
  }
};

using Values = std::vector<double>;

/// W x + b in double.
Values product(const Values& weights, const Cell::Product& at, const Values& x) {
  Values y;
  for (std::size_t j = 0; j < at.sizes.outputs; ++j) {
    double sum = weights[at.bias + j];
    for (std::size_t i = 0; i < x.size(); ++i) sum += weights[at.weights + j * x.size() + i] * x[i];
    y.push_back(sum);
  }
  return y;
}

double sigmoid(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

/// One step of the memory in double, after torch's documentation.
void step(const Cell& cell, const Values& weights, const Values& x, Values& h, Values& c) {
  const Values a = product(weights, cell.from_input(), x);
  const Values b = product(weights, cell.from_state(), h);
  const std::size_t n = h.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (cell.shape().memory == Memory::gru) {
      const double reset = sigmoid(a[k] + b[k]), update = sigmoid(a[n + k] + b[n + k]);
      const double candidate = std::tanh(a[2 * n + k] + reset * b[2 * n + k]);
      h[k] = (1.0 - update) * candidate + update * h[k];
    } else {
      c[k] = sigmoid(a[n + k] + b[n + k]) * c[k] +
             sigmoid(a[k] + b[k]) * std::tanh(a[2 * n + k] + b[2 * n + k]);
      h[k] = sigmoid(a[3 * n + k] + b[3 * n + k]) * std::tanh(c[k]);
    }
  }
}

/// Half the squared outputs of a lane, one step after the other.
double loss_of_lane(const Network& network, const Values& weights, const Simds& rows,
                    const Simds& continues, std::size_t lane) {
  const Cell& cell = *network.memory();
  Values h(kUnits), c(kUnits);
  for (std::size_t k = 0; k < kUnits; ++k) {
    h[k] = rows[cell.before() + k].lane[lane];
    if (cell.shape().memory == Memory::lstm) c[k] = rows[cell.before() + kUnits + k].lane[lane];
  }
  double sum = 0.0;
  for (std::size_t t = 0; t < kSteps; ++t) {
    if (t > 0 && continues[t].lane[lane] == 0.0F) h = c = Values(kUnits);
    Values x;
    for (std::size_t i = 0; i < kInputs; ++i) x.push_back(rows[t * network.row() + i].lane[lane]);
    step(cell, weights, x, h, c);
    Values y = h;
    for (const auto& layer : network.layers()) {
      y = product(weights, {layer.sizes, layer.weights, layer.bias}, y);
      if (&layer == &network.layers().back()) break;
      for (double& value : y) value = std::tanh(value);
    }
    for (const double value : y) sum += 0.5 * value * value;
  }
  return sum;
}

double loss(const Network& network, const Values& weights, const Simds& rows,
            const Simds& continues) {
  double sum = 0.0;
  for (std::size_t l = 0; l < kLanes; ++l)
    sum += loss_of_lane(network, weights, rows, continues, l);
  return sum;
}

TEST_P(TrainRecurrent, GradientIsTheDifferenceOfLosses) {
  constexpr double kStep = 1e-5;
  const std::vector<float> ours = gradient(*kernels_here().back());
  const std::vector<float> sampled = parameters();
  Values weights(sampled.begin(), sampled.end());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double before = weights[i];
    weights[i] = before + kStep;
    const double above = loss(network_, weights, sequence(), continues());
    weights[i] = before - kStep;
    const double below = loss(network_, weights, sequence(), continues());
    weights[i] = before;
    const double exact = (above - below) / (2 * kStep);
    EXPECT_NEAR(ours[i], exact, 1e-3 + 1e-4 * std::fabs(exact)) << "parameter " << i;
  }
}

TEST_P(TrainRecurrent, EveryInstructionSetHasTheSameBits) {
  const std::vector<float> plain = gradient(*kernels_here().front());
  for (const Kernels* kernels : kernels_here()) {
    const std::vector<float> other = gradient(*kernels);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(plain[i]), std::bit_cast<std::uint32_t>(other[i]))
          << kernels->name << ", parameter " << i;
    }
  }
}

/// The deployed cell: eagerx::gru or lstm of these weights.
template <class Weights, class Remembered, class Apply>
void expect_as_deployed(const Cell& cell, const std::vector<float>& parameters, const Simds& rows,
                        std::size_t stride, Apply apply) {
  Weights weights{};
  const auto fill = [&](auto& layer, const Cell::Product& product) {
    using Layer = std::remove_reference_t<decltype(layer)>;
    const auto [inputs, outputs] = product.sizes;
    for (std::size_t j = 0; j < outputs; ++j) {
      for (std::size_t i = 0; i < inputs; ++i)
        layer.w[Layer::index(j, i)] = parameters[product.weights + j * inputs + i];
    }
    std::copy_n(&parameters[product.bias], outputs, layer.b);
  };
  fill(weights.input, cell.from_input());
  fill(weights.hidden, cell.from_state());
  Remembered memory{};
  for (std::size_t t = 0; t < kSteps; ++t) {
    float x[kInputs], y[kUnits];
    for (std::size_t i = 0; i < kInputs; ++i) x[i] = rows[t * stride + i].lane[5];
    apply(weights, x, memory, y);
    for (std::size_t k = 0; k < kUnits; ++k)
      EXPECT_EQ(rows[t * stride + cell.after() + k].lane[5], y[k]) << t;
  }
}

// Lane 5 continues through all steps; here it begins with nothing.
TEST_P(TrainRecurrent, IsWhatTheRuntimeComputes) {
  Simds rows = sequence();
  for (std::size_t i = 0; i < cell_.shape().state(); ++i) rows[cell_.before() + i].lane[5] = 0.0F;
  forward(*kernels_here().back(), rows);
  if (GetParam() == Memory::gru) {
    expect_as_deployed<GruWeights<kInputs, kUnits>, GruMemory<kUnits>>(
        cell_, parameters(), rows, network_.row(),
        [](const auto& weights, const auto& x, auto& memory, auto& y) {
          gru(weights, x, memory, y);
        });
  } else {
    expect_as_deployed<LstmWeights<kInputs, kUnits>, LstmMemory<kUnits>>(
        cell_, parameters(), rows, network_.row(),
        [](const auto& weights, const auto& x, auto& memory, auto& y) {
          lstm(weights, x, memory, y);
        });
  }
}

Description description() {
  Description result;
  result.rate_hz = 30.0;
  result.observations = {{"joint", "float32", 3, {-1, -1, -1}, {1, 1, 1}}};
  result.actions = {{"voltage", "float32", 2, {-2, 0}, {2, 10}}};
  return result;
}

/// Observations that are far from 0, so that folding the statistics in matters.
std::vector<float> observations(std::size_t count) {
  Random random({4, 0, 0}, 1);
  std::vector<float> result;
  for (std::size_t i = 0; i < count * kInputs; ++i) result.push_back(random.normal(2.0F, 0.5F));
  return result;
}

Statistics seen() {
  Sums sums(kInputs);
  const std::vector<float> rows = observations(500);
  for (std::size_t i = 0; i < rows.size(); ++i) sums.add(i % kInputs, rows[i]);
  sums.count = 500.0;
  Statistics result(kInputs);
  result.add(sums);
  return result;
}

TEST_P(TrainRecurrent, NormalisationIsFoldedIntoTheMemory) {
  const Kernels& kernels = *kernels_here().back();
  const Policy policy{network_, folded(network_, parameters(), seen()), Head(description())};
  Simds normalised(network_.row()), raw(network_.row());
  const std::vector<float> weights = parameters();
  for (std::size_t t = 0; t < 3; ++t) {
    const std::vector<float> rows = observations(kLanes * (t + 1));
    const float* now = &rows[kLanes * kInputs * t];
    Normaliser(seen()).load(now, normalised.data());
    network_.forward(kernels, weights.data(), normalised.data());
    network_.remember(normalised.data());
    policy.answer(kernels, now, raw.data());
    for (std::size_t j = 0; j < kOutputs; ++j) {
      const std::size_t at = network_.output() + j;
      for (std::size_t l = 0; l < kLanes; ++l)
        EXPECT_NEAR(raw[at].lane[l], std::tanh(normalised[at].lane[l]), 5e-6);
    }
  }
}

TEST_P(TrainRecurrent, TheReaderOfPoliciesGivesTheGoldenAnswers) {
  const Policy ours{network_, folded(network_, parameters(), seen()), Head(description())};
  gen::Diagnostics diagnostics;
  const auto theirs = gen::read_policy_bytes(safetensors_of(ours, description(), Settings()),
                                             "p.safetensors", {}, diagnostics);
  ASSERT_TRUE(theirs) << (diagnostics.all().empty() ? "" : diagnostics.all().front().message);
  EXPECT_TRUE(theirs->has_memory());
  const std::string path = testing::TempDir() + "recurrent_golden.csv";
  const std::string text = golden_rows(ours, *kernels_here().back(), observations(40));
  EXPECT_TRUE(text.starts_with("episode_start,obs0,obs1,obs2,network_out0,"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 41);
  std::ofstream(path) << text;
  const auto golden = gen::read_golden(path, path, {}, diagnostics);
  ASSERT_TRUE(golden);
  ASSERT_EQ(golden->starts.size(), 40U);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(golden->starts[i].front(), i % 16 == 0 ? 1 : 0);
  EXPECT_TRUE(gen::compare(*theirs, *golden, path, {}, diagnostics))
      << diagnostics.all().front().message;
}

INSTANTIATE_TEST_SUITE_P(Both, TrainRecurrent, testing::Values(Memory::gru, Memory::lstm),
                         [](const auto& one) { return one.param == Memory::gru ? "Gru" : "Lstm"; });

}  // namespace
}  // namespace eagerx::train::recurrent_test
