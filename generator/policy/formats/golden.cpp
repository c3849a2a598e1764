// Files of golden rows: CSV and npz.
#include "generator/policy/formats/golden.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "generator/policy/formats/files.hpp"
#include "generator/policy/formats/tensors/containers.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxRows = 1'000'000;

/// The field into which a column or an array is read; nullptr: none.
using Column = std::vector<std::vector<double>> GoldenRows::*;

Column column_of(std::string_view name) {
  const std::size_t letters = name.find_last_not_of("0123456789");
  const std::string_view stem = name.substr(0, letters + 1);
  // "network_out_f64" and "float32" end in digits that are no index.
  if (name == "network_out_f64" || name == "float64" || stem == "network_out_f64_") {
    return &GoldenRows::outputs_double;
  }
  if (name == "float32" || stem == "network_out" || stem == "output") return &GoldenRows::outputs;
  if (name == "episode_start") return &GoldenRows::starts;
  if (stem == "obs" || stem == "observation") return &GoldenRows::observations;
  if (stem == "nobs" || stem == "obs_normalized") return &GoldenRows::normalized;
  if (stem == "action") return &GoldenRows::actions;
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

/// Digits behind the point; as many as can be for a number with an exponent.
std::size_t decimals_of(std::string_view cell) {
  constexpr std::size_t kMost = 17;
  if (cell.find_first_of("eE") != std::string_view::npos) return kMost;
  const std::size_t point = cell.find('.');
  return point == std::string_view::npos ? 0 : cell.size() - point - 1;
}

std::optional<GoldenRows> rows_of_csv(std::string_view text, PolicyProblem& problem) {
  const auto fail = [&](const std::string& how) {
    return refuse(problem, "E0632", how, kGoldenHelp);
  };
  GoldenRows golden;
  std::vector<Column> columns;
  std::size_t number = 0;
  std::size_t digits = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.front() == '#') continue;
    const auto cells = cells_of(line);
    if (columns.empty()) {
      for (const std::string_view cell : cells) columns.push_back(column_of(cell));
      if (std::count(columns.begin(), columns.end(), &GoldenRows::observations) > 0) continue;
      return fail(fmt::format("has no column `obs0` in line {}: `{}`", number, printable(line)));
    }
    if (cells.size() != columns.size()) {
      return fail(fmt::format("has {} in line {}, but {}", counted(cells.size(), "cell"), number,
                              counted(columns.size(), "column")));
    }
    if (golden.observations.size() >= kMaxRows) return fail("has too many rows");
    for (const Column column :
         {&GoldenRows::starts, &GoldenRows::observations, &GoldenRows::normalized,
          &GoldenRows::outputs, &GoldenRows::outputs_double, &GoldenRows::actions}) {
      if (std::count(columns.begin(), columns.end(), column) > 0) (golden.*column).emplace_back();
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (columns[i] == nullptr) continue;
      double value = 0.0;
      const auto result =
          std::from_chars(cells[i].data(), cells[i].data() + cells[i].size(), value);
      if (result.ec != std::errc{} || result.ptr != cells[i].data() + cells[i].size()) {
        return fail(
            fmt::format("has `{}` in line {}, which is not a number", printable(cells[i]), number));
      }
      if (!std::isfinite(value)) {
        return fail(fmt::format("has `{}` in line {}, column {}, which is not a finite number",
                                printable(cells[i]), number, i + 1));
      }
      (golden.*columns[i]).back().push_back(value);
      if (columns[i] == &GoldenRows::observations || columns[i] == &GoldenRows::normalized)
        continue;
      digits = std::max(digits, decimals_of(cells[i]));
    }
  }
  constexpr double kHalf = 0.5000001;  // and the rounding of the digits themselves
  constexpr std::size_t kOfFloat = 9;
  if (digits < kOfFloat) golden.printed = kHalf * std::pow(10.0, -static_cast<double>(digits));
  return golden;
}

std::optional<GoldenRows> rows_of_npz(std::string_view bytes, PolicyProblem& problem) {
  const auto archive = Archive::open(bytes, problem);
  TensorTable table;
  if (!archive || !read_npz(*archive, table, problem)) return std::nullopt;
  GoldenRows golden;
  for (const auto& [name, tensor] : table.tensors) {
    const Column column = column_of(name);
    if (column == nullptr || tensor.shape.empty()) continue;
    const std::vector<double> values = values_of(tensor);
    if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); })) {
      return refuse(problem, "E0632",
                    fmt::format("has NaN or infinity in array `{}`", printable(name)), kGoldenHelp);
    }
    const auto count = static_cast<std::size_t>(tensor.shape[0]);
    if (count == 0 || count > kMaxRows) continue;
    const std::size_t width = values.size() / count;
    for (std::size_t i = 0; i < count; ++i) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * width);
      (golden.*column).emplace_back(first, first + static_cast<std::ptrdiff_t>(width));
    }
  }
  return golden;
}

}  // namespace

std::optional<GoldenRows> read_golden(const std::string& path, const std::string& name,
                                      Span mention, Diagnostics& diagnostics) {
  const auto bytes = read_bytes(path, name, mention, "golden rows", diagnostics);
  if (!bytes) return std::nullopt;
  PolicyProblem problem;
  auto golden = bytes->starts_with("PK\x03\x04") ? rows_of_npz(*bytes, problem)
                                                 : rows_of_csv(*bytes, problem);
  if (golden) return golden;
  report_problem(problem, "golden rows", name, mention, diagnostics);
  return std::nullopt;
}

}  // namespace eagerx::gen
