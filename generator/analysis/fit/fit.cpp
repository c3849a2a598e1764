#include "generator/analysis/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

namespace eagerx::gen {
namespace {

constexpr double kMicro = 1e6;
constexpr double kPercent = 100;

bool has_all_bounds(const BoundReport& report) {
  const auto is_bound = [](const InstructionBound& row) { return row.is_bound; };
  return std::ranges::all_of(report.parts, is_bound) && std::ranges::all_of(report.slots, is_bound);
}

std::size_t environment_rate(const Plan& plan) {
  for (std::size_t n = 0; n < plan.nodes.size(); ++n) {
    if (plan.graph->nodes[n].role == NodeRole::environment) return plan.nodes[n].rate;
  }
  return 0;
}

class Fitting {
 public:
  Fitting(const BoundReport& report, const Plan& plan)
      : report_(report), plan_(plan), environment_(std::uint64_t{1} << environment_rate(plan)) {}

  Fit fit() {
    Fit result;
    const double quantum_s =
        1.0 / (plan_.rates[0].rate_hz.to_double() * static_cast<double>(plan_.rates[0].period));
    std::uint64_t now = 0;
    for (std::uint64_t left = *plan_.schedule.slots; left > 0; --left) {
      const std::uint64_t next = next_slot(now);
      const SlotFit slot = slot_at(now, static_cast<double>(next - now) * quantum_s);
      if (slot.load() > result.busiest.busy_s / std::max(result.busiest.until_next_s, quantum_s))
        result.busiest = slot;
      if (slot.busy_s > result.longest.busy_s) result.longest = slot;
      result.busy_s += slot.busy_s;
      now = next;
    }
    result.hyperperiod_s = static_cast<double>(now) * quantum_s;
    for (std::size_t rate = 0; rate < plan_.rates.size(); ++rate)
      result.outputs.push_back({name_of(rate), latest_[rate]});
    return result;
  }

 private:
  [[nodiscard]] std::string name_of(std::size_t rate) const {
    return plan_.rates[rate].rate_hz.to_string() + " Hz";
  }

  [[nodiscard]] std::uint64_t next_slot(std::uint64_t now) const {
    std::uint64_t next = UINT64_MAX;
    for (const RateClass& rate : plan_.rates)
      next = std::min(next, (now / rate.period + 1) * rate.period);
    return next;
  }

  SlotFit slot_at(std::uint64_t now, double until_next_s) {
    SlotFit slot{{}, 0, 0, until_next_s};
    for (std::size_t rate = 0; rate < plan_.rates.size(); ++rate) {
      if (now % plan_.rates[rate].period != 0) continue;
      slot.mask |= std::uint64_t{1} << rate;
      slot.name += (slot.name.empty() ? "" : ", ") + name_of(rate);
    }
    const auto [found, is_new] = known_.try_emplace(slot.mask);
    if (is_new) found->second = times_of(slot.mask);
    slot.busy_s = found->second.busy_s;
    for (std::size_t rate = 0; rate < plan_.rates.size(); ++rate) {
      if ((slot.mask >> rate & 1U) != 0)
        latest_[rate] = std::max(latest_[rate], found->second.outputs_s);
    }
    return slot;
  }

  struct Times {
    double busy_s = 0, outputs_s = 0;
  };
  /// The slot of these rates, or the longest one if all slots share one function.
  [[nodiscard]] Times times_of(std::uint64_t mask) const {
    const auto own = std::ranges::find(report_.slots, std::optional(mask), &SlotBound::due);
    std::uint64_t cycles = own != report_.slots.end() ? own->cycles : 0;
    if (own == report_.slots.end()) {
      for (const SlotBound& slot : report_.slots) cycles = std::max(cycles, slot.cycles);
    }
    cycles += part("schedule");
    std::uint64_t all = cycles;
    if ((mask & environment_) != 0) all += part("policy") + part("guard") + part("outcome");
    return {report_.time->seconds(all), report_.time->seconds(cycles)};
  }

  [[nodiscard]] std::uint64_t part(std::string_view name) const {
    const InstructionBound* found = report_.part(name);
    return found == nullptr ? 0 : found->cycles;
  }

