#include "generator/plan/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxRates = 64;
// Above this a table costs more flash than the countdown costs instructions (generator/README.md,
// "Why it is so").
constexpr std::uint64_t kMaxTableSlots = 1024;
// Measured: constants take 1.4 to 2.3 times the compile time and text of a run-time mask, per
// distinct mask.
constexpr std::size_t kMaxSpecialisations = 600;  // nodes times distinct masks
constexpr std::size_t kMaxConstantSlots = 32;

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

/// Neighbouring slots that are alike count once: they become a loop.
std::size_t runs_of(const std::vector<std::uint64_t>& masks) {
  std::size_t runs = 1;
  for (std::size_t i = 1; i < masks.size(); ++i) runs += masks[i] != masks[i - 1] ? 1 : 0;
  return runs;
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
          .error("E0402", node.span,
                 fmt::format("the {} Hz of `{}` and the rates before it have no common grid that "
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
    diagnostics.error(
        "E0403", graph.span,
        fmt::format("the graph has {} different rates; the most are {}", rates.size(), kMaxRates));
    return std::nullopt;
  }
  const auto grid = find_grid(graph, diagnostics);
  if (!grid) return std::nullopt;
  for (auto& rate : rates) rate.period = static_cast<std::uint64_t>((*grid / rate.rate_hz).num());
  return rates;
}

Schedule make_schedule(const std::vector<RateClass>& rates, std::size_t environment,
                       std::size_t nodes, bool resets) {
  Schedule schedule;
  auto masks = list_slots(rates);
  if (masks) schedule.slots = masks->size();
  if (!masks || masks->size() > kMaxTableSlots * (runs_of(*masks) <= kMaxConstantSlots ? 8 : 1)) {
    schedule.form = ScheduleForm::countdown;
    return schedule;
  }
  const std::uint64_t environment_bit = std::uint64_t{1} << environment;
  const bool one_step = std::ranges::count_if(*masks, [&](std::uint64_t m) {
                          return (m & environment_bit) != 0;
                        }) == 1;
  const std::set<std::uint64_t> distinct(masks->begin(), masks->end());
  const bool constants = one_step && (!resets || masks->size() == 1) &&
                         runs_of(*masks) <= kMaxConstantSlots &&
                         nodes * distinct.size() <= kMaxSpecialisations;
  schedule.form = constants ? ScheduleForm::constants : ScheduleForm::table;
  if (!constants && masks->size() > kMaxTableSlots) {
    schedule.form = ScheduleForm::countdown;
    return schedule;
  }
  schedule.masks = std::move(*masks);
  return schedule;
}

}  // namespace eagerx::gen
