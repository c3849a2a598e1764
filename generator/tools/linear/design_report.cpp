#include "generator/tools/linear/design_report.hpp"

#include <fmt/format.h>

#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

template <class T>
Json number_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string with_frequency(const std::optional<double>& value, const char* unit,
                           const std::optional<double>& frequency_hz) {
  return value ? fmt::format("{:.5g}{} at {:.4g} Hz", *value, unit, frequency_hz.value_or(0.0))
               : "-";
}

std::string loop_text(const DesignedLoop& loop) {
  std::string text =
      fmt::format("\nthe loop opened at {}\n  {:<16}{:<28}{}\n", loop.port, "", "before", "after");
  const auto row = [&](const char* name, auto cell) {
    text += fmt::format("  {:<16}{:<28}{}\n", name, cell(loop.before), cell(loop.after));
  };
  row("closed", [](const Margins& m) {
    return fmt::format("{}, radius {:.6g}", m.is_stable ? "stable" : "unstable", m.spectral_radius);
  });
  row("gain margin",
      [](const Margins& m) { return with_frequency(m.gain, "", m.gain_frequency_hz); });
  row("least gain",
      [](const Margins& m) { return with_frequency(m.least_gain, "", m.least_gain_frequency_hz); });
  row("phase margin",
      [](const Margins& m) { return with_frequency(m.phase_deg, " deg", m.crossover_hz); });
  row("delay margin", [](const Margins& m) {
    const auto ms = m.delay_s ? std::optional(*m.delay_s * 1e3) : std::nullopt;
    return with_frequency(ms, " ms", m.delay_frequency_hz);
  });
  row("sensitivity", [](const Margins& m) {
    return fmt::format("{:.5g} at {:.4g} Hz", m.sensitivity, m.sensitivity_hz);
  });
  return text;
}

Json margins_numbers(const Margins& margins) {
  return Json{{"stable", margins.is_stable},
              {"spectral_radius", margins.spectral_radius},
              {"gain", number_or_null(margins.gain)},
              {"least_gain", number_or_null(margins.least_gain)},
              {"phase_deg", number_or_null(margins.phase_deg)},
              {"crossover_hz", number_or_null(margins.crossover_hz)},
              {"delay_s", number_or_null(margins.delay_s)},
              {"sensitivity", margins.sensitivity}};
}

}  // namespace

std::string DesignedParameter::text() const {
  std::string text;
  for (const double value : values)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", value == 0.0 ? 0.0 : value);
  return is_list ? "[" + text + "]" : text;
}

std::string design_text(const DesignReport& report) {
  std::string text = fmt::format("{} of {} `{}`, every {:.6g} ms\n", report.method, report.type,
                                 report.node, report.period_s * 1e3);
  for (const DesignedParameter& each : report.parameters)
    text += fmt::format("  {}: {}\n", each.name, each.text());
  for (const auto& [name, fact] : report.facts) text += fmt::format("  {:<16}{}\n", name, fact);
  for (const DesignedLoop& loop : report.loops) text += loop_text(loop);
  if (!report.losing.empty())
    text +=
        fmt::format("\nno derivative passes through these nodes: {}\n", join(report.losing, ", "));
  if (!report.smoothing.empty())
    text += fmt::format("\nquantization counts as slope 1 in these nodes: {}\n",
                        join(report.smoothing, ", "));
  return text;
}

Json design_json(const DesignReport& report) {
  Json parameters = Json::object();
  for (const DesignedParameter& each : report.parameters) {
    Json list = Json::list();
    for (const double value : each.values) list.push_back(value);
    parameters[each.name] = each.is_list ? std::move(list) : Json(each.values.front());
  }
  Json loops = Json::list();
  for (const DesignedLoop& loop : report.loops)
    loops.push_back(Json{{"port", loop.port},
                         {"before", margins_numbers(loop.before)},
                         {"after", margins_numbers(loop.after)}});
  Json json{{"method", report.method},
            {"node", report.node},
            {"type", report.type},
            {"period_s", report.period_s},
            {"parameters", std::move(parameters)},
            {"loops", std::move(loops)},
            {"without_derivative", report.losing},
            {"mean_slope", report.smoothing}};
  if (const auto* const members = report.numbers.as<Json::Object>()) {
    for (const JsonMember& each : *members) json[each.name] = each.value;
  }
  return json;
}

}  // namespace eagerx::gen
