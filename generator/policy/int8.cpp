#include "generator/policy/int8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <eagerx/policy/int8.hpp>
#include <limits>

#include "generator/policy/cost.hpp"

namespace eagerx::gen {
namespace {

constexpr double kMost = 127.0;

void round_layer(DenseLayer& layer) {
  if (!layer.is_dense()) return;
  layer.scales.assign(layer.outputs, 0.0F);
  layer.rounded.assign(layer.weights.size(), 0);
  for (std::size_t out = 0; out < layer.outputs; ++out) {
    const float* weights = layer.weights.data() + out * layer.inputs;
    float largest = 0.0F;
    for (std::size_t i = 0; i < layer.inputs; ++i)
      largest = std::max(largest, std::fabs(weights[i]));
    const auto scale = static_cast<float>(static_cast<double>(largest) / kMost);
    layer.scales[out] = scale;
    if (scale == 0.0F) continue;
    for (std::size_t i = 0; i < layer.inputs; ++i) {
      const double ratio = static_cast<double>(weights[i]) / static_cast<double>(scale);
      layer.rounded[out * layer.inputs + i] =
          static_cast<std::int8_t>(std::clamp(std::nearbyint(ratio), -kMost, kMost));
    }
  }
}

/// Inputs of the network: the observations of golden rows, or drawn ones.
std::vector<std::vector<float>> inputs_of(const Network& network, const GoldenRows* rows) {
  std::vector<std::vector<float>> inputs;
  if (rows != nullptr) {
    const bool elsewhere = !network.normalization && !rows->normalized.empty();
    for (const auto& row : elsewhere ? rows->normalized : rows->observations) {
      std::vector<float> input(row.size());
      std::transform(row.begin(), row.end(), input.begin(),
                     [](double value) { return static_cast<float>(value); });
      inputs.push_back(elsewhere ? std::move(input) : normalized(network, std::move(input)));
    }
    return inputs;
  }
  constexpr std::size_t kRows = 256;
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < kRows; ++i) {
    inputs.emplace_back(network.inputs());
    for (float& value : inputs.back()) {
      state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator
      value = static_cast<float>(state >> 16U) * 0x1p-15F - 1.0F;
    }
  }
  return inputs;
}

}  // namespace

Network with_int8_weights(Network network) {
  for (DenseLayer& layer : network.layers) round_layer(layer);
  return network;
}

std::vector<float> int8_product(const DenseLayer& layer, const std::vector<float>& x) {
  namespace policy = eagerx::policy;
  std::vector<std::int16_t> q(policy::int8_row(layer.inputs));
  const float step = policy::round_inputs(x.data(), layer.inputs, q.data());
  std::vector<float> y(layer.outputs);
  for (std::size_t out = 0; out < y.size(); ++out) {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < layer.inputs; ++i) {
      sum += std::int32_t{layer.rounded[out * layer.inputs + i]} * std::int32_t{q[i]};
    }
    y[out] = policy::int8_output(layer.bias[out], layer.scales[out], step, sum);
  }
  return y;
}

std::vector<int> int8_stored(const DenseLayer& layer) {
  std::vector<int> values(layer.outputs * eagerx::policy::int8_row(layer.inputs));
  for (std::size_t out = 0; out < layer.outputs; ++out) {
    for (std::size_t in = 0; in < layer.inputs; ++in) {
      // NOLINTNEXTLINE(bugprone-signed-char-misuse): a number, no character
      values[eagerx::policy::int8_index(layer.inputs, layer.outputs, out, in)] =
          layer.rounded[out * layer.inputs + in];
    }
  }
  return values;
}

std::size_t int8_bytes(const DenseLayer& layer) {
  if (!layer.is_dense()) return cost_of(layer).bytes;
  const std::size_t norm = layer.norm ? 2 * std::size_t{layer.outputs} * sizeof(float) : 0;
  return norm + layer.outputs * (eagerx::policy::int8_row(layer.inputs) + 2 * sizeof(float));
}

RoundingError rounding_error(const Network& given, const Network& rounded, const GoldenRows* rows) {
  RoundingError error;
  error.golden = rows != nullptr;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::vector<float>& input : inputs_of(given, rows)) {
    const std::vector<float> a = evaluate(given, input);
    const std::vector<float> b = evaluate(rounded, input);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double difference = std::fabs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
      largest = difference <= largest ? largest : difference;
      low = std::min(low, static_cast<double>(a[i]));
      high = std::max(high, static_cast<double>(a[i]));
    }
    error.mean += largest;
    error.largest = largest <= error.largest ? error.largest : largest;
    const auto choice = [](const auto& y) {
      return std::max_element(y.begin(), y.end()) - y.begin();
    };
    if (choice(a) != choice(b)) ++error.choices;
    ++error.rows;
  }
  error.mean /= static_cast<double>(std::max<std::size_t>(error.rows, 1));
  error.range = error.rows == 0 ? 0.0 : high - low;
  if (given.action_kind() != ActionKind::argmax) error.choices = 0;
  return error;
}

std::string to_string(const RoundingError& error) {
  std::string text = fmt::format("mean {:.2g}, largest {:.2g} of a range of {:.2g}, on {} {}",
                                 error.mean, error.largest, error.range, error.rows,
                                 error.golden ? "golden rows" : "drawn rows in -1…1");
  if (error.choices > 0) text += fmt::format("; {} with another choice", error.choices);
  return text;
}

}  // namespace eagerx::gen
