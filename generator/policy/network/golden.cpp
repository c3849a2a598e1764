#include "generator/policy/network/golden.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "generator/policy/network/evaluate.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// Whether the rows have the network's sizes; what is wrong otherwise.
std::string misfit(const Network& network, const GoldenRows& rows) {
  const std::size_t count = rows.observations.size();
  if (count == 0) return "has no rows of observations";
  if (!all_of_width(rows.observations, count, network.inputs())) {
    return fmt::format("has rows of {}, but the policy takes {}",
                       counted(rows.observations.front().size(), "observation"), network.inputs());
  }
  if (!all_of_width(rows.normalized, count, network.inputs())) {
    return "has different numbers of normalised observations and observations";
  }
  if (!all_of_width(rows.starts, count, 1)) return "does not have one `episode_start` for each row";
  const bool fits = all_of_width(rows.outputs, count, network.outputs()) &&
                    all_of_width(rows.outputs_double, count, network.outputs());
  if (!fits)
    return fmt::format("does not have as many outputs as the policy ({})", network.outputs());
  if (!all_of_width(rows.actions, count, network.actions())) {
    return fmt::format("does not have as many actions as the policy ({})", network.actions());
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

/// Collects errors, which count against what is known when all rows have been seen.
class Judge {
 public:
  explicit Judge(double printed) : printed_(printed) {}

  void learn_ranges(const std::vector<std::vector<double>>& rows) {
    for (const auto& row : rows) {
      lows_.resize(row.size(), std::numeric_limits<double>::infinity());
      highs_.resize(row.size(), -std::numeric_limits<double>::infinity());
      for (std::size_t i = 0; i < row.size(); ++i) {
        lows_[i] = std::min(lows_[i], row[i]);
        highs_[i] = std::max(highs_[i], row[i]);
      }
    }
  }

  /// `known`: nullptr if the file does not say it.
  void add(std::size_t row, const std::vector<double>& ours, const std::vector<double>& exact,
           const std::vector<double>* known) {
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const double our_error = difference(ours[i], exact[i]);
      errors_.ours = std::max(our_error, errors_.ours);
      if (known == nullptr) continue;
      const double their_error = difference((*known)[i], exact[i]);
      errors_.theirs = std::max(their_error, errors_.theirs);
      errors_.off = std::max(difference(ours[i], (*known)[i]), errors_.off);
      const double limit = tolerance(i, exact[i]);
      // The file's answers are of the same function; ours only have to be as near to it.
      keep(their_, row, their_error, limit);
      if (!(our_error <= their_error)) keep(our_, row, our_error, limit);
    }
  }

  /// Of choices: another one is right if its score is as good.
  void add_choices(std::size_t row, const Network& network, const std::vector<double>& ours,
                   const std::vector<double>& scores, const std::vector<double>& known) {
    if (network.action_kind() == ActionKind::binary) return add_bits(row, ours, scores, known);
    const std::vector<std::uint32_t> groups = network.groups();
    std::size_t first = 0;
    for (std::size_t i = 0; i < groups.size(); first += groups[i++]) {
      if (ours[i] == known[i]) continue;
      const auto lowest = static_cast<double>(network.contract.first_choice(i));
      const double index = known[i] - lowest;
      errors_.off = std::max(difference(ours[i], known[i]), errors_.off);
      if (!(index >= 0.0 && index < static_cast<double>(groups[i]))) {
        keep(their_, row, std::numeric_limits<double>::infinity(), kSmallest);
        continue;
      }
      const double best = scores[first + static_cast<std::size_t>(ours[i] - lowest)];
      const double other = scores[first + static_cast<std::size_t>(index)];
      keep(their_, row, std::fabs(best - other), std::max(kOfValue * std::fabs(best), kSmallest));
    }
  }

  GoldenErrors finish() const {
    constexpr double kOfRounding = 100.0;
    const Worst* worst = &their_;
    const double their_limit = std::max(their_.limit, kOfRounding * errors_.ours);
    const double our_limit = std::max(our_.limit, 2.0 * errors_.theirs);
    double limit = their_limit;
    if (our_.error / our_limit > their_.error / their_limit) {
      worst = &our_;
      limit = our_limit;
    }
    GoldenErrors result = errors_;
    result.limit = limit;
    result.worst = worst->row;
    result.excess = worst->error == 0.0 ? 0.0 : worst->error / limit;
    return result;
  }

 private:
  /// A bit may be another one where its score is as good as zero.
  void add_bits(std::size_t row, const std::vector<double>& ours, const std::vector<double>& scores,
                const std::vector<double>& known) {
    double largest = 0.0;
    for (const double score : scores) largest = std::max(largest, std::fabs(score));
    for (std::size_t i = 0; i < scores.size(); ++i) {
      if (ours[i] == known[i]) continue;
      errors_.off = std::max(difference(ours[i], known[i]), errors_.off);
      const bool is_bit = known[i] == 0.0 || known[i] == 1.0;
      keep(their_, row, is_bit ? std::fabs(scores[i]) : std::numeric_limits<double>::infinity(),
           std::max(kOfValue * largest, kSmallest));
    }
  }

  static constexpr double kOfRange = 5e-5;
  static constexpr double kOfValue = 1e-5;
  static constexpr double kSmallest = 1e-6;

  /// The error that is largest relative to its limit.
  struct Worst {
    std::size_t row = 0;
    double error = 0.0, limit = kSmallest;
  };
  static void keep(Worst& worst, std::size_t row, double error, double limit) {
    if (!(error / limit <= worst.error / worst.limit)) worst = {row, error, limit};
  }
  static double difference(double a, double b) {
    return std::isnan(a - b) ? std::numeric_limits<double>::infinity() : std::fabs(a - b);
  }

  double tolerance(std::size_t i, double value) const {
    const double range = i < highs_.size() ? highs_[i] - lows_[i] : 0.0;
    return std::max({kOfRange * range, kOfValue * std::fabs(value), kSmallest, printed_});
  }

  double printed_;
  std::vector<double> lows_, highs_;  // of each answer, over all rows
  GoldenErrors errors_;
  Worst our_, their_;
};

/// E0633, with what may be the reason.
void report_wrong(const Network& network, const GoldenRows& rows, const GoldenResult& result,
                  const std::string& name, Span mention, Diagnostics& diagnostics) {
  const bool by_outputs = result.outputs.excess > 1.0;
  const GoldenErrors& worst = by_outputs ? result.outputs : *result.actions;
  auto& problem = diagnostics.error(
      "E0633", mention,
      fmt::format("the policy `{}` does not answer the golden rows `{}`: row {} is {:.2g} off{}",
                  network.file, name, worst.worst + 1, worst.excess * worst.limit,
                  by_outputs ? "" : " in its action"));
  if (!network.normalization && !rows.normalized.empty()) {
    problem.help = "give the statistics of its observations as `normalize`";
  } else if (network.has_memory() && rows.starts.empty()) {
    problem.help =
        "these rows belong to another policy, or follow one another: add a column `episode_start`";
  } else {
    problem.help = "these rows belong to another policy, or to other statistics";
  }
}

}  // namespace

