// Golden rows as a CSV file.
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "generator/policy/formats/golden.hpp"

namespace eagerx::gen {
namespace {

void add_names(std::string& header, std::string_view stem,
               const std::vector<std::vector<double>>& rows) {
  if (rows.empty()) return;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    header += fmt::format("{}{}{}", header.empty() ? "" : ",", stem, i);
  }
}

/// Shortest digits of float32: what the network is given.
void add_inputs(std::string& line, const std::vector<std::vector<double>>& rows, std::size_t row) {
  if (rows.empty()) return;
  for (const double value : rows[row]) {
    line += fmt::format("{},", static_cast<float>(value));
  }
}

/// With an exponent, which says that all digits are there: the reader allows for what is cut off.
void add_answers(std::string& line, const std::vector<std::vector<double>>& rows, std::size_t row) {
  if (rows.empty()) return;
  for (const double value : rows[row]) {
    line += fmt::format("{:.16e},", value);
  }
}

}  // namespace

std::string golden_csv(const GoldenRows& rows, const std::string& about) {
  std::string text;
  for (const char c : about) text += c == '\n' || c == '\r' ? ' ' : c;
  text = "# " + text + "\n";
  std::string header = rows.starts.empty() ? "" : "episode_start";
  add_names(header, "obs", rows.observations);
  add_names(header, "nobs", rows.normalized);
  add_names(header, "network_out", rows.outputs);
  add_names(header, "network_out_f64_", rows.outputs_double);
  add_names(header, "action", rows.actions);
  text += header + "\n";
  for (std::size_t i = 0; i < rows.observations.size(); ++i) {
    if (!rows.starts.empty()) text += rows.starts[i].front() != 0.0 ? "1," : "0,";
    add_inputs(text, rows.observations, i);
    add_inputs(text, rows.normalized, i);
    add_answers(text, rows.outputs, i);
    add_answers(text, rows.outputs_double, i);
    add_answers(text, rows.actions, i);
    text.back() = '\n';
  }
  return text;
}

}  // namespace eagerx::gen
