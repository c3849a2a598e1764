#include "generator/tools/linear/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostPrinted = 12;  // rows and columns of a matrix on a screen
constexpr std::size_t kMostPoles = 20;
constexpr std::size_t kResponses = 500;

double decibels(double gain) {
  return 20.0 * std::log10(gain);
}

std::string port_text(const SampledPort& port) {
  return port.unit.empty() ? port.name : fmt::format("{} [{}]", port.name, port.unit);
}

std::string matrix_text(const char* name, const Rows& rows) {
  if (rows.empty() || rows.front().empty()) return {};
  std::string text = fmt::format("\n{}\n", name);
  for (const auto& row : rows) {
    for (const double x : row) text += fmt::format(" {:>13.6g}", x);
    text += '\n';
  }
  return text;
}

/// The system of A, B, C and D without what belongs to the opened port.
Rows without(const Rows& rows, std::size_t last_rows, std::size_t last_columns) {
  Rows result(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(last_rows));
  for (auto& row : result) row.resize(row.size() - last_columns);
  return result;
}

std::string system_text(const SampledSystem& system) {
  std::string text = fmt::format(
      "{} state variables, sampled every {:.9g} s ({})\n", system.state.size(), system.period_s,
      system.steps == 1 ? std::string("1 step") : fmt::format("{} steps", system.steps));
  for (std::size_t i = 0; i < system.state.size(); ++i)
    text += fmt::format("  x[{}] {:<32} {:.9g}\n", i, system.state[i].name, system.state[i].value);
  const std::size_t inputs = system.inputs.size() - system.opened;
  const std::size_t outputs = system.outputs.size() - system.opened;
  for (std::size_t i = 0; i < inputs; ++i)
    text += fmt::format("  u[{}] {}\n", i, port_text(system.inputs[i]));
  for (std::size_t i = 0; i < outputs; ++i)
    text += fmt::format("  y[{}] {}\n", i, port_text(system.outputs[i]));
  if (system.state.size() > kMostPrinted)
    return text + "\nthe matrices are large: `--format json` has them\n";
  return text + matrix_text("A", system.a) + matrix_text("B", without(system.b, 0, system.opened)) +
         matrix_text("C", without(system.c, system.opened, 0)) +
         matrix_text("D", without(system.d, system.opened, system.opened));
}

std::string pole_text(const Pole& pole, const SampledSystem& system) {
  std::vector<std::string> states;
  for (const Participation& each : pole.participation)
    states.push_back(fmt::format("{} {:.0f} %", system.state[each.state].name, 100 * each.share));
  const std::string z = pole.z.imag() == 0.0
                            ? fmt::format("{:.9g}", pole.z.real())
                            : fmt::format("{:.6g} +- {:.6g}i", pole.z.real(), pole.z.imag());
  return fmt::format("  {:<26} {:>9.6f} {:>11.4g} Hz {:>8.4f} {:>11.4g} s  {}\n", z,
                     std::abs(pole.z), pole.frequency_hz, pole.damping, pole.time_constant_s,
                     join(states, ", "));
}

std::string modes_text(const LinearReport& report) {
  const Modes& modes = report.modes;
  std::string text = fmt::format(
      "\nspectral radius {:.9g}: {}{}{}\n", modes.spectral_radius,
      report.margins ? "open loop " : "", modes.spectral_radius < 1.0 ? "stable" : "unstable",
      modes.integrators == 0 ? "" : ", apart from free integrators (poles within 1e-6 of 1)");
  if (modes.poles.empty()) return text;
  text += fmt::format("  {:<26} {:>9} {:>14} {:>8} {:>13}  {}\n", "pole z", "|z|", "frequency",
                      "damping", "time", "states");
  for (std::size_t i = 0; i < modes.poles.size() && i < kMostPoles; ++i)
    text += pole_text(modes.poles[i], *report.system);
  if (modes.poles.size() > kMostPoles)
    text += fmt::format("  and {} faster ones\n", modes.poles.size() - kMostPoles);
  if (modes.at_zero > 0)
    text += fmt::format("  and {} at 0: messages in flight, delays\n", modes.at_zero);
  return text;
}

std::string delay_text(const Margins& margins) {
  if (!margins.is_stable) return "  delay margin  none: the closed loop is unstable\n";
  std::string text = margins.delay_s
                         ? fmt::format("  delay margin  {:.6g} ms at {:.6g} Hz",
                                       *margins.delay_s * 1e3, *margins.delay_frequency_hz)
                         : "  delay margin  none: the gain does not cross 1";
  if (margins.stable_messages)
    text += fmt::format("; stable with {} more messages of delay ({:.6g} ms), not with {}",
                        *margins.stable_messages,
                        1e3 * margins.port_period_s * static_cast<double>(*margins.stable_messages),
                        *margins.stable_messages + 1);
  else
    text += fmt::format("; stable with {} more messages of delay, and more were not tried",
                        margins.tried_messages);
  return text + '\n';
}

