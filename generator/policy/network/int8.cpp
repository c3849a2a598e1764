#include "generator/policy/network/int8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <eagerx/policy/int8.hpp>
#include <limits>

#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"

namespace eagerx::gen {
namespace {

constexpr double kLargestInt8 = 127.0;

/// Rounds weights [scales][…] row by row.
void round_rows(const std::vector<float>& weights, std::size_t rows,
                std::vector<std::int8_t>& rounded, std::vector<float>& scales) {
  const std::size_t columns = weights.size() / rows;
  scales.assign(rows, 0.0F);
  rounded.assign(weights.size(), 0);
  for (std::size_t row = 0; row < rows; ++row) {
    const float* first = weights.data() + row * columns;
    float largest = 0.0F;
    for (std::size_t i = 0; i < columns; ++i) largest = std::max(largest, std::fabs(first[i]));
    const auto scale = static_cast<float>(static_cast<double>(largest) / kLargestInt8);
    scales[row] = scale;
    if (scale == 0.0F) continue;
    for (std::size_t i = 0; i < columns; ++i) {
      const double ratio = static_cast<double>(first[i]) / static_cast<double>(scale);
      rounded[row * columns + i] =
          static_cast<std::int8_t>(std::clamp(std::nearbyint(ratio), -kLargestInt8, kLargestInt8));
    }
  }
}

void round_layer(Layer& layer) {
  if (layer.weights.empty()) return;
  round_rows(layer.weights, layer.bias.size(), layer.rounded, layer.scales);
  if (auto* cell = std::get_if<Recurrence>(&layer.form)) {
    round_rows(cell->hidden_weights, cell->hidden_bias.size(), cell->hidden_rounded,
               cell->hidden_scales);
  }
}

/// Inputs of the network: those of golden rows, or sampled ones.
std::vector<std::vector<float>> inputs_of(const Network& network, const GoldenRows* rows) {
  std::vector<std::vector<float>> inputs;
  for (std::size_t i = 0; rows != nullptr && i < rows->observations.size(); ++i) {
    inputs.push_back(input_of_row(network, *rows, i));
  }
  if (rows != nullptr) return inputs;
  constexpr std::size_t kMostRows = 256;
  constexpr std::size_t kFewRows = 8;
  constexpr std::size_t kWork = 500'000'000;  // products
  std::size_t products = 1;
  for (const Layer& layer : network.layers) products += cost_of(layer).multiply_adds;
  return sampled_rows(std::clamp(kWork / products, kFewRows, kMostRows), network.inputs());
}

/// Whether row `i` begins an episode: as the golden rows say, else every 32 rows.
bool is_first(const GoldenRows* rows, std::size_t i) {
  constexpr std::size_t kEpisode = 32;
  return rows == nullptr ? i % kEpisode == 0 : starts_episode(*rows, i);
}

}  // namespace

Network with_int8_weights(Network network) {
  for (Layer& layer : network.layers) round_layer(layer);
  return network;
}

std::vector<float> int8_product(const Int8Rows& rows, const std::vector<float>& x) {
  namespace policy = eagerx::policy;
  std::vector<std::int16_t> q(policy::int8_row(x.size()));
  const float step = policy::round_inputs(x.data(), x.size(), q.data());
  std::vector<float> y(rows.rows);
  for (std::size_t out = 0; out < y.size(); ++out) {
    std::int32_t sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += std::int32_t{rows.rounded[out * x.size() + i]} * std::int32_t{q[i]};
    }
    y[out] = policy::int8_output(rows.bias[out], rows.scales[out], step, sum);
  }
  return y;
}

std::vector<int> int8_stored(const Layer& layer) {
  std::vector<int> values(layer.outputs * eagerx::policy::int8_row(layer.inputs));
  for (std::size_t out = 0; out < layer.outputs; ++out) {
    for (std::size_t in = 0; in < layer.inputs; ++in) {
      values[eagerx::policy::int8_index(layer.inputs, layer.outputs, out, in)] =
          int{layer.rounded[out * layer.inputs + in]};
    }
  }
  return values;
}

std::size_t int8_bytes(const Layer& layer) {
  if (layer.weights.empty()) return cost_of(layer).bytes;
  const auto bytes = [](const std::vector<float>& weights, std::size_t rows) {
    return rows * (eagerx::policy::int8_row(weights.size() / rows) + 2 * sizeof(float));
  };
  std::size_t sum = layer.norm ? 2 * std::size_t{layer.outputs} * sizeof(float) : 0;
  sum += bytes(layer.weights, layer.bias.size());
  if (const Recurrence* cell = layer.recurrence()) {
    sum += bytes(cell->hidden_weights, cell->hidden_bias.size());
  }
  return sum;
}

RoundingError rounding_error(const Network& given, const Network& rounded, const GoldenRows* rows) {
  RoundingError error;
  error.golden = rows != nullptr;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  Memory<float> memory;  // each network continues from its own
  Memory<float> rounded_memory;
  for (const std::vector<float>& input : inputs_of(given, rows)) {
    if (is_first(rows, error.rows)) {
      memory.clear();
      rounded_memory.clear();
    }
    const std::vector<float> a = evaluate(given, input, &memory);
    const std::vector<float> b = evaluate(rounded, input, &rounded_memory);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double difference = std::fabs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
      largest = difference <= largest ? largest : difference;
      low = std::min(low, static_cast<double>(a[i]));
      high = std::max(high, static_cast<double>(a[i]));
    }
    error.mean += largest;
    error.largest = largest <= error.largest ? error.largest : largest;
    const auto action = [&](const std::vector<float>& y) {
      return action_of(given, {y.begin(), y.end()});
    };
    if (is_choice(given.action_kind()) && action(a) != action(b)) ++error.choices;
    ++error.rows;
  }
  error.mean /= static_cast<double>(std::max<std::size_t>(error.rows, 1));
  error.range = error.rows == 0 ? 0.0 : high - low;
  return error;
}

std::string to_string(const RoundingError& error) {
  std::string text = fmt::format("mean {:.2g}, largest {:.2g} in a range of {:.2g}, on {} {}",
                                 error.mean, error.largest, error.range, error.rows,
                                 error.golden ? "golden rows" : "sampled rows in -1…1");
  if (error.choices > 0) text += fmt::format("; the choice differs in {}", error.choices);
  return text;
}

}  // namespace eagerx::gen
