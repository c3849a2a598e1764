#include "generator/policy/network/observations.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr double kDeviations = 2.0;
/// Bounds that are farther apart are none: a space of all numbers.
constexpr double kWidest = 1e3;

enum class Range : std::uint8_t { statistics, bounds, unit };

bool has_bounds(const PolicyContract& contract, std::size_t i) {
  if (i >= contract.observation_low.size() || i >= contract.observation_high.size()) return false;
  const double width = contract.observation_high[i] - contract.observation_low[i];
  return std::isfinite(width) && width > 0.0 && width <= kWidest;
}

Range range_of(const Network& network) {
  if (network.normalization) return Range::statistics;
  for (std::size_t i = 0; i < network.inputs(); ++i) {
    if (has_bounds(network.contract, i)) return Range::bounds;
  }
  return Range::unit;
}

/// `x` in -1…1 as number `i` of an observation.
double placed(const Network& network, Range range, std::size_t i, double x) {
  const std::vector<std::uint32_t>& choices = network.contract.choices;
  if (i < choices.size() && choices[i] > 0) {
    const double choice = std::floor(0.5 * (x + 1.0) * choices[i]);
    return std::min(choice, static_cast<double>(choices[i]) - 1.0);
  }
  if (range == Range::statistics) {
    const Normalization& statistics = *network.normalization;
    const double deviation = std::sqrt(statistics.variance[i] + statistics.epsilon);
    return statistics.mean[i] + kDeviations * deviation * x;
  }
  if (range == Range::bounds && has_bounds(network.contract, i)) {
    const double low = network.contract.observation_low[i];
    const double high = network.contract.observation_high[i];
    return low + 0.5 * (x + 1.0) * (high - low);
  }
  return x;
}

bool is_finite(const std::vector<double>& values) {
  return ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

GoldenRows sampled_observations(const Network& network, const Sampling& sampling) {
  constexpr std::size_t kEpisode = 32;
  const Range range = range_of(network);
  GoldenRows rows;
  for (const std::vector<float>& sampled :
       sampled_rows(sampling.rows, network.inputs(), sampling.seed)) {
    if (network.has_memory()) {
      rows.starts.push_back({rows.observations.size() % kEpisode == 0 ? 1.0 : 0.0});
    }
    std::vector<double>& row = rows.observations.emplace_back(sampled.begin(), sampled.end());
    for (std::size_t i = 0; i < row.size(); ++i) {
      // The network takes float32: what is written is what it was asked.
      row[i] = static_cast<double>(static_cast<float>(placed(network, range, i, row[i])));
    }
  }
  return rows;
}

std::string describe(const Network& network, const Sampling& sampling) {
  const char* where = "in -1…1";
  if (range_of(network) == Range::statistics) where = "within 2 deviations of the statistics";
  if (range_of(network) == Range::bounds) where = "within the bounds of their space";
  return fmt::format("{} sampled, seed {}, {}", sampling.rows, sampling.seed, where);
}

bool check_observations(const Network& network, const GoldenRows& rows, const std::string& name,
                        Diagnostics& diagnostics) {
  const auto misfit = [&](const std::string& how) {
    diagnostics.error("E0632", {}, fmt::format("observations `{}` {}", name, how)).help =
        kGoldenHelp;
    return false;
  };
  if (rows.observations.empty()) return misfit("have no rows");
  const auto wrong = ranges::find_if(
      rows.observations, [&](const auto& row) { return row.size() != network.inputs(); });
  if (wrong != rows.observations.end()) {
    return misfit(fmt::format("have rows of {} numbers, but the policy `{}` takes {}",
                              wrong->size(), network.file, network.inputs()));
  }
  const std::size_t count = rows.observations.size();
  if (!all_of_width(rows.starts, count, 1)) {
    return misfit("do not have one `episode_start` for each row");
  }
  if (!all_of_width(rows.normalized, count, network.inputs())) {
    return misfit("have different numbers of normalised observations and observations");
  }
  if (!network.has_memory() || !rows.starts.empty()) return true;
  diagnostics
      .error("E0761", {},
             fmt::format("the policy `{}` remembers, and observations `{}` do not say where "
                         "episodes start",
                         network.file, name))
      .help = "add a column `episode_start`: 1 in the first row of each episode, else 0";
  return false;
}

bool check_work(const Network& network, std::size_t rows, Diagnostics& diagnostics) {
  constexpr double kMostProducts = 2e11;
  constexpr double kMostNumbers = 5e7;  // held at once
  double products = 1.0;
  for (const Layer& layer : network.layers) {
    products += static_cast<double>(cost_of(layer).multiply_adds);
    products += static_cast<double>(layer.outputs);
  }
  const double numbers = static_cast<double>(network.inputs()) + network.outputs();
  const double most = std::floor(std::min(kMostProducts / products, kMostNumbers / numbers));
  if (static_cast<double>(rows) <= std::max(most, 1.0)) return true;
  diagnostics
      .error("E0760", {},
             fmt::format("{} rows are too many for the policy `{}`: it takes {} products a row",
                         rows, network.file, products))
      .help = fmt::format("at most {} rows of it can be answered in one run", std::max(most, 1.0));
  return false;
}

bool add_answers(const Network& network, GoldenRows& rows, Diagnostics& diagnostics) {
  if (network.normalization) rows.normalized.clear();
  rows.outputs.clear();
  rows.outputs_double.clear();
  rows.actions.clear();
  std::vector<std::vector<double>> normalized;
  Memory<double> memory;
  for (std::size_t i = 0; i < rows.observations.size(); ++i) {
    const std::vector<float> input = input_of_row(network, rows, i);
    if (network.normalization) normalized.emplace_back(input.begin(), input.end());
    if (starts_episode(rows, i)) memory.clear();
    const std::vector<double> outputs = evaluate_in_double(network, input, &memory);
    if (!is_finite(outputs)) {
      diagnostics.error("E0759", {},
                        fmt::format("the policy `{}` answers row {} with what is not finite",
                                    network.file, i + 1));
      return false;
    }
    rows.outputs_double.push_back(outputs);
    if (auto action = action_of(network, outputs); action && is_finite(*action)) {
      rows.actions.push_back(std::move(*action));
    }
  }
  // Bounds that are not finite give some actions and not others.
  if (rows.actions.size() != rows.observations.size()) rows.actions.clear();
  if (network.normalization) rows.normalized = std::move(normalized);
  return true;
}

}  // namespace eagerx::gen
