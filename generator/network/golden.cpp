// Golden rows: inputs that a policy is known to answer, and how well it does.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "generator/formats/tensors/archive.hpp"
#include "generator/formats/tensors/containers.hpp"
#include "generator/network/evaluate.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kHelp =
    "columns are obs0, obs1 …, network_out, action; arrays obs, network_out, action";
constexpr std::size_t kMaxRows = 1'000'000;

/// What a column or an array may be called.
enum class Role : std::uint8_t {
  none,
  start,
  observation,
  normalized,
  output,
  output_double,
  action
};

Role role_of(std::string_view name) {
  const std::size_t letters = name.find_last_not_of("0123456789");
  const std::string_view stem = name.substr(0, letters + 1);
  // "network_out_f64" and "float32" end in digits that are no index.
  if (name == "network_out_f64" || name == "float64" || stem == "network_out_f64_") {
    return Role::output_double;
  }
  if (name == "float32" || stem == "network_out" || stem == "output") return Role::output;
  if (name == "episode_start") return Role::start;
  if (stem == "obs" || stem == "observation") return Role::observation;
  if (stem == "nobs" || stem == "obs_normalized") return Role::normalized;
  if (stem == "action") return Role::action;
  return Role::none;
}

std::vector<std::vector<double>>* rows_of(GoldenRows& golden, Role role) {
  switch (role) {
    case Role::start:
      return &golden.starts;
    case Role::observation:
      return &golden.observations;
    case Role::normalized:
      return &golden.normalized;
    case Role::output:
      return &golden.outputs;
    case Role::output_double:
      return &golden.outputs_double;
    case Role::action:
      return &golden.actions;
    case Role::none:
      break;
  }
  return nullptr;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    std::string_view cell = line.substr(0, comma);
    while (!cell.empty() && cell.front() == ' ') cell.remove_prefix(1);
    while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
    cells.push_back(cell);
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::optional<GoldenRows> from_csv(std::string_view text, PolicyProblem& problem) {
  const auto fail = [&](const std::string& how) { return refuse(problem, "E0632", how, kHelp); };
  GoldenRows golden;
  std::vector<Role> roles;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (roles.empty()) {
      for (const std::string_view cell : cells) roles.push_back(role_of(cell));
      if (std::count(roles.begin(), roles.end(), Role::observation) > 0) continue;
      return fail(fmt::format("has no column `obs0` in line {}: `{}`", number, printable(line)));
    }
    if (cells.size() != roles.size()) {
      return fail(fmt::format("has {} cells in line {}, but {} columns", cells.size(), number,
                              roles.size()));
    }
    if (golden.observations.size() >= kMaxRows) return fail("has too many rows");
    for (const Role role : {Role::start, Role::observation, Role::normalized, Role::output,
                            Role::output_double, Role::action}) {
      if (std::count(roles.begin(), roles.end(), role) > 0) rows_of(golden, role)->emplace_back();
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      auto* rows = rows_of(golden, roles[i]);
      if (rows == nullptr) continue;
      double value = 0.0;
      const auto result =
          std::from_chars(cells[i].data(), cells[i].data() + cells[i].size(), value);
      if (result.ec != std::errc{} || result.ptr != cells[i].data() + cells[i].size()) {
        return fail(
            fmt::format("has `{}` in line {}, which is no number", printable(cells[i]), number));
      }
      if (!std::isfinite(value)) {
        return fail(fmt::format("has `{}` in line {}, column {}, which is no finite number",
                                printable(cells[i]), number, i + 1));
      }
      rows->back().push_back(value);
    }
  }
  return golden;
}

