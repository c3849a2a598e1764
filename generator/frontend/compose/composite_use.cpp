#include "generator/frontend/compose/composite_use.hpp"

#include <fmt/format.h>

#include <memory>
#include <string_view>
#include <utility>

#include "generator/frontend/library/condition.hpp"
#include "generator/frontend/parameters/requirements.hpp"
#include "generator/frontend/read/number.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {

FormatPtr composite_node_format() {
  static const FormatPtr kFormat = [] {
    Format format = *node_format();
    for (Field& field : format.fields) field.required = field.required && field.name != "rate";
    return std::make_shared<const Format>(std::move(format));
  }();
  return kFormat;
}

bool take_parameters(const Library& library, const YamlValue& settings, const Entity& entity,
                     Span span, Scope& scope, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const std::vector<Setting> given = read_config(settings.find("config"));
  const Config config = resolve_config(library, entity, given, span, diagnostics);
  scope.references = references_of(entity, given);
  const YamlValue* rate = settings.find("rate");
  if (rate != nullptr) {
    scope.references[{"rate"}] = *rate;
  } else if (refers_to(*entity.composite, {"rate"})) {
    diagnostics
        .error("E0202", settings.span,
               fmt::format("missing key `rate`: nodes in `{}` run at it", entity.id.value))
        .help = {"add `rate:`, its rate in Hz", add_key("rate")};
  }
  check_requirements(entity, config, rate != nullptr ? exact_of(*rate) : std::nullopt, span,
                     diagnostics);
  return diagnostics.error_count() == errors_before;
}

bool knows_ports(const YamlValue& settings, const Entity& entity, const char* key,
                 Diagnostics& diagnostics) {
  const YamlValue* chosen = settings.find(key);
  const YamlValue* ports = entity.composite->find(key);
  if (chosen == nullptr) return true;
  std::vector<std::pair<std::string, Span>> names;
  for (const auto& item : chosen->items) names.emplace_back(item.text, item.span);
  for (const auto& entry : chosen->entries) names.emplace_back(entry.key, entry.key_span);
  std::vector<std::string> known;
  if (ports != nullptr)
    for (const auto& entry : ports->entries) known.push_back(entry.key);
  bool good = true;
  for (const auto& [name, span] : names) {
    if (contains(known, name)) continue;
    auto& problem = diagnostics.error(
        "E0307", span,
        fmt::format("`{}` has no {} `{}`", entity.id.value,
                    std::string_view(key).substr(0, std::string_view(key).size() - 1), name));
    problem.help = did_you_mean(name, known, fmt::format("it has {}", join(known, ", ")));
    good = false;
  }
  return good;
}

}  // namespace eagerx::gen
