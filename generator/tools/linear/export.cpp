#include "generator/tools/linear/export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <runtime/host/base/utf8.hpp>
#include <vector>

#include "generator/support/diagnostics/join.hpp"
#include "generator/tools/trace/bytes.hpp"
#include "generator/tools/trace/numpy_archive.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kExportedResponses = 500;

std::string little_endian(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double x : numbers) append(bytes, std::bit_cast<std::uint64_t>(x));
  return bytes;
}
std::string little_endian(const std::vector<std::complex<double>>& numbers) {
  std::string bytes;
  for (const std::complex<double> z : numbers)
    bytes += little_endian(std::vector{z.real(), z.imag()});
  return bytes;
}

void add_numbers(NumpyArchive& archive, const char* name, const std::vector<double>& numbers) {
  archive.add(name, "<f8", fmt::format("{},", numbers.size()), little_endian(numbers));
}
void add_numbers(NumpyArchive& archive, const char* name,
                 const std::vector<std::complex<double>>& numbers) {
  archive.add(name, "<c16", fmt::format("{},", numbers.size()), little_endian(numbers));
}

/// The first `rows` rows and `columns` columns.
void add_matrix(NumpyArchive& archive, const char* name, const Rows& matrix, std::size_t rows,
                std::size_t columns) {
  std::string bytes;
  for (std::size_t i = 0; i < rows; ++i)
    bytes += little_endian(
        std::vector(matrix[i].begin(), matrix[i].begin() + static_cast<std::ptrdiff_t>(columns)));
  archive.add(name, "<f8", fmt::format("{}, {}", rows, columns), bytes);
}

/// An array of texts: code points in 32 bits, as many as the longest has.
void add_texts(NumpyArchive& archive, const std::string& name,
               const std::vector<std::string>& texts) {
  std::vector<std::u32string> decoded;
  std::size_t longest = 1;
  for (const std::string& text : texts) {
    std::u32string& points = decoded.emplace_back();
    for (std::size_t at = 0; at < text.size();) {
      const host::CodePoint point = host::decode_utf8(text, at);
      points += point.value;
      at += point.size;
    }
    longest = std::max(longest, points.size());
  }
  std::string bytes;
  for (std::u32string& points : decoded) {
    points.resize(longest);
    for (const char32_t point : points) append(bytes, static_cast<std::uint32_t>(point));
  }
  archive.add(name, fmt::format("<U{}", longest), fmt::format("{},", texts.size()), bytes);
}

std::vector<std::string> names_of_ports(const std::vector<SampledPort>& ports, std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(ports[i].name);
  return names;
}

void add_named_ports(NumpyArchive& archive, const std::string& name,
                     const std::vector<SampledPort>& ports, std::size_t count) {
  std::vector<std::string> units;
  for (std::size_t i = 0; i < count; ++i) units.push_back(ports[i].unit);
  add_texts(archive, name, names_of_ports(ports, count));
  add_texts(archive, name + "_unit", units);
}

/// "a: [1, 2,\n      3, 4]": a row of the matrix in each line.
std::string flow_rows(const char* name, const Rows& matrix, std::size_t rows, std::size_t columns) {
  std::string text = fmt::format("    {}: [", name);
  for (std::size_t i = 0; i < rows; ++i) {
    if (i > 0) text += ",\n      ";
    for (std::size_t k = 0; k < columns; ++k)
      text += fmt::format("{}{}", k == 0 ? "" : ", ", matrix[i][k] == 0.0 ? 0.0 : matrix[i][k]);
  }
  return text + "]\n";
}

}  // namespace

std::string linear_npz(const LinearReport& report) {
  const SampledSystem& system = *report.system;
  const std::size_t states = system.state.size(), inputs = system.inputs.size() - system.opened,
                    outputs = system.outputs.size() - system.opened;
  NumpyArchive archive;
  add_matrix(archive, "A", system.a, states, states);
  add_matrix(archive, "B", system.b, states, inputs);
  add_matrix(archive, "C", system.c, outputs, states);
  add_matrix(archive, "D", system.d, outputs, inputs);
  archive.add("dt", "<f8", "", little_endian(std::vector{system.period_s}));
  std::vector<std::string> names;
  std::vector<double> values;
  for (const StateWord& word : system.state) {
    names.push_back(word.name);
    values.push_back(word.value);
  }
  add_texts(archive, "state", names);
  add_numbers(archive, "state_value", values);
  add_named_ports(archive, "input", system.inputs, inputs);
  add_named_ports(archive, "output", system.outputs, outputs);
  std::vector<std::complex<double>> poles;
  for (const Pole& pole : report.modes.poles) {
    poles.push_back(pole.z);
    if (pole.z.imag() != 0.0) poles.push_back(std::conj(pole.z));
  }
  poles.resize(poles.size() + report.modes.at_zero);
  add_numbers(archive, "poles", poles);
  if (report.margins) {
    std::vector<double> frequencies;
    std::vector<std::complex<double>> loop;
    for (const Response& each : responses_of(system, kExportedResponses)) {
      frequencies.push_back(each.frequency_hz);
      loop.push_back(each.loop);
    }
    add_numbers(archive, "frequency_hz", frequencies);
    add_numbers(archive, "loop", loop);
  }
  return std::move(archive).finish();
}

std::string state_space_yaml(const LinearReport& report, std::string& problem) {
  const SampledSystem& system = *report.system;
  constexpr std::size_t kMostStates = 100;  // of StateSpace
  const std::size_t states = system.state.size(), inputs = system.inputs.size() - system.opened,
                    outputs = system.outputs.size() - system.opened;
  if (states == 0 || states > kMostStates)
    problem = fmt::format("StateSpace has 1 to {} states, and this system {}", kMostStates, states);
  else if (inputs == 0 || outputs == 0)
    problem = "the system has no inputs or no outputs: name ports with `--from` and `--to`";
  if (!problem.empty()) return "";
  std::vector<std::string> names;
  for (const StateWord& word : system.state) names.push_back(word.name);
  std::string text = "# deviations from the operating point\n";
  text += fmt::format("# x: {}\n", join(names, ", "));
  text += fmt::format("# signal: {}\n", join(names_of_ports(system.inputs, inputs), ", "));
  text += fmt::format("# y: {}\n", join(names_of_ports(system.outputs, outputs), ", "));
  text += fmt::format("plant:\n  type: StateSpace\n  rate: {:.12g}\n  config:\n",
                      1.0 / system.period_s);
  text += fmt::format("    order: {}\n    outputs: {}\n", states, outputs);
  return text + flow_rows("a", system.a, states, states) +
         flow_rows("b", system.b, states, inputs) + flow_rows("c", system.c, outputs, states) +
         flow_rows("d", system.d, outputs, inputs);
}

}  // namespace eagerx::gen