std::string margins_text(const LinearReport& report) {
  const Margins& margins = *report.margins;
  std::string text = fmt::format(
      "\nthe loop opened at {}, one message every {:.6g} ms\n  closed        {}, spectral "
      "radius {:.9g}\n",
      report.opened, margins.port_period_s * 1e3, margins.is_stable ? "stable" : "unstable",
      margins.spectral_radius);
  if (margins.integrators > 0)
    text += fmt::format("                without {} within 1e-6 of 1, which may also grow slowly\n",
                        counted(margins.integrators, "pole"));
  const auto gain = [&](const char* name, const auto& factor, const auto& frequency) {
    if (factor)
      text += fmt::format("  {} {:.6g} ({:.4g} dB) at {:.6g} Hz\n", name, *factor,
                          decibels(*factor), *frequency);
  };
  gain("gain margin  ", margins.gain, margins.gain_frequency_hz);
  gain("least gain   ", margins.least_gain, margins.least_gain_frequency_hz);
  if (margins.phase_deg)
    text += fmt::format("  phase margin  {:.6g} deg at {:.6g} Hz\n", *margins.phase_deg,
                        *margins.crossover_hz);
  if (margins.sensitivity == 1.0 && !margins.phase_deg)
    text +=
        "  no signal returns to the port: a limit, a dead zone or a missing message breaks the "
        "loop\n";
  text += delay_text(margins);
  text += fmt::format("  sensitivity   peak {:.6g} at {:.6g} Hz\n", margins.sensitivity,
                      margins.sensitivity_hz);
  if (margins.other_frequencies > 1e-6)
    text += fmt::format(
        "  multirate     at the crossover, {:.2g} of the response is at other frequencies, which "
        "gain and phase margin neglect\n",
        margins.other_frequencies);
  for (const DataAge& age : report.ages)
    text += fmt::format("  age of data   {:.6g} ms from {} to {}\n", age.newest_s.to_double() * 1e3,
                        age.from, age.to);
  return text;
}

std::string corners_text(const WorstMargins& worst) {
  const Margins& margins = worst.margins;
  std::string text = fmt::format(
      "\nover {} of sampled parameters\n  closed        {}, spectral radius {:.9g} at {}\n",
      counted(worst.corners, "corner"), margins.is_stable ? "stable" : "unstable",
      margins.spectral_radius, worst.stability_at);
  if (margins.gain)
    text +=
        fmt::format("  gain margin   {:.4g} dB at {}\n", decibels(*margins.gain), worst.gain_at);
  if (margins.least_gain)
    text += fmt::format("  least gain    {:.4g} dB at {}\n", decibels(*margins.least_gain),
                        worst.least_gain_at);
  if (margins.phase_deg)
    text += fmt::format("  phase margin  {:.6g} deg at {}\n", *margins.phase_deg, worst.phase_at);
  if (margins.is_stable && margins.delay_s)
    text +=
        fmt::format("  delay margin  {:.6g} ms at {}\n", *margins.delay_s * 1e3, worst.delay_at);
  return text;
}

std::string notes_text(const SampledSystem& system) {
  std::string text;
  if (!system.losing.empty())
    text +=
        fmt::format("\nno derivative passes through these nodes: {}\n", join(system.losing, ", "));
  if (!system.smoothing.empty())
    text += fmt::format("\nquantization counts as slope 1 in these nodes: {}\n",
                        join(system.smoothing, ", "));
  if (system.drift > 1e-6)
    text += fmt::format(
        "\nthe operating point is not an equilibrium: A of the next hyperperiod differs by {:.2g} "
        "of its largest element\n",
        system.drift);
  return text;
}

Json rows_json(const Rows& rows) {
  Json list = Json::list();
  for (const auto& row : rows) {
    Json numbers = Json::list();
    for (const double x : row) numbers.push_back(x);
    list.push_back(std::move(numbers));
  }
  return list;
}

Json ports_json(const std::vector<SampledPort>& ports, std::size_t count) {
  Json list = Json::list();
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(Json{{"name", ports[i].name}, {"unit", ports[i].unit}});
  return list;
}

