#include "generator/graph/plan/vectorized.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/graph/plan/schedule.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMostNodes = 100;                       // one function holds all of them
constexpr std::size_t kMostPhases = 5;                        // groups for the same environments
constexpr std::int64_t kMostOfRatio = std::int64_t{1} << 30;  // what lanes count with

/// The environment's ticks in the hyperperiod.
std::size_t steps_in_phases(const Plan& plan, const Schedule& schedule) {
  const std::uint64_t environment = std::uint64_t{1} << plan.nodes[Graph::kEnvironment].rate;
  return static_cast<std::size_t>(std::ranges::count_if(
      schedule.masks, [&](std::uint64_t mask) { return (mask & environment) != 0; }));
}

/// Of an entity that is not vectorized.
const char* why_not_vectorized(const Entity& entity) {
  return entity.vectorized.empty() ? "has no `vectorized: true` in its manifest"
                                   : "is vectorized under a condition, which does not hold";
}

std::string why_not(const GraphNode& node, bool by_lane_too) {
  const bool only_resets = !node.reset_targets.empty();  // groups pass its feedthroughs on
  const bool by_lane = by_lane_too && runs_lane_by_lane(node);
  if (node.entity != nullptr && !only_resets && !by_lane && !runs_vectorized(node))
    return fmt::format("`{}` ({}) {}", node.name, node.entity->id.value,
                       why_not_vectorized(*node.entity));
  const auto converts = [&](const std::optional<Processor>& processor) {
    return !processor || by_lane_too || runs_vectorized(*processor);
  };
  const auto of = [](const std::optional<Processor>& processor, const std::string& where) {
    return fmt::format(
        "the processor of `{}` ({}) has no `vectorized: true` in its manifest, or its condition "
        "does "
        "not hold",
        where, processor->names());
  };
  for (const auto& input : node.inputs) {
    if (!converts(input.processor)) return of(input.processor, input.written);
    if (input.window == 0 && !by_lane && node.role != NodeRole::environment)
      return fmt::format("`{}` has `window: 0`, so lanes get different numbers of messages",
                         input.written);
  }
  for (const auto& output : node.outputs) {
    if (!converts(output.processor)) return of(output.processor, node.name + "." + output.name);
  }
  return {};
}

/// Of a step that is no hyperperiod. Each SIMD group is then in one phase of it, and there are as
/// many groups for the same environments as there are phases.
std::string why_no_phases(const Plan& plan, const Schedule& schedule) {
  const Graph& graph = *plan.graph;
  const Rational& rate_hz = graph.environment().rate_hz;
  const bool counts_down = schedule.form == ScheduleForm::countdown;
  // Where an environment continues alone is the same slot only if its own program has the same
  // ones.
  const bool own_slots = schedule.masks != plan.schedule.masks;
  if (!counts_down && !own_slots && steps_in_phases(plan, schedule) <= kMostPhases) return {};
  for (const auto& node : graph.nodes) {
    if (node.drawn || (node.rate_hz / rate_hz).is_integer()) continue;
    return fmt::format(
        "`{}` runs at {} Hz, {} the environment's {} Hz", node.name, node.rate_hz.to_string(),
        own_slots && !counts_down ? "and pictures at another rate; it is not a multiple of"
                                  : "no multiple of",
        rate_hz.to_string());
  }
  return "a step has too many slots";
}

/// Rates and delays.
std::string why_not_in_time(const Plan& plan) {
  const Graph& graph = *plan.graph;
  if (!graph.safety.outputs.empty())
    return "a graph without an engine stands still while its outputs are safe (`safety: {outputs: "
           "none}` if nothing acts on them)";
  const Schedule schedule = vectorized_schedule(plan);
  if (schedule.form != ScheduleForm::constants) {
    if (std::string reason = why_no_phases(plan, schedule); !reason.empty()) return reason;
  }
  // Its tick 0, at which it does nothing, is then in a reset.
  if (graph.has_engine() && !ranges::contains(plan.before, Graph::kEngine))
    return "the engine waits for actions";
  for (const auto& node : plan.nodes) {
    for (const auto& reception : node.receptions) {
      if (reception.a >= kMostOfRatio || reception.b >= kMostOfRatio)
        return "a ratio of rates is too large";
    }
  }
  return {};
}

/// Messages are float32, whole numbers or truth values, and found by counts modulo 2^32.
std::string why_not_in_memory(const Plan& plan) {
  for (const auto& ring : plan.rings) {
    const GraphNode& node = plan.graph->nodes[ring.node];
    const GraphNode* const reader =
        ring.reader_node ? &plan.graph->nodes[*ring.reader_node] : nullptr;
    if (node.drawn || (reader != nullptr && reader->drawn)) continue;
    const std::string name = node.name + "." + node.outputs[ring.output].name;
    const Dtype raw = node.outputs[ring.output].raw.dtype;
    for (const Dtype dtype : {ring.space.dtype, raw}) {
      if (dtype == Dtype::float64) return fmt::format("`{}` is {}", name, to_string(dtype));
    }
    if ((ring.capacity & (ring.capacity - 1)) != 0)
      return fmt::format("the messages of `{}` are too long", name);
  }
  return {};
}