bool all_of_width(const std::vector<std::vector<double>>& rows, std::size_t count,
                  std::size_t width) {
  return rows.empty() ||
         (rows.size() == count && std::all_of(rows.begin(), rows.end(), [&](const auto& row) {
            return row.size() == width;
          }));
}

bool starts_episode(const GoldenRows& rows, std::size_t i) {
  return i == 0 || rows.starts.empty() || rows.starts[i].front() != 0.0;
}

std::vector<float> input_of_row(const Network& network, const GoldenRows& rows, std::size_t i) {
  if (!network.normalization && !rows.normalized.empty()) return to_float(rows.normalized[i]);
  return normalized(network, to_float(rows.observations[i]));
}

std::vector<std::vector<float>> sampled_rows(std::size_t count, std::size_t width,
                                             std::uint32_t seed) {
  constexpr unsigned kUnused = 16;
  constexpr std::uint32_t kApart = 2654435769U;  // 2^32 over the golden ratio: seeds lie far apart
  std::vector<std::vector<float>> result(count, std::vector<float>(width));
  std::uint32_t state = 1U + (seed - 1U) * kApart;
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
  return sampled_rows(count, network.inputs());
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
  result.has_outputs = !rows.outputs.empty() || !rows.outputs_double.empty();
  const bool chooses = is_choice(network.action_kind());
  Judge outputs(rows.printed);
  Judge actions(rows.printed);
  for (const auto* known : {&rows.outputs, &rows.outputs_double}) outputs.learn_ranges(*known);
  actions.learn_ranges(rows.actions);
  Memory<float> memory;
  Memory<double> exact_memory;
  for (std::size_t i = 0; i < result.rows; ++i) {
    const std::vector<float> input = input_of_row(network, rows, i);
    if (starts_episode(rows, i)) {
      memory.clear();
      exact_memory.clear();
    }
    const std::vector<float> answer = evaluate(network, input, &memory);
    const std::vector<double> ours(answer.begin(), answer.end());
    const std::vector<double> exact = evaluate_in_double(network, input, &exact_memory);
    if (!result.has_outputs) outputs.add(i, ours, exact, nullptr);
    if (!rows.outputs.empty()) outputs.add(i, ours, exact, &rows.outputs[i]);
    if (!rows.outputs_double.empty()) outputs.add(i, ours, exact, &rows.outputs_double[i]);
    if (rows.actions.empty()) continue;
    const auto action = action_of(network, ours);
    const auto exact_action = action_of(network, exact);
    if (!action || !exact_action) continue;
    if (!result.actions) result.actions.emplace();
    if (chooses) {
      actions.add_choices(i, network, *action, exact, rows.actions[i]);
    } else {
      actions.add(i, *action, *exact_action, &rows.actions[i]);
    }
  }
  result.outputs = outputs.finish();
  if (result.actions) result.actions = actions.finish();
  if (!result.passed()) {
    report_wrong(network, rows, result, name, mention, diagnostics);
    return std::nullopt;
  }
  return result;
}

}  // namespace eagerx::gen
