#include "generator/graph/plan/ages.hpp"

#include <algorithm>
#include <numeric>

namespace eagerx::gen {
namespace {

using Path = std::vector<const PathEdge*>;

constexpr std::int64_t kMaxHyperperiod = std::int64_t{1} << 50;  // in quanta
constexpr std::int64_t kMaxLookUps = 3'000'000;                  // of one pair

std::int64_t newest_bound(const Path& path) {
  std::int64_t sum = 0;
  for (const PathEdge* edge : path) sum += edge->newest_bound;
  return sum;
}

std::int64_t oldest_bound(const Path& path) {
  std::int64_t sum = 0;
  for (const PathEdge* edge : path) sum += edge->oldest_bound;
  return sum;
}

/// When every tick on the path has settled.
std::int64_t settled(const Path& path) {
  std::int64_t sum = 0;
  for (const PathEdge* edge : path) sum += edge->settled * edge->period + edge->oldest_bound;
  return sum;
}

struct Worst {
  std::int64_t newest = 0, oldest = 0;
};

/// Tick by tick over a hyperperiod; nullopt if that is too long.
std::optional<Worst> worst_tick(const Paths& paths) {
  std::int64_t hyperperiod = 1, start = 0, edges = 0;
  for (const Path& path : paths.all) {
    edges += static_cast<std::int64_t>(path.size());
    start = std::max(start, settled(path));
    for (const PathEdge* edge : path) {
      for (const std::int64_t period : {edge->period, edge->source_period}) {
        const std::int64_t factor = period / std::gcd(hyperperiod, period);
        if (factor > kMaxHyperperiod / hyperperiod) return std::nullopt;
        hyperperiod *= factor;
      }
    }
  }
  const std::int64_t period = paths.all.front().front()->period;  // of the last reader
  const std::int64_t ticks = hyperperiod / period;
  if (ticks > kMaxLookUps / edges) return std::nullopt;
  const std::int64_t first = start / period + 1;
  Worst worst;
  for (std::int64_t tick = first; tick < first + ticks; ++tick) {
    std::int64_t freshest = kMaxHyperperiod;
    for (const Path& path : paths.all) {
      std::int64_t newest = tick, oldest = tick;
      for (const PathEdge* edge : path) {
        newest = edge->newest(newest);
        oldest = edge->oldest(oldest);
      }
      const std::int64_t born = path.back()->source_period;
      freshest = std::min(freshest, tick * period - newest * born);
      worst.oldest = std::max(worst.oldest, tick * period - oldest * born);
    }
    worst.newest = std::max(worst.newest, freshest);
  }
  return worst;
}

class Ages {
 public:
  Ages(const Plan& plan, const PathEnds& ends) : plan_(plan) {
    const Graph& graph = *plan.graph;
    if (ends.from_actions && ends.to_observations && !graph.has_engine())
      step_s_ = Rational(1) / plan.rates[plan.nodes.front().rate].rate_hz;
  }

  DataAge of(const PathFinder::Pair& pair, const Paths& paths) const {
    const Path& best = *std::ranges::min_element(paths.all, {}, newest_bound);
    DataAge age;
    age.from = pair.first;
    age.to = pair.second;
    const auto worst = paths.complete ? worst_tick(paths) : std::nullopt;
    age.exact = worst.has_value();
    age.newest_s = seconds(worst ? worst->newest : newest_bound(best)) - step_s_;
    if (worst) {
      age.oldest_s = seconds(worst->oldest) - step_s_;
    } else if (paths.complete) {
      std::int64_t most = 0;
      for (const Path& path : paths.all) most = std::max(most, oldest_bound(path));
      age.oldest_s = seconds(most) - step_s_;
    }
    const Path from_source(best.rbegin(), best.rend());
    for (const PathEdge* edge : from_source) {
      const Input& input = plan_.graph->nodes[edge->node].inputs[edge->input];
      age.path.push_back({input.written, input.span, seconds(edge->newest_bound)});
    }
    take_off_step(age.path);
    return age;
  }

 private:
  /// All that happens within a step happens at one time: its end takes nothing of it.
  void take_off_step(std::vector<AgeEdge>& path) const {
    Rational rest = step_s_;
    for (auto edge = path.rbegin(); edge != path.rend() && rest > Rational(); ++edge) {
      const Rational part = edge->newest_s < rest ? edge->newest_s : rest;
      edge->newest_s = edge->newest_s - part;
      rest = rest - part;
    }
  }

  Rational seconds(std::int64_t quanta) const {
    const RateClass& fastest = plan_.rates.front();
    return Rational(quanta) /
           (fastest.rate_hz * Rational(static_cast<std::int64_t>(fastest.period)));
  }

  const Plan& plan_;
  Rational step_s_;  // that is not counted
};

}  // namespace

DataAges::DataAges(const Plan& plan, const PathEnds& ends) : finder_(plan, ends) {
  const Ages ages(plan, ends);
  for (const auto& [pair, paths] : finder_.paths()) known_.push_back(ages.of(pair, paths));
}

}  // namespace eagerx::gen
