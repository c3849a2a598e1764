#include "generator/policy/network/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "generator/policy/network/limits.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

bool same_form(const Layer& a, const Layer& b) {
  if (a.form.index() != b.form.index()) return false;
  if (const Recurrence* cell = a.recurrence()) return cell->is_lstm == b.recurrence()->is_lstm;
  return std::visit(
      [&](const auto& form) {
        using Form = std::decay_t<decltype(form)>;
        if constexpr (std::is_same_v<Form, Dense> || std::is_same_v<Form, Recurrence>) {
          return true;
        } else {
          return form == std::get<Form>(b.form);
        }
      },
      a.form);
}

bool same_structure(const Network& a, const Network& b, std::size_t i) {
  const Layer& x = a.layers[i];
  const Layer& y = b.layers[i];
  return x.inputs == y.inputs && x.outputs == y.outputs && x.activation == y.activation &&
         x.norm.has_value() == y.norm.has_value() && a.taken_by(i) == b.taken_by(i) &&
         x.weights.size() == y.weights.size() && x.bias.size() == y.bias.size() && same_form(x, y);
}

std::string words_for(const Layer& layer) {
  return fmt::format("{} -> {}{}", layer.inputs, layer.outputs, note_of(layer));
}

/// Weights as they count: those of eight bits times their scales.
double largest_difference(const std::vector<float>& a, const std::vector<std::int8_t>& a_rounded,
                          const std::vector<float>& a_scales, const std::vector<float>& b,
                          const std::vector<std::int8_t>& b_rounded,
                          const std::vector<float>& b_scales) {
  const auto weight = [](const auto& weights, const auto& rounded, const auto& scales,
                         std::size_t i) {
    if (rounded.empty()) return static_cast<double>(weights[i]);
    const std::size_t row = i / (rounded.size() / scales.size());
    return static_cast<double>(rounded[i]) * static_cast<double>(scales[row]);
  };
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(
        largest, std::fabs(weight(a, a_rounded, a_scales, i) - weight(b, b_rounded, b_scales, i)));
  }
  return largest;
}

double largest_difference(const std::vector<float>& a, const std::vector<float>& b) {
  return largest_difference(a, {}, {}, b, {}, {});
}

double difference_of_weights(const Layer& a, const Layer& b) {
  double largest =
      largest_difference(a.weights, a.rounded, a.scales, b.weights, b.rounded, b.scales);
  largest = std::max(largest, largest_difference(a.bias, b.bias));
  largest = std::max(largest, std::fabs(static_cast<double>(a.slope) - b.slope));
  if (a.norm) {
    largest = std::max(largest, largest_difference(a.norm->gamma, b.norm->gamma));
    largest = std::max(largest, largest_difference(a.norm->beta, b.norm->beta));
    largest = std::max(largest, std::fabs(static_cast<double>(a.norm->epsilon) - b.norm->epsilon));
  }
  if (const Recurrence* x = a.recurrence()) {
    const Recurrence* y = b.recurrence();
    largest = std::max(largest,
                       largest_difference(x->hidden_weights, x->hidden_rounded, x->hidden_scales,
                                          y->hidden_weights, y->hidden_rounded, y->hidden_scales));
    largest = std::max(largest, largest_difference(x->hidden_bias, y->hidden_bias));
  }
  return largest;
}

std::string sizes_differ(const Network& a, const Network& b) {
  if (a.inputs() != b.inputs()) {
    return fmt::format("the policy `{}` takes {} numbers, but `{}` takes {}", a.file, a.inputs(),
                       b.file, b.inputs());
  }
  if (a.outputs() == b.outputs()) return {};
  return fmt::format("the policy `{}` gives {} numbers, but `{}` gives {}", a.file, a.outputs(),
                     b.file, b.outputs());
}

/// Goes through the rows with both policies and collects what differs.
class Comparison {
 public:
  Comparison(const Network& a, const Network& b, const GoldenRows& rows)
      : a_(a), b_(b), rows_(rows), lows_(a.outputs(), std::numeric_limits<double>::infinity()) {
    highs_.assign(a.outputs(), -std::numeric_limits<double>::infinity());
    result_.rows = rows.observations.size();
    result_.outputs.resize(a.outputs());
    result_.layers_differ = other_structure(a, b);
    std::int64_t values = 0;
    for (const Layer& layer : a.layers) values += layer.outputs;
    if (result_.layers_differ.empty() && values > kMaxValues) {
      result_.layers_differ = "their results are too many to be held at once";
    }
    if (!result_.layers_differ.empty()) return;
    for (std::size_t i = 0; i < a.layers.size(); ++i) {
      result_.layers.emplace_back().weights = difference_of_weights(a.layers[i], b.layers[i]);
    }
  }

