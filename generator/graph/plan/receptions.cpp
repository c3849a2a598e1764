#include "generator/graph/plan/receptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/graph/plan/counts.hpp"

namespace eagerx::gen {
namespace {

constexpr std::int64_t kMaxTerm = std::int64_t{1}
                                  << 40;  // of a and b: products with ticks stay in 64 bits
constexpr std::int64_t kMaxSimulatedTicks = 2'000'000;  // to find the exact need of a ring

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

std::int64_t nanoseconds(const Rational& seconds) {
  return (seconds * Rational(kNsPerSecond)).ceil();
}

/// The longest delay in s. One that an entity sets may come from a float32 state: 0.1 is then
/// 0.10000000149. A skipped input has no room for that: it would have no message at tick 1.
Rational longest_of(const Input& input) {
  if (!input.max_delay_s) return input.delay_s;
  if (!input.entity_sets_delay || input.skip) return *input.max_delay_s;
  const auto single = static_cast<double>(static_cast<float>(input.max_delay_s->to_double()));
  constexpr double kLargest_s = 9e9;  // in nanoseconds, 63 bits
  if (!(single < kLargest_s)) return *input.max_delay_s;
  const Rational rounded(static_cast<std::int64_t>(std::ceil(single * kNsPerSecond)), kNsPerSecond);
  return std::max(*input.max_delay_s, rounded);
}

std::optional<Counts> counts_of(const Input& input, const Rational& source_rate,
                                const Rational& rate, Diagnostics& diagnostics) {
  const Rational ratio = source_rate / rate;
  const Rational quanta = Rational(ratio.den()) * source_rate * longest_of(input);
  if (ratio.overflowed() || quanta.overflowed() || ratio.num() > kMaxTerm ||
      ratio.den() > kMaxTerm || quanta.ceil() > kMaxTerm) {
    diagnostics.error(
        "E0402", input.span,
        fmt::format(
            "the rates {} Hz and {} Hz with a delay of {} s are too far apart to count exactly",
            source_rate.to_string(), rate.to_string(),
            input.max_delay_s.value_or(input.delay_s).to_string()));
    return std::nullopt;
  }
  const Rational now = Rational(ratio.den()) * source_rate * input.delay_s;
  return Counts{ratio.num(), ratio.den(), now.ceil(), input.skip};
}

/// Values with which a program turns a delay into x.
std::optional<Reception::Changing> changing_of(const Input& input, const Counts& counts,
                                               const Rational& source_rate,
                                               Diagnostics& diagnostics) {
  const Rational factor =
      Rational(counts.b) * source_rate / Rational(kNsPerSecond);  // quanta in a nanosecond
  Reception::Changing changing;
  changing.num = factor.num();
  changing.den = factor.den();
  changing.first_ns = nanoseconds(input.delay_s);
  changing.longest_ns = nanoseconds(longest_of(input));
  std::int64_t product = 0;
  const bool fits = !factor.overflowed() &&
                    !__builtin_mul_overflow(changing.num, changing.longest_ns, &product) &&
                    !__builtin_add_overflow(product, changing.den, &product);
  if (fits) return changing;
  diagnostics.error(
      "E0402", input.span,
      fmt::format("a delay of up to {} s at {} Hz is too long to count in nanoseconds",
                  input.max_delay_s->to_string(), source_rate.to_string()));
  return std::nullopt;
}

/// Advice for a skipped input without a message at tick 1.
std::string advice(Counts counts, const Rational& source_rate) {
  constexpr std::int64_t kMostTried = 100'000;
  // At tick 1 at most floor((a - x) / b) + 1 messages can be there: none for x > a.
  const std::int64_t first = std::min(counts.x, counts.a);
  for (std::int64_t x = first; x >= 0 && x > first - kMostTried; --x) {
    counts.x = x;
    if (counts.at(1) == 0) continue;
    if (x == 0) return "leave the delay out, or take `window: 0`, which may be empty";
    const Rational longest = Rational(x) / (Rational(counts.b) * source_rate);
    return fmt::format("shorten the delay to at most {} s, or take `window: 0`, which may be empty",
                       longest.to_string());
  }
  return "take `window: 0`, which may be empty, or a faster source";
}

Reception::Count count_kind(const Counts& counts) {
  if (!counts.skip) return counts.x == 0 ? Reception::Count::ticks : Reception::Count::delayed;
  if (counts.x == 0 && counts.b == 1) return Reception::Count::ticks_but_one;
  return counts.x == 0 && counts.a == 1 ? Reception::Count::ticks_before
                                        : Reception::Count::skipped;
}

Reception::Count changing_kind(const Input& input) {
  return input.skip ? Reception::Count::skipped : Reception::Count::delayed;
}

/// Messages to keep and most messages in the window, from what happens at the ticks themselves. The
/// pattern repeats after b ticks once the delay has passed.
struct Need {
  std::int64_t keep = 1, window = 1;
};

Need simulate(const Counts& counts, std::int64_t window, bool source_first, std::int64_t ticks) {
  Need need;
  std::int64_t total = 0;
  for (std::int64_t n = 0; n < ticks; ++n) {
    const std::int64_t arrived = counts.at(n);
    total += arrived;
    const std::int64_t held = window == 0 ? arrived : std::min(window, total);
    const std::int64_t sent = counts.sent(n) - (!source_first && counts.sends_at(n) ? 1 : 0);
    need.keep = std::max(need.keep, sent - (total - held));
    need.window = std::max(need.window, held);
  }
  return need;
}

Need bound(const Counts& counts, std::int64_t window) {
  const std::int64_t lag =
      ceil_div(counts.x, counts.b) + (counts.skip ? 2 + ceil_div(counts.a, counts.b) : 0);
  const std::int64_t arrivals = ceil_div(counts.a, counts.b);
  return {lag + std::max(window, arrivals), window == 0 ? arrivals : window};
}

Need need_of(const Counts& counts, std::int64_t window, bool source_first) {
  if (!counts.skip && window > 0) return {window + ceil_div(counts.x, counts.b), window};
  if (!counts.skip) {
    return {std::max<std::int64_t>(1, ceil_div(counts.a + counts.x, counts.b)),
            ceil_div(counts.a, counts.b)};
  }
  const std::int64_t settled = (counts.x + counts.b) / counts.a + 2 + 2 * counts.off();
  const std::int64_t window_full = window * ceil_div(counts.b, counts.a);
  const std::int64_t ticks = settled + window_full + 2 * counts.b + 2;
  return ticks <= kMaxSimulatedTicks ? simulate(counts, window, source_first, ticks)
                                     : bound(counts, window);
}

/// Whether a skipped input is still empty at its second tick.
bool starves(const Counts& counts, std::int64_t window) {
  return counts.skip && window > 0 && counts.at(0) + counts.at(1) == 0;
}

/// The most that any delay up to the longest needs.
Need need_of_all(Counts counts, std::int64_t longest_x, std::int64_t window, bool source_first) {
  constexpr std::int64_t kMostTried = 10'000;
  if (!counts.skip || longest_x > kMostTried) {  // grows with the delay
    counts.x = longest_x;
    return counts.skip ? bound(counts, window) : need_of(counts, window, source_first);
  }
  Need most;
  for (counts.x = 0; counts.x <= longest_x; ++counts.x) {
    const Need need = need_of(counts, window, source_first);
    most = {std::max(most.keep, need.keep), std::max(most.window, need.window)};
  }
  return most;
}

void report_starving(const Input& input, const Counts& counts, const Rational& source_rate,
                     Diagnostics& diagnostics) {
  auto& problem = diagnostics.error(
      "E0401", input.span,
      fmt::format("`{}` is skipped and still has no message at its second tick{}", input.written,
                  input.max_delay_s ? " with its longest delay" : ""));
  problem.label = "EAGERx would drop the callback, and the nodes after it would wait for ever";
  problem.help = advice(counts, source_rate);
}

/// By the clock: a slot may be late by up to a period, and the next one then follows at once, so
/// one message more than by counting may be on its way or come at once; and the sender writes one
/// more while the window is read. What a stop of the machine brings beyond that is dropped and
/// counted.
std::optional<Reception> arrived(const Input& input, const Counts& longest,
                                 Diagnostics& diagnostics) {
  const Rational delay_ns = longest_of(input) * Rational(kNsPerSecond);
  if (delay_ns.overflowed()) {
    diagnostics.error(
        "E0402", input.span,
        fmt::format("the delay of `{}` is too long to count in nanoseconds", input.written));
    return std::nullopt;
  }
  const std::int64_t on_their_way = ceil_div(longest.x, longest.b) + 1;
  const std::int64_t between_ticks = ceil_div(longest.a, longest.b) + 1;
  const std::int64_t window = input.window > 0 ? input.window : on_their_way + between_ticks;
  Reception reception;
  reception.count = Reception::Count::arrived;
  reception.a = longest.a;
  reception.b = longest.b;
  reception.x = longest.x;
  reception.delay_ns = nanoseconds(input.delay_s);
  if (input.max_delay_s) {
    reception.changing = {1, 1, reception.delay_ns, nanoseconds(longest_of(input))};
  }
  reception.max_size = static_cast<std::uint64_t>(window);
  reception.always_full = false;
  reception.keep = static_cast<std::uint64_t>(window + on_their_way + between_ticks + 1);
  return reception;
}

}  // namespace

std::optional<Reception> plan_reception(const Input& input, const ReceptionEnds& ends,
                                        Diagnostics& diagnostics) {
  const auto counts = counts_of(input, ends.source_rate_hz, ends.rate_hz, diagnostics);
  if (!counts) return std::nullopt;
  Counts longest = *counts;
  if (input.max_delay_s)
    longest.x = (Rational(counts->b) * ends.source_rate_hz * longest_of(input)).ceil();
  if (ends.asynchronous) return arrived(input, longest, diagnostics);
  if (starves(longest, input.window)) {
    report_starving(input, longest, ends.source_rate_hz, diagnostics);
    return std::nullopt;
  }
  const Need need = input.max_delay_s
                        ? need_of_all(*counts, longest.x, input.window, ends.source_first)
                        : need_of(*counts, input.window, ends.source_first);
  Reception reception;
  reception.count = input.max_delay_s ? changing_kind(input) : count_kind(*counts);
  reception.a = counts->a;
  reception.b = counts->b;
  reception.x = counts->x;
  reception.off = counts->off();
  reception.max_size = static_cast<std::uint64_t>(std::max<std::int64_t>(1, need.window));
  reception.always_full =
      !input.skip &&
      (input.window == 1 || (input.window == 0 && counts->a == counts->b && longest.x == 0));
  if (input.max_delay_s) {
    reception.changing = changing_of(input, *counts, ends.source_rate_hz, diagnostics);
    if (!reception.changing) return std::nullopt;
  }
  reception.keep = static_cast<std::uint64_t>(need.keep);
  return reception;
}

}  // namespace eagerx::gen
