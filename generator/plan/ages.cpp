#include "generator/plan/ages.hpp"

#include <algorithm>
#include <numeric>

#include "generator/plan/ways.hpp"

namespace eagerx::gen {
namespace {

using Way = std::vector<const Hop*>;

constexpr std::int64_t kMaxHyperperiod = std::int64_t{1} << 50;  // in quanta
constexpr std::int64_t kMaxLookUps = 3'000'000;                  // of one pair

std::int64_t newest_bound(const Way& way) {
  std::int64_t sum = 0;
  for (const Hop* hop : way) sum += hop->newest_bound;
  return sum;
}

std::int64_t oldest_bound(const Way& way) {
  std::int64_t sum = 0;
  for (const Hop* hop : way) sum += hop->oldest_bound;
  return sum;
}

/// When every tick on the way has settled.
std::int64_t settled(const Way& way) {
  std::int64_t sum = 0;
  for (const Hop* hop : way) sum += hop->settled * hop->period + hop->oldest_bound;
  return sum;
}

struct Worst {
  std::int64_t newest = 0, oldest = 0;
};

/// Tick by tick over a hyperperiod; nullopt if that is too long.
std::optional<Worst> worst_tick(const Ways& ways) {
  std::int64_t hyperperiod = 1, start = 0, hops = 0;
  for (const Way& way : ways.all) {
    hops += static_cast<std::int64_t>(way.size());
    start = std::max(start, settled(way));
    for (const Hop* hop : way) {
      for (const std::int64_t period : {hop->period, hop->source_period}) {
        const std::int64_t factor = period / std::gcd(hyperperiod, period);
        if (factor > kMaxHyperperiod / hyperperiod) return std::nullopt;
        hyperperiod *= factor;
      }
    }
  }
  const std::int64_t period = ways.all.front().front()->period;  // of the actuator
  const std::int64_t ticks = hyperperiod / period;
  if (ticks > kMaxLookUps / hops) return std::nullopt;
  const std::int64_t first = start / period + 1;
  Worst worst;
  for (std::int64_t tick = first; tick < first + ticks; ++tick) {
    std::int64_t freshest = kMaxHyperperiod;
    for (const Way& way : ways.all) {
      std::int64_t newest = tick, oldest = tick;
      for (const Hop* hop : way) {
        newest = hop->newest(newest);
        oldest = hop->oldest(oldest);
      }
      const std::int64_t born = way.back()->source_period;
      freshest = std::min(freshest, tick * period - newest * born);
      worst.oldest = std::max(worst.oldest, tick * period - oldest * born);
    }
    worst.newest = std::max(worst.newest, freshest);
  }
  return worst;
}

class Ages {
 public:
  explicit Ages(const Plan& plan) : plan_(plan) {}

  DataAge of(const WayFinder::Pair& pair, const Ways& ways) const {
    const Way& best = *std::ranges::min_element(ways.all, {}, newest_bound);
    DataAge age;
    age.sensor = pair.first;
    age.actuator = pair.second;
    const auto worst = ways.complete ? worst_tick(ways) : std::nullopt;
    age.exact = worst.has_value();
    age.newest_s = seconds(worst ? worst->newest : newest_bound(best));
    if (worst) {
      age.oldest_s = seconds(worst->oldest);
    } else if (ways.complete) {
      std::int64_t most = 0;
      for (const Way& way : ways.all) most = std::max(most, oldest_bound(way));
      age.oldest_s = seconds(most);
    }
    const Way from_sensor(best.rbegin(), best.rend());
    for (const Hop* hop : from_sensor) {
      const Input& input = plan_.graph->nodes[hop->node].inputs[hop->input];
      age.way.push_back({input.written, input.span, seconds(hop->newest_bound)});
    }
    return age;
  }

 private:
  Rational seconds(std::int64_t quanta) const {
    const RateClass& fastest = plan_.rates.front();
    return Rational(quanta) /
           (fastest.rate_hz * Rational(static_cast<std::int64_t>(fastest.period)));
  }

  const Plan& plan_;
};

}  // namespace

DataAges data_ages(const Plan& plan) {
  const WayFinder finder(plan);
  const Ages ages(plan);
  DataAges result;
  for (const auto& [pair, ways] : finder.ways()) result.known.push_back(ages.of(pair, ways));
  result.unknown = finder.unknown();
  return result;
}

}  // namespace eagerx::gen
