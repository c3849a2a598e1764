#include "generator/plan/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxRates = 64;
// Above this a table costs more flash than the countdown costs instructions (generator/README.md,
// "Why it is so").
constexpr std::uint64_t kMaxTableSlots = 1024;
// Measured: constants take 1.4 to 2.3 times the compile time and text of a run-time mask, per
// distinct mask.
constexpr std::size_t kMaxSpecialisations = 600;  // nodes times kinds of slots
constexpr std::size_t kMaxRuns = 32;              // one line of a step each
constexpr std::size_t kMaxKinds = 32;             // one `case` of a step each

std::optional<std::uint64_t> checked_lcm(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  if (__builtin_mul_overflow(a / std::gcd(a, b), b, &result)) return std::nullopt;
  return result;
}

std::optional<std::vector<std::uint64_t>> list_slots(const std::vector<RateClass>& rates) {
  std::optional<std::uint64_t> hyperperiod = 1;
  for (const auto& rate : rates) {
    hyperperiod = hyperperiod ? checked_lcm(*hyperperiod, rate.period) : std::nullopt;
  }
  if (!hyperperiod) return std::nullopt;
  std::uint64_t ticks = 0;
  for (const auto& rate : rates) {
    ticks += *hyperperiod / rate.period;
    if (ticks > 8 * kMaxTableSlots) return std::nullopt;
  }
  std::vector<std::uint64_t> masks;
  for (std::uint64_t time = 0; time < *hyperperiod;) {
    std::uint64_t mask = 0;
    std::uint64_t next = *hyperperiod;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      if (time % rates[i].period == 0) mask |= std::uint64_t{1} << i;
      next = std::min(next, (time / rates[i].period + 1) * rates[i].period);
    }
    masks.push_back(mask);
    time = next;
  }
  return masks;
}

std::vector<Schedule::Run> runs_of(const std::vector<std::uint64_t>& masks) {
  std::vector<Schedule::Run> runs;
  for (const std::uint64_t mask : masks) {
    if (runs.empty() || runs.back().mask != mask) runs.push_back({mask, 0});
    ++runs.back().slots;
  }
  return runs;
}

std::vector<std::uint64_t> kinds_of(const std::vector<std::uint64_t>& masks) {
  std::vector<std::uint64_t> kinds;
  for (const std::uint64_t mask : masks) {
    if (std::ranges::find(kinds, mask) == kinds.end()) kinds.push_back(mask);
  }
  return kinds;
}

/// A step that is no hyperperiod may begin at any of its slots. With few kinds of slots each has a
/// specialisation all the same, chosen at run time: 45 instructions a slot on a Cortex-M4F besides
/// the callbacks, instead of 73 with masks (tests/bench/scheduler).
ScheduleForm choose_form(const Schedule& schedule, std::size_t environment, std::size_t nodes,
                         bool any_slot) {
  const std::uint64_t environment_bit = std::uint64_t{1} << environment;
  const auto observes = [&](std::uint64_t mask) { return (mask & environment_bit) != 0; };
  const bool is_one_step = std::ranges::count_if(schedule.masks, observes) == 1;
  const bool is_specialised = nodes * schedule.kinds.size() <= kMaxSpecialisations;
  if (is_one_step && is_specialised && schedule.runs.size() <= kMaxRuns &&
      (!any_slot || schedule.masks.size() == 1))
    return ScheduleForm::constants;
  if (schedule.masks.size() > kMaxTableSlots) return ScheduleForm::countdown;
  return is_specialised && schedule.kinds.size() <= kMaxKinds && !any_slot ? ScheduleForm::kinds
                                                                           : ScheduleForm::table;
}

/// Quanta a second, such that every tick of every rate falls on one.
std::optional<Rational> find_grid(const Graph& graph, Diagnostics& diagnostics) {
  Rational grid = graph.environment().rate_hz;
  Rational slowest = grid;
  for (const auto& node : graph.nodes) {
    const Rational finer = lcm(grid, node.rate_hz);
    slowest =
        std::min(slowest, node.rate_hz, [](const Rational& a, const Rational& b) { return a < b; });
    if (finer.overflowed() || (finer / slowest).overflowed()) {
      diagnostics
          .error(
              "E0402", node.span,
              fmt::format("the rate {} Hz of `{}` and the rates before it have no common grid that "
                          "fits into 63 bits",
                          node.rate_hz.to_string(), node.name))
          .help = "write rates with fewer decimals";
      return std::nullopt;
    }
    grid = finer;
  }
  return grid;
}

}  // namespace

std::optional<std::vector<RateClass>> find_rates(const Graph& graph, Diagnostics& diagnostics) {
  std::vector<RateClass> rates;
  for (const auto& node : graph.nodes) {
    if (std::ranges::find(rates, node.rate_hz, &RateClass::rate_hz) == rates.end())
      rates.push_back({node.rate_hz, 1});
  }
  std::ranges::sort(rates, std::ranges::greater(), &RateClass::rate_hz);
  if (rates.size() > kMaxRates) {
    diagnostics.error("E0403", graph.span,
                      fmt::format("the graph has {} different rates; there can be at most {}",
                                  rates.size(), kMaxRates));
    return std::nullopt;
  }
  const auto grid = find_grid(graph, diagnostics);
  if (!grid) return std::nullopt;
  for (auto& rate : rates) rate.period = static_cast<std::uint64_t>((*grid / rate.rate_hz).num());
  return rates;
}

Schedule make_schedule(const std::vector<RateClass>& rates, std::size_t environment,
                       std::size_t nodes, bool any_slot) {
  Schedule schedule;
  auto masks = list_slots(rates);
  if (!masks) return schedule;
  schedule.slots = masks->size();
  schedule.runs = runs_of(*masks);
  schedule.kinds = kinds_of(*masks);
  schedule.masks = std::move(*masks);
  schedule.form = choose_form(schedule, environment, nodes, any_slot);
  if (schedule.form != ScheduleForm::countdown) return schedule;
  Schedule countdown;
  countdown.slots = schedule.slots;
  return countdown;
}

}  // namespace eagerx::gen