  bool run(Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < result_.rows; ++i) {
      if (starts_episode(rows_, i)) {
        a_memory_.clear();
        b_memory_.clear();
      }
      const std::vector<double> x = answer(a_, a_memory_, i, a_results_);
      const std::vector<double> y = answer(b_, b_memory_, i, b_results_);
      for (const auto& [network, values] : {std::pair{&a_, &x}, std::pair{&b_, &y}}) {
        if (ranges::all_of(*values, [](double value) { return std::isfinite(value); })) {
          continue;
        }
        diagnostics.error("E0759", {},
                          fmt::format("the policy `{}` answers row {} with what is not finite",
                                      network->file, i + 1));
        return false;
      }
      add_outputs(x, y, i);
      add_layers(i);
      add_actions(x, y);
    }
    return true;
  }

  PolicyDifference finish(std::optional<double> tolerance) {
    constexpr double kOfRange = 1e-5;
    const auto count = static_cast<double>(result_.rows);
    double excess = -1.0;
    for (std::size_t i = 0; i < result_.outputs.size(); ++i) {
      OutputDifference& output = result_.outputs[i];
      output.mean /= count;
      output.range = highs_[i] - lows_[i];
      output.allowed = tolerance.value_or(kOfRange * std::max(1.0, output.range));
      // A tolerance of zero is one, too.
      const double own =
          output.largest / std::max(output.allowed, std::numeric_limits<double>::min());
      if (own > excess) result_.worst = i;
      excess = std::max(excess, own);
    }
    for (std::size_t i = 0; i < result_.layers.size(); ++i) {
      result_.layers[i].mean /= count * a_.layers[i].outputs;
    }
    add_worst_row();
    return std::move(result_);
  }

 private:
  std::vector<double> answer(const Network& network, Memory<float>& memory, std::size_t row,
                             std::vector<std::vector<float>>& results) const {
    const std::vector<float> input = input_of_row(network, rows_, row);
    if (result_.layers.empty()) {
      const std::vector<float> outputs = evaluate(network, input, &memory);
      return {outputs.begin(), outputs.end()};
    }
    results = results_of_layers(network, input, &memory);
    return {results.back().begin(), results.back().end()};
  }

  static void add(Difference& difference, double off, std::size_t row) {
    difference.mean += off;
    if (off > difference.largest) difference.row = row;
    difference.largest = std::max(difference.largest, off);
  }

  void add_outputs(const std::vector<double>& x, const std::vector<double>& y, std::size_t row) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      add(result_.outputs[i], std::fabs(x[i] - y[i]), row);
      lows_[i] = std::min(lows_[i], x[i]);
      highs_[i] = std::max(highs_[i], x[i]);
    }
  }

  void add_layers(std::size_t row) {
    for (std::size_t k = 0; k < result_.layers.size(); ++k) {
      for (std::size_t i = 0; i < a_results_[k].size(); ++i) {
        const double off = std::fabs(static_cast<double>(a_results_[k][i]) -
                                     static_cast<double>(b_results_[k][i]));
        add(result_.layers[k], std::isnan(off) ? std::numeric_limits<double>::infinity() : off,
            row);
      }
    }
  }

  void add_actions(const std::vector<double>& x, const std::vector<double>& y) {
    const bool chooses = is_choice(a_.action_kind());
    if (chooses != is_choice(b_.action_kind())) return;
    const auto first = action_of(a_, x);
    const auto second = action_of(b_, y);
    if (!first || !second || first->size() != second->size()) return;
    if (chooses) {
      result_.choices = result_.choices.value_or(0) + (*first != *second ? 1 : 0);
      return;
    }
    double& largest = result_.actions ? *result_.actions : result_.actions.emplace(0.0);
    for (std::size_t i = 0; i < first->size(); ++i) {
      largest = std::max(largest, std::fabs((*first)[i] - (*second)[i]));
    }
  }

  /// The answers of the worst row once more, from the start of its episode.
  void add_worst_row() {
    const std::size_t row = result_.outputs[result_.worst].row;
    std::size_t i = row;
    while (!starts_episode(rows_, i)) --i;
    a_memory_.clear();
    b_memory_.clear();
    for (; i <= row; ++i) {
      result_.first = answer(a_, a_memory_, i, a_results_);
      result_.second = answer(b_, b_memory_, i, b_results_);
    }
    result_.observation = rows_.observations[row];
  }

  const Network& a_;
  const Network& b_;
  const GoldenRows& rows_;
  PolicyDifference result_;
  Memory<float> a_memory_, b_memory_;
  std::vector<std::vector<float>> a_results_, b_results_;  // of the row's layers
  std::vector<double> lows_, highs_;                       // of each output of the first policy
};

}  // namespace

bool PolicyDifference::within() const {
  return ranges::all_of(outputs,
                        [](const auto& output) { return output.largest <= output.allowed; });
}

std::string other_structure(const Network& a, const Network& b) {
  if (a.layers.size() != b.layers.size()) {
    return fmt::format("one has {}, the other {}", counted(a.layers.size(), "layer"),
                       b.layers.size());
  }
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    if (same_structure(a, b, i)) continue;
    const std::string x = words_for(a.layers[i]);
    const std::string y = words_for(b.layers[i]);
    return x == y ? fmt::format("layer {} ({}) is not the same", i + 1, x)
                  : fmt::format("layer {} is {} in one, {} in the other", i + 1, x, y);
  }
  return {};
}

bool check_sizes(const Network& a, const Network& b, Diagnostics& diagnostics) {
  const std::string how = sizes_differ(a, b);
  if (how.empty()) return true;
  diagnostics.error("E0757", {}, how).help =
      "only policies for the same observations and actions can be compared";
  return false;
}

std::optional<PolicyDifference> difference_of(const Network& a, const Network& b,
                                              const GoldenRows& rows,
                                              std::optional<double> tolerance,
                                              Diagnostics& diagnostics) {
  Comparison comparison(a, b, rows);
  if (!comparison.run(diagnostics)) return std::nullopt;
  return comparison.finish(tolerance);
}

}  // namespace eagerx::gen