template <class T>
Json maybe(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json poles_json(const LinearReport& report) {
  Json list = Json::list();
  for (const Pole& pole : report.modes.poles) {
    Json states = Json::object();
    for (const Participation& each : pole.participation)
      states[report.system->state[each.state].name] = each.share;
    list.push_back(Json{{"z", Json::List{pole.z.real(), pole.z.imag()}},
                        {"frequency_hz", pole.frequency_hz},
                        {"damping", pole.damping},
                        {"time_constant_s", pole.time_constant_s},
                        {"participation", std::move(states)}});
  }
  return list;
}

Json corners_json(const WorstMargins& worst) {
  const Margins& margins = worst.margins;
  return Json{{"corners", worst.corners},
              {"stable", margins.is_stable},
              {"spectral_radius", margins.spectral_radius},
              {"gain", maybe(margins.gain)},
              {"least_gain", maybe(margins.least_gain)},
              {"phase_deg", maybe(margins.phase_deg)},
              {"delay_s", margins.is_stable ? maybe(margins.delay_s) : Json(nullptr)},
              {"at", Json{{"stable", worst.stability_at},
                          {"gain", worst.gain_at},
                          {"least_gain", worst.least_gain_at},
                          {"phase_deg", worst.phase_at},
                          {"delay_s", worst.delay_at}}}};
}

}  // namespace

Json margins_json(const LinearReport& report) {
  const Margins& margins = *report.margins;
  Json ages = Json::list();
  for (const DataAge& age : report.ages)
    ages.push_back(
        Json{{"from", age.from}, {"to", age.to}, {"newest_s", age.newest_s.to_double()}});
  return Json{{"port", report.opened},
              {"message_s", margins.port_period_s},
              {"stable", margins.is_stable},
              {"spectral_radius", margins.spectral_radius},
              {"integrators", margins.integrators},
              {"gain", maybe(margins.gain)},
              {"gain_frequency_hz", maybe(margins.gain_frequency_hz)},
              {"least_gain", maybe(margins.least_gain)},
              {"least_gain_frequency_hz", maybe(margins.least_gain_frequency_hz)},
              {"phase_deg", maybe(margins.phase_deg)},
              {"crossover_hz", maybe(margins.crossover_hz)},
              {"delay_s", maybe(margins.delay_s)},
              {"delay_frequency_hz", maybe(margins.delay_frequency_hz)},
              {"stable_messages", maybe(margins.stable_messages)},
              {"tried_messages", margins.tried_messages},
              {"sensitivity", margins.sensitivity},
              {"sensitivity_hz", margins.sensitivity_hz},
              {"other_frequencies", margins.other_frequencies},
              {"ages", std::move(ages)}};
}

std::string linear_text(const LinearReport& report) {
  return system_text(*report.system) + modes_text(report) +
         (report.margins ? margins_text(report) : "") +
         (report.corners ? corners_text(*report.corners) : "") + notes_text(*report.system);
}

Json linear_json(const LinearReport& report) {
  const SampledSystem& system = *report.system;
  const std::size_t opened = system.opened;
  Json state = Json::list();
  for (const StateWord& word : system.state)
    state.push_back(Json{{"name", word.name}, {"value", word.value}});
  Json json{{"period_s", system.period_s},
            {"steps", system.steps},
            {"state", std::move(state)},
            {"inputs", ports_json(system.inputs, system.inputs.size() - opened)},
            {"outputs", ports_json(system.outputs, system.outputs.size() - opened)},
            {"A", rows_json(system.a)},
            {"B", rows_json(without(system.b, 0, opened))},
            {"C", rows_json(without(system.c, opened, 0))},
            {"D", rows_json(without(system.d, opened, opened))},
            {"spectral_radius", report.modes.spectral_radius},
            {"integrators", report.modes.integrators},
            {"poles", poles_json(report)},
            {"poles_at_zero", report.modes.at_zero},
            {"unchanging", system.unchanging},
            {"without_derivative", system.losing},
            {"mean_slope", system.smoothing},
            {"drift", system.drift}};
  if (report.margins) json["loop"] = margins_json(report);
  if (report.corners) json["corners"] = corners_json(*report.corners);
  return json;
}

std::string response_csv(const SampledSystem& system) {
  std::string text = "frequency_hz,gain,gain_db,phase_deg\n";
  for (const Response& each : responses_of(system, kResponses))
    text +=
        fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", each.frequency_hz, std::abs(each.loop),
                    decibels(std::abs(each.loop)), std::arg(each.loop) * 180.0 / std::numbers::pi);
  return text;
}

}  // namespace eagerx::gen
