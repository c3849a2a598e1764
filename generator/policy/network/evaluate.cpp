#include "generator/policy/network/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <eagerx/policy.hpp>
#include <utility>

#include "generator/policy/network/buffers.hpp"
#include "generator/policy/network/evaluate_layer.hpp"
#include "generator/policy/network/sums.hpp"

namespace eagerx::gen {
namespace {

namespace runtime = eagerx;

template <eagerx::Activation A>
void apply_all(std::vector<float>& y, float slope) {
  for (float& value : y) value = runtime::policy::activated<A>(value, slope);
}

/// In the order of Activation, which is the runtime's.
template <std::size_t... Kinds>
constexpr auto activations(std::index_sequence<Kinds...> /*all*/) {
  return std::array{&apply_all<static_cast<runtime::Activation>(Kinds)>...};
}

void activate(Activation activation, float slope, std::vector<float>& y) {
  constexpr auto kKinds = static_cast<std::size_t>(Activation::sigmoid) + 1;
  static_assert(kKinds == static_cast<std::size_t>(runtime::Activation::sigmoid) + 1);
  constexpr auto kAll = activations(std::make_index_sequence<kKinds>());
  kAll.at(static_cast<std::size_t>(activation))(y, slope);
}

double activated(Activation activation, double slope, double x) {
  constexpr double kSqrtTwoOverPi = 0.7978845608028654;
  constexpr double kSoftplusIsX = 20.0;
  switch (activation) {
    case Activation::identity:
      break;
    case Activation::relu:
      return x < 0.0 ? 0.0 : x;
    case Activation::tanh:
      return std::tanh(x);
    case Activation::elu:
      return x < 0.0 ? slope * std::expm1(x) : x;
    case Activation::leaky_relu:
      return x < 0.0 ? slope * x : x;
    case Activation::silu:
      return x / (1.0 + std::exp(-x));
    case Activation::gelu:
      return 0.5 * x * std::erfc(-x * std::sqrt(0.5));
    case Activation::gelu_tanh:
      return 0.5 * x * (1.0 + std::tanh(kSqrtTwoOverPi * (x + 0.044715 * x * x * x)));
    case Activation::softplus:
      return x > kSoftplusIsX ? x : std::log1p(std::exp(x));
    case Activation::sigmoid:
      return 1.0 / (1.0 + std::exp(-x));
  }
  return x;
}

void apply_norm(const LayerNorm& norm, std::vector<float>& y) {
  const auto size = static_cast<float>(y.size());
  const float mean = grouped_sum(0.0F, y.size(), [&](std::size_t i) { return y[i]; }) / size;
  for (float& value : y) value = value - mean;
  const float variance =
      grouped_sum(0.0F, y.size(), [&](std::size_t i) { return y[i] * y[i]; }) / size;
  const float scale = 1.0F / runtime::sqrt(variance + norm.epsilon);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = (y[i] * scale) * norm.gamma[i] + norm.beta[i];
}

void apply_norm(const LayerNorm& norm, std::vector<double>& y) {
  double mean = 0.0;
  double variance = 0.0;
  for (const double value : y) mean += value / static_cast<double>(y.size());
  for (const double value : y) {
    variance += (value - mean) * (value - mean) / static_cast<double>(y.size());
  }
  const double scale = 1.0 / std::sqrt(variance + static_cast<double>(norm.epsilon));
  for (std::size_t i = 0; i < y.size(); ++i) {
    y[i] = (y[i] - mean) * scale * static_cast<double>(norm.gamma[i]) +
           static_cast<double>(norm.beta[i]);
  }
}

}  // namespace

std::vector<float> normalized(const Network& network, std::vector<float> observation) {
  if (!network.normalization) return observation;
  const Normalization& statistics = *network.normalization;
  for (std::size_t i = 0; i < observation.size(); ++i) {
    const double deviation = std::sqrt(statistics.variance[i] + statistics.epsilon);
    const double value = (static_cast<double>(observation[i]) - statistics.mean[i]) / deviation;
    observation[i] = static_cast<float>(runtime::clamp(value, -statistics.clip, statistics.clip));
  }
  return observation;
}

namespace {

/// Calls `step(layer, input, memory)` for each layer; the last result. A result that no later layer
/// takes is dropped at once: together they may be more than a machine holds.
template <class Real, class Step>
std::vector<Real> run_layers(const Network& network, std::vector<Real> input, Memory<Real>* memory,
                             Step&& step) {
  Memory<Real> fresh;
  if (memory == nullptr) memory = &fresh;
  memory->resize(network.layers.size());
  const std::vector<std::size_t> last_uses = last_uses_of(network);
  std::vector<std::vector<Real>> values(network.layers.size() + 1);  // [0]: the observation
  values[0] = std::move(input);
  for (std::size_t i = 0; i < network.layers.size(); ++i) {
    std::vector<Real> x;
    for (const std::int32_t from : network.taken_by(i)) {
      std::vector<Real>& value = values[static_cast<std::size_t>(std::int64_t{from} + 1)];
      x.insert(x.end(), value.begin(), value.end());
    }
    for (const std::int32_t from : network.taken_by(i)) {
      const auto k = static_cast<std::size_t>(std::int64_t{from} + 1);
      if (last_uses[k] == i) std::vector<Real>().swap(values[k]);
    }
    values[i + 1] = step(network.layers[i], x, (*memory)[i]);
  }
  return std::move(values.back());
}

std::vector<float> result_of(const Layer& layer, const std::vector<float>& x,
                             std::vector<float>& remembered) {
  std::vector<float> y = evaluate_layer(layer, x, remembered);
  if (layer.norm) apply_norm(*layer.norm, y);
  activate(layer.activation, layer.slope, y);
  return y;
}

}  // namespace

std::vector<float> evaluate(const Network& network, std::vector<float> input,
                            Memory<float>* memory) {
  return run_layers<float>(network, std::move(input), memory, result_of);
}

std::vector<std::vector<float>> results_of_layers(const Network& network, std::vector<float> input,
                                                  Memory<float>* memory) {
  std::vector<std::vector<float>> results;
  run_layers<float>(network, std::move(input), memory,
                    [&](const Layer& layer, const auto& x, auto& remembered) {
                      results.push_back(result_of(layer, x, remembered));
                      return results.back();
                    });
  return results;
}

std::vector<double> evaluate_in_double(const Network& network, const std::vector<float>& input,
                                       Memory<double>* memory) {
  return run_layers<double>(network, {input.begin(), input.end()}, memory,
                            [](const Layer& layer, const auto& x, auto& remembered) {
                              std::vector<double> y = evaluate_layer(layer, x, remembered);
                              if (layer.norm) apply_norm(*layer.norm, y);
                              for (double& value : y) {
                                value = activated(layer.activation,
                                                  static_cast<double>(layer.slope), value);
                              }
                              return y;
                            });
}

namespace {

/// The index of the largest output of each group.
std::vector<double> choices_among(const Network& network, const std::vector<double>& outputs) {
  std::vector<double> choices;
  auto first = outputs.begin();
  for (const std::uint32_t count : network.groups()) {
    const auto last = first + static_cast<std::ptrdiff_t>(count);
    const std::int64_t lowest = network.contract.first_choice(choices.size());
    choices.push_back(static_cast<double>(lowest + (std::max_element(first, last) - first)));
    first = last;
  }
  return choices;
}

}  // namespace

std::optional<std::vector<double>> action_of(const Network& network,
                                             const std::vector<double>& outputs) {
  if (network.action_kind() == ActionKind::argmax) return choices_among(network, outputs);
  if (network.action_kind() == ActionKind::binary) {
    std::vector<double> bits;
    bits.reserve(outputs.size());
    for (const double output : outputs) bits.push_back(output > 0.0 ? 1.0 : 0.0);
    return bits;
  }
  const std::vector<double>& lows = network.contract.action_low;
  const std::vector<double>& highs = network.contract.action_high;
  const auto usable = [&](const std::vector<double>& bounds) {
    return bounds.size() == 1 || bounds.size() == outputs.size();
  };
  if (!usable(lows) || !usable(highs)) return std::nullopt;
  std::vector<double> action(outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const double low = lows.size() == 1 ? lows[0] : lows[i];
    const double high = highs.size() == 1 ? highs[0] : highs[i];
    const double x = outputs[i];
    action[i] = network.action_kind() == ActionKind::squashed ? low + 0.5 * (x + 1.0) * (high - low)
                                                              : std::clamp(x, low, high);
  }
  return action;
}

}  // namespace eagerx::gen
