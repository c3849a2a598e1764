#include "generator/graph/plan/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxRates = 64;
// Above this a table costs more flash than the countdown costs instructions (generator/README.md,
// "Design rationale").
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
    if (!ranges::contains(kinds, mask)) kinds.push_back(mask);
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

using Rates = std::vector<const GraphNode*>;

/// Quanta a second, such that every tick of every rate falls on one; overflowed if they cannot be
/// counted.
Rational grid_of(const std::vector<Rational>& rates) {
  Rational grid = rates.front();
  Rational slowest = grid;
  for (const Rational& rate : rates) {
    grid = lcm(grid, rate);
    if (rate < slowest) slowest = rate;
  }
  return (grid / slowest).overflowed() ? Rational(0, 0) : grid;
}

/// `rate` to the nearest multiple of `step`; zero if it is less, or was one already.
Rational rounded(const Rational& rate, const Rational& step) {
  const Rational near = Rational((rate / step + Rational(1, 2)).floor()) * step;
  return near.overflowed() || near == rate ? Rational() : near;
}

/// Leaves out as few of the last digits of the rates of `nodes` as are needed that all rates have a
/// grid; nothing if that does not help.
std::optional<std::vector<Rational>> fitting_rates(const Rates& nodes,
                                                   const std::vector<Rational>& rates) {
  constexpr std::int64_t kFinest = 1'000'000'000;
  std::vector<Rational> others = rates;
  for (const GraphNode* node : nodes) std::erase(others, node->rate_hz);
  for (Rational step(1, kFinest); step < Rational(kFinest); step = step * Rational(10)) {
    std::vector<Rational> all = others;
    for (const GraphNode* node : nodes) all.push_back(rounded(node->rate_hz, step));
    const bool any_zero = ranges::contains(all, Rational());
    if (!any_zero && !grid_of(all).overflowed())
      return std::vector<Rational>(all.end() - static_cast<std::ptrdiff_t>(nodes.size()),
                                   all.end());
  }
  return std::nullopt;
}

/// The rates to write instead of those of the first of `choices` for which there are any.
std::string help_of(const std::vector<Rates>& choices, const std::vector<Rational>& rates) {
  for (const Rates& nodes : choices) {
    const auto near = fitting_rates(nodes, rates);
    if (!near) continue;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      texts.push_back(fmt::format("{} Hz for `{}`", (*near)[i].to_string(), nodes[i]->name));
    return fmt::format("write {} that {}: {}",
                       nodes.size() == 1 ? "a rate near it" : "rates near them",
                       nodes.size() == 1 ? "fits" : "fit", join(texts, " and "));
  }
  return "write rates with common factors, such as multiples of 10 Hz, and with few digits";
}

/// Nodes whose rates have no grid with those of all others. The others are chosen one by one, each
/// time the rate with which the grid stays coarsest.
Rates misfits_of(Rates nodes) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<Rational> kept;
  const auto grid_with = [&kept](const GraphNode* node) {
    std::vector<Rational> all = kept;
    all.push_back(node->rate_hz);
    const Rational grid = grid_of(all);
    return grid.overflowed() ? kNone : grid.to_double();
  };
  while (!nodes.empty()) {
    const auto best = std::ranges::min_element(nodes, {}, grid_with);
    if (grid_with(*best) == kNone) break;
    kept.push_back((*best)->rate_hz);
    nodes.erase(best);
  }
  return nodes;
}

/// The two nodes whose rates fit worst, so that they or they with others have no grid.
std::pair<const GraphNode*, const GraphNode*> worst_pair(const Rates& nodes) {
  std::pair worst(nodes.front(), nodes.front());
  double most = 0;
  for (const GraphNode* a : nodes) {
    for (const GraphNode* b : nodes) {
      if (a == b) break;
      const Rational both = lcm(a->rate_hz, b->rate_hz);
      // How many ticks of the slower one until both tick together.
      const double ticks =
          both.overflowed() ? std::numeric_limits<double>::infinity()
                            : (both / std::min(a->rate_hz, b->rate_hz, std::less<>())).to_double();
      if (ticks > most) worst = {b, a};
      most = std::max(most, ticks);
    }
  }
  return worst;
}

void refuse_pair(const GraphNode& first, const GraphNode& second,
                 const std::vector<Rational>& rates, Diagnostics& diagnostics) {
  auto& problem = diagnostics.error(
      "E0402", second.span,
      fmt::format("`{}` at {} Hz and `{}` at {} Hz tick together too rarely to be counted",
                  first.name, first.rate_hz.to_string(), second.name, second.rate_hz.to_string()));
  problem.notes.push_back({fmt::format("`{}` is here", first.name), first.span, ""});
  problem.help = help_of({{&second}, {&first}, {&first, &second}}, rates);
}

/// Every two rates fit, but not all of them.
void refuse_misfits(const Rates& misfits, const std::vector<Rational>& rates,
                    Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const GraphNode* node : misfits)
    names.push_back(fmt::format("`{}` at {} Hz", node->name, node->rate_hz.to_string()));
  auto& problem = diagnostics.error(
      "E0402", misfits.front()->span,
      fmt::format("the {} rates of the graph have too few common factors: with {}, too, all tick "
                  "together only after more than 2^63 instants; without {} they can be counted",
                  rates.size(), join(names, ", "), names.size() == 1 ? "it" : "them"));
  problem.help = help_of({misfits}, rates);
}

std::optional<Rational> find_grid(const Graph& graph, Diagnostics& diagnostics) {
  Rates nodes;  // one of each rate
  std::vector<Rational> rates;
  for (const auto& node : graph.nodes) {
    if (ranges::contains(rates, node.rate_hz)) continue;
    rates.push_back(node.rate_hz);
    nodes.push_back(&node);
  }
  const Rational grid = grid_of(rates);
  if (!grid.overflowed()) return grid;
  const auto [first, second] = worst_pair(nodes);
  const Rates misfits = misfits_of(nodes);
  if (misfits.empty() || grid_of({first->rate_hz, second->rate_hz}).overflowed()) {
    refuse_pair(*first, *second, rates, diagnostics);
  } else {
    refuse_misfits(misfits, rates, diagnostics);
  }
  return std::nullopt;
}

}  // namespace

const char* text_of(ScheduleForm form) {
  switch (form) {
    case ScheduleForm::constants:
      return "masks known to the compiler";
    case ScheduleForm::kinds:
      return "a table of kinds of slots, masks known to the compiler";
    case ScheduleForm::table:
      return "a table of masks";
    case ScheduleForm::countdown:
      break;
  }
  return "a countdown a rate";
}

std::optional<std::vector<RateClass>> find_rates(const Graph& graph, Diagnostics& diagnostics) {
  std::vector<RateClass> rates;
  for (const auto& node : graph.nodes) {
    if (!ranges::contains(rates, node.rate_hz, &RateClass::rate_hz))
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