std::optional<GoldenRows> from_npz(std::string_view bytes, PolicyProblem& problem) {
  const auto archive = Archive::open(bytes, problem);
  TensorTable table;
  if (!archive || !read_npz(*archive, table, problem)) return std::nullopt;
  GoldenRows golden;
  for (const auto& [name, tensor] : table.tensors) {
    auto* rows = rows_of(golden, role_of(name));
    if (rows == nullptr || tensor.shape.empty()) continue;
    const std::vector<double> values = values_of(tensor);
    if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); })) {
      return refuse(problem, "E0632",
                    fmt::format("has NaN or infinity in array `{}`", printable(name)), kHelp);
    }
    const auto count = static_cast<std::size_t>(tensor.shape[0]);
    if (count == 0 || count > kMaxRows) continue;
    const std::size_t width = values.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * width);
      rows->emplace_back(first, first + static_cast<std::ptrdiff_t>(width));
    }
  }
  return golden;
}

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
    return "has another number of normalised observations than of observations";
  }
  if (!all_of_width(rows.starts, count, 1))
    return "has another number of `episode_start` than rows";
  const bool fits = all_of_width(rows.outputs, count, network.outputs()) &&
                    all_of_width(rows.outputs_double, count, network.outputs());
  if (!fits)
    return fmt::format("has another number of outputs than the policy ({})", network.outputs());
  const std::size_t actions =
      network.action_kind() == ActionKind::argmax ? 1 : std::size_t{network.outputs()};
  if (!all_of_width(rows.actions, count, actions)) {
    return fmt::format("has another number of actions than the policy ({})", actions);
  }
  if (rows.outputs.empty() && rows.outputs_double.empty() && rows.actions.empty()) {
    return "has neither outputs nor actions";
  }
  return {};
}

/// Whether an episode starts with row `i`.
bool starts(const GoldenRows& rows, std::size_t i) {
  return i == 0 || rows.starts.empty() || rows.starts[i].front() != 0.0;
}

/// Rows of the first episode.
std::size_t first_episode(const GoldenRows& rows) {
  std::size_t count = std::min<std::size_t>(1, rows.observations.size());
  while (count < rows.observations.size() && !starts(rows, count)) ++count;
  return count;
}

std::vector<float> to_float(const std::vector<double>& values) {
  std::vector<float> result(values.size());
  std::transform(values.begin(), values.end(), result.begin(),
                 [](double value) { return static_cast<float>(value); });
  return result;
}

}  // namespace

std::optional<GoldenRows> read_golden(const std::string& path, const std::string& name,
                                      Span mention, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(path, name, mention, "golden rows", diagnostics);
  if (!bytes) return std::nullopt;
  PolicyProblem problem;
  auto golden =
      bytes->starts_with("PK\x03\x04") ? from_npz(*bytes, problem) : from_csv(*bytes, problem);
  if (golden) return golden;
  diagnostics
      .error(problem.code, mention, fmt::format("golden rows `{}` {}", name, problem.message))
      .help = problem.help;
  return std::nullopt;
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
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < count; ++i) {
    result.emplace_back(network.inputs());
    for (float& value : result.back()) {
      state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator
      constexpr unsigned kUnused = 16;
      value = static_cast<float>(state >> kUnused) * 0x1p-15F - 1.0F;
    }
  }
  return result;
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
                             "{:.3g}), but the policy `{}` gets observations as they are",
                             name, row + 1, i, given, i, normalized, network.file))
          .help =
          "name the statistics as `normalize`; if a node normalises, give what it sends as obs";
      return false;
    }
  }
  return true;
}

std::optional<GoldenResult> compare(const Network& network, const GoldenRows& rows,
                                    const std::string& name, Span mention,
                                    Diagnostics& diagnostics) {
  if (const std::string how = misfit(network, rows); !how.empty()) {
    diagnostics.error("E0632", mention, fmt::format("golden rows `{}` {}", name, how)).help = kHelp;
    return std::nullopt;
  }
  GoldenResult result;
  result.rows = rows.observations.size();
  double largest_output = 1.0;
  double farthest = 0.0;
  std::size_t farthest_row = 0;
  double largest_action = 1.0;
  // Without statistics a policy is given what was normalised elsewhere.
  const bool normalized_elsewhere = !network.normalization && !rows.normalized.empty();
  Memory<float> memory;
  Memory<double> exact_memory;
  for (std::size_t i = 0; i < result.rows; ++i) {
    const std::vector<float> input = normalized_elsewhere
                                         ? to_float(rows.normalized[i])
                                         : normalized(network, to_float(rows.observations[i]));
    if (starts(rows, i)) {
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
        .help = network.normalization || rows.normalized.empty()
                    ? network.has_memory() && rows.starts.empty()
                          ? "these rows are of another policy, or follow one another: add a column "
                            "`episode_start`"
                          : "these rows are of another policy, or of other statistics"
                    : "give the statistics of its observations as `normalize`";
    return std::nullopt;
  }
  return result;
}

}  // namespace eagerx::gen
