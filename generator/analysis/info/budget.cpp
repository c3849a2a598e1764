#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/analysis/info/info.hpp"

namespace eagerx::gen {
namespace {

void check_ages(const AgeComparison& compared, Diagnostics& diagnostics) {
  const AgeLimit& limit = compared.limit;
  for (const Input* input : compared.unknown) {
    diagnostics
        .error("E0420", limit.span,
               fmt::format("the age of the data at `{}` is unknown", input->written))
        .notes.push_back(
            {"its delay is too long, or its rates are too far apart", input->span, ""});
  }
  for (const auto& age : compared.ages) {
    if (age.newest_s <= limit.at_most_s) continue;
    auto& problem = diagnostics.error(
        "E0420", limit.span,
        fmt::format("data of `{}` are up to {:.4g} s old at `{}`, {:.4g} s over the budget of {} s",
                    age.from, age.newest_s.to_double(), age.to,
                    (age.newest_s - limit.at_most_s).to_double(), limit.at_most_s.to_string()));
    const auto most = std::ranges::max_element(age.path, {}, &AgeEdge::newest_s);
    problem.notes.push_back({fmt::format("the connection to `{}` adds most of it", most->input),
                             most->span,
                             fmt::format("up to {:.4g} s", most->newest_s.to_double())});
    if (const std::string nodes = nodes_on_path(age); !nodes.empty())
      problem.notes.push_back({"they go through " + nodes, {}, ""});
  }
}

void check_link(const PlanInfo& report, const Spanned<Rational>& limit, Diagnostics& diagnostics) {
  const Rational baud = report.link.baud();
  if (baud <= limit.value) return;
  auto& problem = diagnostics.error(
      "E0420", limit.span,
      fmt::format("a link to the engine needs {} baud, {} over its budget of {}", baud.ceil(),
                  (baud - limit.value).ceil(), limit.value.to_string()));
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

void check_telemetry(const Plan& plan, const Spanned<Rational>& limit, Diagnostics& diagnostics) {
  if (!plan.telemetry) return;
  const double needed = plan.telemetry->baud_needed(), allowed = limit.value.to_double();
  if (needed <= allowed) return;
  auto& problem = diagnostics.error(
      "E0420", limit.span,
      fmt::format("telemetry takes {:.0f} baud, {:.0f} over its budget of {}", std::ceil(needed),
                  std::ceil(needed - allowed), limit.value.to_string()));
  problem.notes.push_back({"its channels and its share", plan.graph->telemetry->span, ""});
}

}  // namespace

PlanInfo info_of(const Plan& plan, const std::optional<BudgetSpec>& budget,
                 Diagnostics& diagnostics) {
  const DataAges ages(plan, usual_ends(*plan.graph));
  PlanInfo report{&plan, ages.known(), ages.unknown(), {}, link_of(plan)};
  if (budget && budget->ages) report.compared = compare_ages(plan, *budget->ages, diagnostics);
  return report;
}

void check_plan_budget(const PlanInfo& report, const BudgetSpec& budget, Diagnostics& diagnostics) {
  for (const AgeComparison& compared : report.compared) check_ages(compared, diagnostics);
  if (budget.link) check_link(report, *budget.link, diagnostics);
  if (budget.parts) check_parts_budget(*report.plan, *budget.parts, diagnostics);
  if (budget.telemetry) check_telemetry(*report.plan, *budget.telemetry, diagnostics);
}

}  // namespace eagerx::gen
