#include "generator/network/golden.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "generator/network/evaluate.hpp"

namespace eagerx::gen {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = std::fabs(a[i] - b[i]);
    largest = difference <= largest ? largest : difference;  // NaN counts as large
  }
  return largest;
}

bool all_of_width(const std::vector<std::vector<double>>& rows, std::size_t count,
                  std::size_t width) {
  return rows.empty() ||
         (rows.size() == count && std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
            return row.size() == width;
          }));
}

/// Whether the rows have the network's sizes; what is wrong otherwise.
std::string misfit(const Network& network, const GoldenRows& rows) {
  const std::size_t count = rows.observations.size();
  if (count == 0) return "has no rows of observations";
  if (!all_of_width(rows.observations, count, network.inputs())) {
    return fmt::format("has rows of {} observations, but the policy takes {}",
                       rows.observations.front().size(), network.inputs());
  }
  if (!all_of_width(rows.normalized, count, network.inputs())) {
    return "has different numbers of normalised observations and observations";
  }
  if (!all_of_width(rows.starts, count, 1)) return "does not have one `episode_start` for each row";
  const bool fits = all_of_width(rows.outputs, count, network.outputs()) &&
                    all_of_width(rows.outputs_double, count, network.outputs());
  if (!fits)
    return fmt::format("does not have as many outputs as the policy ({})", network.outputs());
  const std::size_t actions =
      network.action_kind() == ActionKind::argmax ? 1 : std::size_t{network.outputs()};
  if (!all_of_width(rows.actions, count, actions)) {
    return fmt::format("does not have as many actions as the policy ({})", actions);
  }
  if (rows.outputs.empty() && rows.outputs_double.empty() && rows.actions.empty()) {
    return "has neither outputs nor actions";
  }
  return {};
}

/// Rows of the first episode.
std::size_t first_episode(const GoldenRows& rows) {
  std::size_t count = std::min<std::size_t>(1, rows.observations.size());
  while (count < rows.observations.size() && !starts_episode(rows, count)) ++count;
  return count;
}

std::vector<float> to_float(const std::vector<double>& values) {
  std::vector<float> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(),
                 [](double value) { return static_cast<float>(value); });
  return result;
}

}  // namespace

bool starts_episode(const GoldenRows& rows, std::size_t i) {
  return i == 0 || rows.starts.empty() || rows.starts[i].front() != 0.0;
}

std::vector<float> input_of_row(const Network& network, const GoldenRows& rows, std::size_t i) {
  if (!network.normalization && !rows.normalized.empty()) return to_float(rows.normalized[i]);
  return normalized(network, to_float(rows.observations[i]));
}

std::vector<std::vector<float>> drawn_rows(std::size_t count, std::size_t width) {
  constexpr unsigned kUnused = 16;
  std::vector<std::vector<float>> result(count, std::vector<float>(width));
  std::uint32_t state = 1;
  for (std::vector<float>& row : result) {
    for (float& value : row) {
      state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator
      value = static_cast<float>(state >> kUnused) * 0x1p-15F - 1.0F;
    }
  }
  return result;
}

std::vector<std::vector<float>> self_test_rows(const Network& network, const GoldenRows* rows) {
  constexpr std::size_t kMostBytes = 512;
  constexpr std::size_t kMostRows = 8;
  const std::size_t row = (network.inputs() + network.outputs()) * sizeof(float);
  std::size_t count = std::clamp<std::size_t>(kMostBytes / row, 1, kMostRows);
  std::vector<std::vector<float>> result;
  if (rows != nullptr) {
    const std::size_t there =
        network.has_memory() ? first_episode(*rows) : rows->observations.size();
    count = std::min(count, there);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = network.has_memory() ? i : i * there / count;
      result.push_back(to_float(rows->observations[at]));
    }
    return result;
  }
  return drawn_rows(count, network.inputs());
}

