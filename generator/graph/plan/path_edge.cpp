#include "generator/graph/plan/path_edge.hpp"

#include <numeric>

#include "generator/graph/plan/counts.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kMaxQuanta = std::int64_t{1} << 50;  // sums and products stay in 64 bits
constexpr std::int64_t kMaxTicks = 1'000'000;               // that are gone through to settle

struct Settled {
  std::int64_t received = 0, tick = 0;  // as in PathEdge
};

/// From the first ticks, which the formula treats apart, to the sum that continues without end;
/// nullopt if that takes too long.
std::optional<Settled> settle(const PathEdge& edge, const Counts& counts) {
  std::int64_t total = 0;
  const std::int64_t most = ceil_div(counts.a, counts.b);
  for (std::int64_t n = 0; n < kMaxTicks; ++n) {
    total += counts.at(n);
    // From here on no count is cut short by what has not been sent yet.
    if (n > 0 && counts.cum(n) >= most && total >= edge.window)
      return Settled{total - counts.cum(n + edge.off), n};
  }
  return std::nullopt;
}

}  // namespace

std::int64_t PathEdge::total(std::int64_t n) const {
  return received + floor_div(a * (n + off) - x, b);
}

std::int64_t PathEdge::oldest(std::int64_t n) const {
  if (window > 0) return total(n) - window;
  const std::int64_t before = total(n - 1);
  return before == total(n) ? before - 1 : before;
}

std::optional<PathEdge> make_path_edge(const Plan& plan, std::size_t node, std::size_t input) {
  const Input& what = plan.graph->nodes[node].inputs[input];
  const Reception& reception = plan.nodes[node].receptions[input];
  const RateClass& source = plan.rates[plan.nodes[what.source_node].rate];
  const RateClass& own = plan.rates[plan.nodes[node].rate];
  PathEdge edge;
  edge.node = node;
  edge.input = input;
  edge.a = reception.a;
  edge.b = reception.b;
  edge.off = reception.off;
  edge.window = what.window;
  const Rational longest = what.max_delay_s.value_or(what.delay_s);
  edge.x = (Rational(edge.b) * source.rate_hz * longest).ceil();
  if (source.period > kMaxQuanta || own.period > kMaxQuanta) return std::nullopt;
  edge.source_period = static_cast<std::int64_t>(source.period);
  edge.period = static_cast<std::int64_t>(own.period);
  const auto settled = settle(edge, {edge.a, edge.b, edge.x, what.skip});
  if (!settled) return std::nullopt;
  edge.received = settled->received;
  edge.settled = settled->tick;
  // n / rate - newest(n) / source rate, in steps of a quantum common to both.
  const std::int64_t step = std::gcd(edge.source_period, edge.period);
  const std::int64_t steps = edge.x + edge.b - 1 - edge.b * (edge.received - 1) - edge.a * edge.off;
  if (steps > kMaxQuanta / step) return std::nullopt;
  edge.newest_bound = steps * step;
  const std::int64_t more = (edge.window == 0 ? ceil_div(edge.a, edge.b) : edge.window) - 1;
  if (more > kMaxQuanta / edge.source_period) return std::nullopt;
  edge.oldest_bound = edge.newest_bound + more * edge.source_period;
  return edge;
}

}  // namespace eagerx::gen
