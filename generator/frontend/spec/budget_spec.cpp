#include "generator/frontend/spec/budget_spec.hpp"

#include "generator/frontend/read/bytes.hpp"
#include "generator/frontend/read/number.hpp"
#include "generator/frontend/read/scalar.hpp"

namespace eagerx::gen {
namespace {

Rational exact_setting(const YamlValue& yaml) {
  return exact_of(yaml).value_or(Rational());
}

std::uint64_t instructions_of(const YamlValue& yaml) {
  return static_cast<std::uint64_t>(whole_of(yaml).value_or(0));
}

std::uint64_t bytes_written(const YamlValue& yaml) {
  return parse_bytes(yaml.text).value_or(0);
}

template <class Convert>
auto setting_at(const YamlValue& yaml, const char* key, Convert&& convert) {
  using Converted = std::decay_t<decltype(convert(yaml))>;
  const YamlValue* value = yaml.find(key);
  return value == nullptr ? std::nullopt
                          : std::optional(Spanned<Converted>{convert(*value), value->span});
}

AgeBudgetSpec read_age_budget(const YamlValue& yaml) {
  if (yaml.is_scalar()) return {{exact_setting(yaml), yaml.span}, {}, {}, {}};
  const auto text = [](const YamlValue& value) { return value.text; };
  const auto truth = [](const YamlValue& value) { return parse_bool(value.text).value_or(true); };
  return {*setting_at(yaml, "at_most", exact_setting), setting_at(yaml, "from", text),
          setting_at(yaml, "to", text), setting_at(yaml, "agent", truth)};
}

MarginBudgetSpec read_margin_budget(const YamlValue& yaml) {
  const auto is_true = [&](const char* key) {
    const YamlValue* value = yaml.find(key);
    return value != nullptr && parse_bool(value->text).value_or(false);
  };
  const YamlValue& at = *yaml.find("at");
  return {{at.text, at.span},
          setting_at(yaml, "phase", exact_setting),
          setting_at(yaml, "gain", exact_setting),
          setting_at(yaml, "delay", exact_setting),
          is_true("trim"),
          is_true("corners")};
}

}  // namespace

BudgetSpec read_budget(const YamlValue& yaml) {
  BudgetSpec spec;
  spec.flash = setting_at(yaml, "flash", bytes_written);
  spec.ram = setting_at(yaml, "ram", bytes_written);
  spec.stack = setting_at(yaml, "stack", bytes_written);
  spec.instructions = setting_at(yaml, "instructions", instructions_of);
  spec.link = setting_at(yaml, "link", exact_setting);
  spec.parts = setting_at(yaml, "parts", exact_setting);
  spec.telemetry = setting_at(yaml, "telemetry", exact_setting);
  spec.time = setting_at(yaml, "time", exact_setting);
  spec.slot = setting_at(yaml, "slot", exact_setting);
  if (const YamlValue* margin = yaml.find("margin")) {
    if (margin->items.empty()) spec.margins.push_back(read_margin_budget(*margin));
    for (const YamlValue& item : margin->items) spec.margins.push_back(read_margin_budget(item));
  }
  if (const YamlValue* ages = yaml.find("age")) {
    spec.ages.emplace();
    if (ages->is_scalar()) spec.ages->push_back(read_age_budget(*ages));
    for (const YamlValue& item : ages->items) spec.ages->push_back(read_age_budget(item));
  }
  if (const YamlValue* nodes = yaml.find("nodes")) {
    spec.nodes.emplace();
    for (const auto& [name, span, value] : nodes->entries)
      spec.nodes->push_back({{name, span},
                             setting_at(value, "flash", bytes_written),
                             setting_at(value, "ram", bytes_written)});
  }
  return spec;
}

}  // namespace eagerx::gen