bool check_normalized(const Network& network, const GoldenRows& rows, const std::string& name,
                      Span mention, Diagnostics& diagnostics) {
  constexpr double kRounding = 1e-6;
  if (network.normalization || rows.normalized.empty()) return true;
  if (!misfit(network, rows).empty()) return true;  // compare() says so
  for (std::size_t row = 0; row < rows.normalized.size(); ++row) {
    for (std::size_t i = 0; i < rows.normalized[row].size(); ++i) {
      const double given = rows.observations[row][i];
      const double normalized = rows.normalized[row][i];
      if (std::fabs(given - normalized) <= kRounding * std::max(1.0, std::fabs(given))) continue;
      diagnostics
          .error("E0633", mention,
                 fmt::format("golden rows `{}` were normalised (row {}: obs{} is {:.3g}, nobs{} is "
                             "{:.3g}), but the policy `{}` does not normalise its observations",
                             name, row + 1, i, given, i, normalized, network.file))
          .help =
          "give the statistics as `normalize`; if a node normalises, write its output into the "
          "columns `obs`";
      return false;
    }
  }
  return true;
}

std::optional<GoldenResult> compare(const Network& network, const GoldenRows& rows,
                                    const std::string& name, Span mention,
                                    Diagnostics& diagnostics) {
  if (const std::string how = misfit(network, rows); !how.empty()) {
    diagnostics.error("E0632", mention, fmt::format("golden rows `{}` {}", name, how)).help =
        kGoldenHelp;
    return std::nullopt;
  }
  GoldenResult result;
  result.rows = rows.observations.size();
  double largest_output = 1.0;
  double farthest = 0.0;
  std::size_t farthest_row = 0;
  double largest_action = 1.0;
  Memory<float> memory;
  Memory<double> exact_memory;
  for (std::size_t i = 0; i < result.rows; ++i) {
    const std::vector<float> input = input_of_row(network, rows, i);
    if (starts_episode(rows, i)) {
      memory.clear();
      exact_memory.clear();
    }
    const std::vector<float> outputs = evaluate(network, input, &memory);
    const std::vector<double> ours(outputs.begin(), outputs.end());
    const std::vector<double> exact = evaluate_in_double(network, input, &exact_memory);
    const std::vector<double>& reference =
        rows.outputs_double.empty() ? exact : rows.outputs_double[i];
    const double error = largest_difference(ours, reference);
    if (!(error <= result.ours)) {
      result.ours = error;
      result.worst = i;
    }
    const auto& known = rows.outputs.empty() ? rows.outputs_double : rows.outputs;
    if (!known.empty()) {
      const double difference = largest_difference(ours, known[i]);
      if (!(difference <= farthest)) {
        farthest = difference;
        farthest_row = i;
      }
    }
    if (!rows.outputs.empty()) {
      result.theirs = std::max(result.theirs, largest_difference(rows.outputs[i], exact));
    }
    for (const double value : reference)
      largest_output = std::max(largest_output, std::fabs(value));
    const auto action = action_of(network, outputs);
    if (rows.actions.empty() || !action) continue;
    result.action =
        std::max(result.action.value_or(0.0), largest_difference(*action, rows.actions[i]));
    for (const double value : *action) largest_action = std::max(largest_action, std::fabs(value));
  }
  // A few rows may by luck have no error at all: two roundings are always allowed.
  constexpr double kRounding = 2.4e-7;
  constexpr double kOtherFunction = 1e-4;
  result.limit = std::max(2.0 * result.theirs, kRounding * largest_output);
  result.action_limit = 1e-5 * largest_action;
  if (!(result.theirs <= kOtherFunction * largest_output) ||
      !(result.ours <= kOtherFunction * largest_output) || !result.passed()) {
    diagnostics
        .error(
            "E0633", mention,
            fmt::format(
                "the policy `{}` does not answer the golden rows `{}`: row {} is "
                "{:.2g} off{}",
                network.file, name, farthest_row + 1, farthest,
                result.action ? fmt::format(", and an action is {:.2g} off", *result.action) : ""))
        .help =
        network.normalization || rows.normalized.empty()
            ? network.has_memory() && rows.starts.empty()
                  ? "these rows belong to another policy, or follow one another: add a column "
                    "`episode_start`"
                  : "these rows belong to another policy, or to other statistics"
            : "give the statistics of its observations as `normalize`";
    return std::nullopt;
  }
  return result;
}

}  // namespace eagerx::gen