/// Where nodes stand in a step: those behind the environment, then those up to its next tick. These
/// come several times a step if they are faster than it, the others first then.
struct Place {
  bool is_after = false;
  std::size_t position = 0;
};
std::vector<Place> places_in_step(const Plan& plan) {
  std::vector<Place> places(plan.nodes.size());
  for (std::size_t i = 0; i < plan.before.size(); ++i) places[plan.before[i]] = {false, i};
  for (std::size_t i = 0; i < plan.after.size(); ++i) places[plan.after[i]] = {true, i};
  return places;
}

/// Whether `writer` has sent a message in every step before `reader` looks.
bool writes_first(const Plan& plan, const std::vector<Place>& places, std::size_t writer,
                  std::size_t reader) {
  if (reader == Graph::kEnvironment) return false;  // it sees the messages when the step is over
  // Actions are the first of a step; what the engine sends are its ticks, which the group knows.
  const bool is_engine = plan.graph->has_engine() && writer == Graph::kEngine;
  if (writer == Graph::kEnvironment || is_engine) return true;
  const Place &from = places[writer], &to = places[reader];
  if (from.is_after) return !to.is_after || from.position < to.position;
  const Rational ratio =
      plan.rates[plan.nodes[writer].rate].rate_hz / plan.rates[plan.nodes[reader].rate].rate_hz;
  return !to.is_after && from.position < to.position && ratio == Rational(ratio.ceil());
}

}  // namespace

bool runs_lane_by_lane(const GraphNode& node) {
  const bool counts_messages =
      ranges::any_of(node.inputs, [](const Input& input) { return input.window == 0; });
  return node.role == NodeRole::node && node.entity != nullptr && node.reset_targets.empty() &&
         (counts_messages || !runs_vectorized(node));
}

std::vector<bool> vectorized_rates(const Plan& plan) {
  std::vector<bool> needed(plan.rates.size());
  for (std::size_t n = 0; n < plan.nodes.size(); ++n) {
    if (!plan.graph->nodes[n].drawn) needed[plan.nodes[n].rate] = true;
  }
  return needed;
}

Schedule vectorized_schedule(const Plan& plan) {
  const std::vector<bool> needed = vectorized_rates(plan);
  if (plan.schedule.form == ScheduleForm::constants && !ranges::contains(needed, false))
    return plan.schedule;
  std::vector<RateClass> rates;
  std::vector<std::size_t> bit;  // in masks of the plan
  std::size_t environment = 0;
  for (std::size_t r = 0; r < plan.rates.size(); ++r) {
    if (!needed[r]) continue;
    if (r == plan.nodes[Graph::kEnvironment].rate) environment = rates.size();
    rates.push_back(plan.rates[r]);
    bit.push_back(r);
  }
  Schedule schedule = make_schedule(rates, environment, plan.nodes.size());
  const auto widen = [&](std::uint64_t& mask) {
    std::uint64_t wide = 0;
    for (std::size_t i = 0; i < bit.size(); ++i) wide |= (mask >> i & 1U) << bit[i];
    mask = wide;
  };
  std::ranges::for_each(schedule.masks, widen);
  std::ranges::for_each(schedule.kinds, widen);
  std::ranges::for_each(schedule.runs, widen, &Schedule::Run::mask);
  return schedule;
}

std::vector<bool> passing_rings(const Plan& plan) {
  const auto& nodes = plan.graph->nodes;
  const auto resets = [](const GraphNode& node) { return !node.reset_targets.empty(); };
  if (plan.schedule.form != ScheduleForm::constants || ranges::any_of(nodes, resets))
    return std::vector<bool>(plan.rings.size());
  const std::vector<Place> places = places_in_step(plan);
  std::vector<bool> passing;
  for (const Ring& ring : plan.rings) passing.push_back(ring.capacity == 1);
  for (std::size_t n = 0; n < plan.nodes.size(); ++n) {
    if (nodes[n].drawn) continue;  // SIMD groups show no pictures
    for (const Reception& reception : plan.nodes[n].receptions) {
      const bool is_plain = reception.count == Reception::Count::ticks ||
                            reception.count == Reception::Count::ticks_but_one;
      if (!is_plain || !writes_first(plan, places, plan.rings[reception.ring].node, n))
        passing[reception.ring] = false;
    }
  }
  return passing;
}

std::size_t steps_in_hyperperiod(const Plan& plan) {
  if (plan.schedule.form == ScheduleForm::constants) return 1;
  return std::max<std::size_t>(1, steps_in_phases(plan, plan.schedule));
}

std::string why_not_vectorized(const Plan& plan) {
  const Graph& graph = *plan.graph;
  if (graph.asynchronous) return "`sync: false` reads inputs by the clock";
  if (graph.double_precision) return "`real: double`";
  if (graph.nodes.size() > kMostNodes) return "the graph has too many nodes";
  for (const auto& node : graph.nodes) {
    if (node.drawn) continue;  // SIMD groups show no pictures
    if (std::string reason = why_not(node, graph.has_engine()); !reason.empty()) return reason;
  }
  for (const auto& item : graph.objects) {
    if (!item.implementation->vectorized)
      return fmt::format("the `model:` of `{}` ({}) has no `vectorized: true` in its manifest",
                         item.name, item.entity->id.value);
  }
  if (std::string reason = why_not_in_time(plan); !reason.empty()) return reason;
  return why_not_in_memory(plan);
}

}  // namespace eagerx::gen
