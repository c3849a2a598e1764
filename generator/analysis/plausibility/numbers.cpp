// Times and rates whose size suggests another unit.
#include <fmt/format.h>

#include <algorithm>

#include "generator/analysis/plausibility/plausibility.hpp"
#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

/// The values of a delay that are written, whether it is sampled or not.
std::vector<QuantitySpec> written_delays(const ConnectionSettings& settings) {
  std::vector<QuantitySpec> result;
  const auto add = [&](const std::optional<YamlValue>& value) {
    if (!value) return;
    if (value->is_scalar()) result.push_back(read_quantity(*value));
    for (const YamlValue& item : value->items) result.push_back(read_quantity(item));
  };
  if (settings.delay) result.push_back(*settings.delay);
  if (settings.random_delay) {
    add(settings.random_delay->first);
    add(settings.random_delay->second);
  }
  if (settings.max_delay) result.push_back(*settings.max_delay);
  return result;
}

/// Whether `max_delay` in milliseconds would be below the delay next to it.
bool is_short_in_ms(const ConnectionSettings& settings) {
  const Rational* next_s = settings.delay ? settings.delay->number() : nullptr;
  const Rational* longest = settings.max_delay ? settings.max_delay->number() : nullptr;
  return next_s != nullptr && longest != nullptr && *longest < *next_s * Rational(1000);
}

/// A delay in seconds without a written unit that is many steps long.
void check_delay(const CheckedGraph& checked, const ConnectionSettings& settings,
                 Diagnostics& diagnostics) {
  constexpr std::int64_t kManySteps = 10;
  const std::vector<QuantitySpec> delays = written_delays(settings);
  for (const QuantitySpec& delay : delays) {
    const Rational* delay_s = delay.number();
    if (delay.with_unit || delay_s == nullptr || *delay_s < Rational(1)) continue;
    const std::string seconds = delay_s->to_string();
    const Rational steps = *delay_s * checked.graph.environment().rate_hz;
    if (steps < Rational(kManySteps) || steps.overflowed()) continue;
    auto& problem = diagnostics.warning(
        "W0114", delay.span,
        fmt::format("a delay of {0} is {0} s, {1} steps of the graph", seconds, steps.floor()));
    problem.help =
        &delay == &delays.back() && is_short_in_ms(settings)
            ? fmt::format("write the unit: `{} s`", seconds)
            : fmt::format("write the unit: `{0} ms` if these are milliseconds, else `{0} s`",
                          seconds);
    return;  // the others are of the same unit
  }
}

void check_delays(const CheckedGraph& checked, Diagnostics& diagnostics) {
  const GraphSpec& spec = checked.spec;
  if (spec.simulate_delays && !spec.simulate_delays->value) return;
  const auto check_ports = [&](const Selection& ports) {
    if (!ports) return;
    for (const ComponentSpec& port : *ports) check_delay(checked, port.settings, diagnostics);
  };
  for (const EntitySpec& object : spec.objects) check_ports(object.sensors);
  for (const EntitySpec& node : spec.nodes) check_ports(node.inputs);
  for (const ConnectionSpec& each : spec.connections)
    check_delay(checked, each.settings, diagnostics);
}

class Rates {
 public:
  explicit Rates(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void check(const std::string& what, const Rational& rate_hz, Span span) {
    constexpr std::int64_t kHighest = 100'000;
    if (!(rate_hz > Rational(kHighest))) return;
    auto& problem =
        diagnostics_.warning("W0115", span,
                             fmt::format("{} {} Hz, which is faster than controllers usually run",
                                         what, rate_hz.to_string()));
    const std::string in_hz = (rate_hz / Rational(1000)).to_string() + " Hz";
    problem.help = fmt::format(
        "numbers without a unit are in Hz: write `rate: {}` if that is meant; else `allow: "
        "[W0115]`",
        in_hz);
    problem.help.fixes = {change_number_to(in_hz), allow_here("W0115")};
  }
  void check(const EntitySpec& entity, const std::string& what) {
    const Rational* rate_hz = entity.rate ? entity.rate->number() : nullptr;
    if (rate_hz != nullptr) check(what, *rate_hz, entity.rate->span);
  }
  void check(const Selection& ports, const std::string& owner) {
    if (!ports) return;
    for (const ComponentSpec& port : *ports) {
      if (port.rate)
        check(fmt::format("`{}.{}` has a rate of", owner, port.name.value), port.rate->value,
              port.rate->span);
    }
  }

 private:
  Diagnostics& diagnostics_;
};

}  // namespace

void check_numbers(const CheckedGraph& checked, Diagnostics& diagnostics) {
  check_delays(checked, diagnostics);
  Rates rates(diagnostics);
  const GraphSpec& spec = checked.spec;
  rates.check("the graph has a rate of", spec.rate.value, spec.rate.span);
  rates.check(spec.engine, "the engine steps at");
  for (const EntitySpec& node : spec.nodes)
    rates.check(node, fmt::format("`{}` runs at", node.name.value));
  for (const EntitySpec& object : spec.objects) {
    rates.check(object.sensors, object.name.value);
    rates.check(object.actuators, object.name.value);
  }
}

}  // namespace eagerx::gen