  const BoundReport& report_;
  const Plan& plan_;
  std::uint64_t environment_;
  std::map<std::uint64_t, Times> known_;
  std::map<std::size_t, double> latest_;
};

/// "most of it: `engine` 1830.1 us, `policy` 64.2 us". What the nodes take in a step, if all slots
/// share one function.
std::string who_takes_most(const BoundReport& report, const Plan& plan, const SlotFit& slot) {
  const auto own = std::ranges::find(report.slots, std::optional(slot.mask), &SlotBound::due);
  const bool has_own = own != report.slots.end() && !own->nodes.empty();
  std::vector<std::pair<double, std::string>> parts;
  for (const InstructionBound& row : has_own ? own->nodes : report.nodes) {
    const auto node = std::ranges::find(plan.graph->nodes, row.name, &GraphNode::name);
    if (node == plan.graph->nodes.end()) continue;
    const auto index = static_cast<std::size_t>(node - plan.graph->nodes.begin());
    if ((slot.mask >> plan.nodes[index].rate & 1U) != 0)
      parts.emplace_back(report.time->seconds(row.cycles), row.name);
  }
  const bool ends_step = (slot.mask >> environment_rate(plan) & 1U) != 0;
  if (const InstructionBound* policy = report.part("policy"); policy != nullptr && ends_step)
    parts.emplace_back(report.time->seconds(policy->cycles), policy->name);
  std::ranges::sort(parts, std::greater<>());
  constexpr std::size_t kShown = 3;
  std::string text = has_own ? "most of it: " : "most of it, in a step: ";
  for (std::size_t i = 0; i < std::min(kShown, parts.size()); ++i)
    text += fmt::format("{}`{}` {:.1f} us", i == 0 ? "" : ", ", parts[i].second,
                        parts[i].first * kMicro);
  return parts.empty() ? "" : text;
}

std::string line_of(const char* what, const std::string& name, double busy_s, double of_s) {
  return fmt::format("  {}: {}{:.1f} us of {:.1f} us, {:.1f} %\n", what, name, busy_s * kMicro,
                     of_s * kMicro, kPercent * busy_s / of_s);
}

Json slot_json(const SlotFit& slot) {
  return {{"name", slot.name},
          {"us", slot.busy_s * kMicro},
          {"until_next_us", slot.until_next_s * kMicro},
          {"load", slot.load()}};
}

std::string why_no_fit(const BoundReport& report) {
  if (!report.time) return report.why_no_time;
  if (!has_all_bounds(report)) return "not all of its parts have a bound";
  return "its slots cannot be counted";
}

}  // namespace

std::optional<Fit> fit_of(const BoundReport& report, const Plan& plan) {
  constexpr std::uint64_t kMostSlots = 1'000'000;
  if (!report.time || report.slots.empty() || !has_all_bounds(report)) return std::nullopt;
  if (!plan.schedule.slots || *plan.schedule.slots > kMostSlots) return std::nullopt;
  return Fitting(report, plan).fit();
}

std::string fit_text(const Fit& fit) {
  std::string text = "time of slots, with the policy and the guard behind a step\n";
  text += line_of("busiest slot", fit.busiest.name + ", ", fit.busiest.busy_s,
                  fit.busiest.until_next_s);
  text += line_of("hyperperiod", "", fit.busy_s, fit.hyperperiod_s);
  for (const Fit::Outputs& outputs : fit.outputs)
    text += fmt::format("  outputs of {}: at most {:.1f} us after their slot begins\n",
                        outputs.rate, outputs.latest_s * kMicro);
  if (fit.busiest.load() > 1) text += "  slots may be late\n";
  return text;
}

std::string busiest_text(const Fit& fit) {
  const SlotFit& slot = fit.busiest;
  return fmt::format("the slot of {} takes up to {:.1f} % of its time, {:.1f} us of {:.1f} us",
                     slot.name, kPercent * slot.load(), slot.busy_s * kMicro,
                     slot.until_next_s * kMicro);
}

Json fit_json(const Fit& fit) {
  Json json{{"busiest", slot_json(fit.busiest)},
            {"longest", slot_json(fit.longest)},
            {"hyperperiod_us", fit.hyperperiod_s * kMicro},
            {"busy_us", fit.busy_s * kMicro}};
  Json outputs = Json::list();
  for (const Fit::Outputs& one : fit.outputs)
    outputs.push_back(Json{{"rate", one.rate}, {"latest_us", one.latest_s * kMicro}});
  json["outputs"] = std::move(outputs);
  return json;
}

bool limits_time(const BudgetSpec& budget) {
  return budget.time || budget.slot;
}

void check_time_budget(const BoundReport& report, const std::optional<Fit>& fit, const Plan& plan,
                       const BudgetSpec& budget, Diagnostics& diagnostics) {
  if (!fit) {
    for (const auto& entry : {budget.time, budget.slot}) {
      if (entry)
        diagnostics.error(
            "E0422", entry->span,
            fmt::format("the time of slots has a budget, but no bound: {}", why_no_fit(report)));
    }
    return;
  }
  const auto exceeded = [&](const Span& span, const SlotFit& slot, const std::string& message) {
    diagnostics.error("E0420", span, message).help = who_takes_most(report, plan, slot);
  };
  if (budget.time) {
    const SlotFit& slot = fit->busiest;
    const double limit = budget.time->value.to_double();
    if (slot.load() > limit)
      exceeded(budget.time->span, slot,
               fmt::format("the slot of {} takes up to {:.1f} % of the time until the next one, "
                           "over its budget of {:.4g} %",
                           slot.name, kPercent * slot.load(), kPercent * limit));
  }
  if (budget.slot) {
    const SlotFit& slot = fit->longest;
    const double limit_s = budget.slot->value.to_double();
    if (slot.busy_s > limit_s)
      exceeded(budget.slot->span, slot,
               fmt::format("the slot of {} takes up to {:.1f} us, {:.1f} us over its budget of "
                           "{:.6g} us",
                           slot.name, kMicro * slot.busy_s, kMicro * (slot.busy_s - limit_s),
                           kMicro * limit_s));
  }
}

}  // namespace eagerx::gen
