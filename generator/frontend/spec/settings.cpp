#include "generator/frontend/spec/settings.hpp"

#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

RandomSpec::Kind kind_of_range(std::string_view key) {
  if (key == "normal") return RandomSpec::Kind::normal;
  return key == "uniform" ? RandomSpec::Kind::uniform : RandomSpec::Kind::log_uniform;
}

}  // namespace

std::optional<YamlValue> value_at(const YamlValue& yaml, std::string_view key) {
  const YamlValue* value = yaml.find(key);
  return value != nullptr ? std::optional<YamlValue>(*value) : std::nullopt;
}

ConnectionSettings overlay(ConnectionSettings base, const ConnectionSettings& over) {
  if (over.window) base.window = over.window;
  if (over.delay) base.delay = over.delay;
  if (over.max_delay) base.max_delay = over.max_delay;
  if (over.skip) base.skip = over.skip;
  if (over.processor) base.processor = over.processor;
  // A delay that is written replaces one that is sampled, and the other way round.
  if (over.delay) base.random_delay.reset();
  if (over.random_delay) {
    base.random_delay = over.random_delay;
    if (!over.delay) base.delay.reset();
  }
  return base;
}

std::optional<std::uint32_t> window_of(const ConnectionSettings& settings) {
  if (!settings.window) return 1;
  const Rational* count = settings.window->number();
  return count != nullptr ? std::optional(static_cast<std::uint32_t>(count->num())) : std::nullopt;
}

std::optional<Rational> delay_of(const ConnectionSettings& settings) {
  if (!settings.delay) return Rational();
  const Rational* seconds = settings.delay->number();
  return seconds != nullptr ? std::optional(*seconds) : std::nullopt;
}

bool skips(const ConnectionSettings& settings) {
  return settings.skip && settings.skip->value;
}

std::vector<Setting> read_config(const YamlValue* yaml) {
  std::vector<Setting> result;
  if (yaml == nullptr) return result;
  for (const auto& entry : yaml->entries)
    result.push_back({entry.key, entry.key_span, entry.value});
  return result;
}

ProcessorSpec read_processor(const YamlValue& yaml) {
  if (yaml.is_sequence()) {
    ProcessorSpec last = read_processor(yaml.items.back());
    for (std::size_t i = 0; i + 1 < yaml.items.size(); ++i)
      last.before.push_back(read_processor(yaml.items[i]));
    return last;
  }
  const YamlValue& type = yaml.is_scalar() ? yaml : *yaml.find("type");
  return {{type.text, type.span}, read_config(yaml.find("config"))};
}

QuantitySpec read_quantity(const YamlValue& yaml) {
  if (const auto number = exact_of(yaml)) return {*number, yaml.span, yaml.with_unit};
  return {yaml, yaml.span, yaml.with_unit};
}

std::optional<Reference> reference_in(const QuantitySpec& quantity) {
  const YamlValue* expression = quantity.expression();
  return expression != nullptr ? reference_in(*expression) : std::nullopt;
}

std::optional<RandomSpec> read_random(const YamlValue& yaml, Diagnostics& diagnostics) {
  RandomSpec spec;
  spec.span = yaml.span;
  if (yaml.is_scalar()) return spec;  // uniform in its space
  std::vector<const YamlValue::Entry*> ways;
  for (const auto& entry : yaml.entries) {
    if (entry.key != "processor" && entry.key != "space") ways.push_back(&entry);
  }
  if (ways.empty() && !yaml.entries.empty()) return std::nullopt;
  if (ways.size() != 1) {
    diagnostics.error("E0206", yaml.span, "a value can be sampled in only one way").help =
        "write one of value, uniform, normal, log_uniform, choice";
    return std::nullopt;
  }
  const auto& [key, key_span, value] = *ways.front();
  spec.span = key_span;
  if (key == "value" || key == "choice") {
    spec.kind = key == "value" ? RandomSpec::Kind::value : RandomSpec::Kind::choice;
    spec.first = value;
    return spec;
  }
  if (value.is_scalar()) return spec;  // `uniform: space`
  spec.kind = kind_of_range(key);
  const bool normal = spec.kind == RandomSpec::Kind::normal;
  spec.first = *value.find(normal ? "mean" : "low");
  spec.second = *value.find(normal ? "std" : "high");
  return spec;
}

ConnectionSettings read_connection_settings(const YamlValue& yaml, Diagnostics& diagnostics) {
  ConnectionSettings settings;
  if (const YamlValue* window = yaml.find("window")) settings.window = read_quantity(*window);
  if (const YamlValue* longest = yaml.find("max_delay"))
    settings.max_delay = read_quantity(*longest);
  if (const YamlValue* delay = yaml.find("delay"); delay != nullptr && delay->is_scalar()) {
    settings.delay = read_quantity(*delay);
  } else if (delay != nullptr) {
    settings.random_delay = read_random(*delay, diagnostics);
  }
  if (const YamlValue* skip = yaml.find("skip"))
    settings.skip = {parse_bool(skip->text).value_or(false), skip->span};
  if (const YamlValue* processor = yaml.find("processor"))
    settings.processor = read_processor(*processor);
  return settings;
}

}  // namespace eagerx::gen
