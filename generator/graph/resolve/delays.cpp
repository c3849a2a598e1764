#include "generator/graph/resolve/delays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/graph/resolve/states.hpp"

namespace eagerx::gen {
namespace {

/// In whole nanoseconds, as delays count at run time; nullopt if there is none.
std::optional<Rational> longest_delay(const Random& random) {
  constexpr double kSecondNs = 1e9;
  double longest_s = 0.0;
  switch (random.kind) {
    case RandomSpec::Kind::normal:
      return std::nullopt;
    case RandomSpec::Kind::choice:
      for (const auto& choice : random.choices) longest_s = std::max(longest_s, choice.front());
      break;
    case RandomSpec::Kind::value:
      longest_s = random.first.front();
      break;
    default:
      longest_s = random.second.front();
  }
  if (longest_s * kSecondNs > 1e18) return std::nullopt;
  return Rational(static_cast<std::int64_t>(std::ceil(longest_s * kSecondNs)), 1'000'000'000);
}

void sample_delay(const RandomSpec& spec, Input& input, Diagnostics& diagnostics) {
  Space seconds{Dtype::float64, {}, {0.0}, {}};
  if (input.max_delay_s) seconds.high = {input.max_delay_s->to_double()};
  const bool ranged =
      spec.kind == RandomSpec::Kind::uniform || spec.kind == RandomSpec::Kind::log_uniform;
  if (ranged && !spec.first && !input.max_delay_s) {
    diagnostics.error("E0327", spec.span, "this delay has no range to be sampled from").help =
        "write `max_delay` next to it, or the range: `{low: …, high: …}`";
    return;
  }
  input.random_delay = read_random("delay", seconds, spec, diagnostics);
  if (!input.random_delay) return;
  if (!input.max_delay_s) input.max_delay_s = longest_delay(*input.random_delay);
  if (!input.max_delay_s) {
    diagnostics.error("E0327", spec.span, "this delay has no maximum").help =
        "write `max_delay` next to it, so that enough memory is reserved";
  }
}

}  // namespace

void resolve_delay(const UnresolvedGraph& draft, const UnresolvedInput& from, Input& into) {
  const ConnectionSettings& settings = from.settings;
  into.delay_s = delay_of(settings).value_or(Rational());
  into.entity_sets_delay = from.entity_sets_delay;
  if (settings.max_delay) {
    const Rational* longest_s = settings.max_delay->number();
    into.max_delay_s = longest_s != nullptr ? *longest_s : Rational();
  }
  if (settings.random_delay) sample_delay(*settings.random_delay, into, draft.diagnostics);
  if (into.max_delay_s && *into.max_delay_s < into.delay_s) {
    draft.diagnostics.error(
        "E0327", settings.max_delay ? settings.max_delay->span : from.span,
        fmt::format("`max_delay` ({} s) is below the delay of `{}` ({} s)",
                    into.max_delay_s->to_string(), from.written, into.delay_s.to_string()));
  }
  if (draft.spec.simulate_delays && !draft.spec.simulate_delays->value) {
    into.delay_s = Rational{};
    into.max_delay_s.reset();
    into.random_delay.reset();
  }
}

}  // namespace eagerx::gen
