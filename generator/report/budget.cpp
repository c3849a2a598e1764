#include <fmt/format.h>

#include <algorithm>

#include "generator/report/report.hpp"

namespace eagerx::gen {
namespace {

/// One problem for each pair of a sensor and an actuator.
void check_ages(const PlanReport& report, const YamlValue& entry, Diagnostics& diagnostics) {
  const auto limit = Rational::parse(entry.text);
  if (!limit) return;  // said when the graph was read
  for (const Input* input : report.ages_unknown) {
    diagnostics
        .error("E0420", entry.span,
               fmt::format("how old data become on the way to `{}` is not known", input->written))
        .notes.push_back(
            {"its delay is too long, or its rates are too far apart", input->span, ""});
  }
  for (const auto& age : report.ages) {
    if (age.newest_s <= *limit) continue;
    auto& problem = diagnostics.error(
        "E0420", entry.span,
        fmt::format("data of `{}` are up to {:.4g} s old at `{}`, {:.4g} s over the budget of {} s",
                    age.sensor, age.newest_s.to_double(), age.actuator,
                    (age.newest_s - *limit).to_double(), limit->to_string()));
    const auto most = std::ranges::max_element(age.way, {}, &AgeHop::newest_s);
    problem.notes.push_back({fmt::format("the connection to `{}` adds most of it", most->input),
                             most->span,
                             fmt::format("up to {:.4g} s", most->newest_s.to_double())});
  }
}

void check_link(const PlanReport& report, const YamlValue& entry, Diagnostics& diagnostics) {
  const auto limit = Rational::parse(entry.text);
  if (!limit || report.link.baud() <= *limit) return;
  auto& problem =
      diagnostics.error("E0420", entry.span,
                        fmt::format("a link to the engine needs {} baud, {} over its budget of {}",
                                    report.link.baud().ceil(), (report.link.baud() - *limit).ceil(),
                                    limit->to_string()));
  const bool to_engine = report.link.sensors.baud < report.link.actuators.baud;
  const LinkMessage* most = nullptr;
  for (const auto& message : report.link.messages) {
    if (message.to_engine != to_engine) continue;
    if (most == nullptr || most->bytes_per_s() < message.bytes_per_s()) most = &message;
  }
  problem.notes.push_back(
      {fmt::format("`{}` takes most of it", most->name), most->span,
       fmt::format("{} bytes at {} Hz", most->bytes, most->rate_hz.to_string())});
}

}  // namespace

PlanReport report_of(const Plan& plan) {
  DataAges ages = data_ages(plan);
  return {&plan, std::move(ages.known), std::move(ages.unknown), link_of(plan)};
}

void check_plan_budget(const PlanReport& report, const YamlValue& budget,
                       Diagnostics& diagnostics) {
  if (const YamlValue* entry = budget.find("age")) check_ages(report, *entry, diagnostics);
  if (const YamlValue* entry = budget.find("link")) check_link(report, *entry, diagnostics);
}

}  // namespace eagerx::gen
