#include "generator/graph/resolve/ports.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/number.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

/// A setting that a manifest may write as a reference; nullopt if it does not fulfil `good`.
template <class Test>
std::optional<QuantitySpec> replaced(const std::optional<QuantitySpec>& setting,
                                     const char* expected, const References& references,
                                     Diagnostics& diagnostics, Test&& good) {
  if (!setting) return std::nullopt;
  const YamlValue value = value_of(*setting, references, diagnostics);
  const auto number = value.is_scalar() ? exact_of(value) : std::nullopt;
  if (number && good(*number)) return QuantitySpec{*number, value.span, setting->with_unit};
  if (!is_unresolved(value)) {
    diagnostics.error("E0204", value.span,
                      fmt::format("expected {}, found {}", expected, describe(value)));
  }
  return std::nullopt;
}

bool is_window(const Rational& messages) {
  constexpr std::int64_t kMost = 1'000'000;
  return messages.is_integer() && messages >= Rational() && messages <= Rational(kMost);
}

bool is_delay(const Rational& seconds) {
  return seconds >= Rational();
}

}  // namespace

ConnectionSettings manifest_settings(const PortManifest& port, const References& references,
                                     Diagnostics& diagnostics) {
  ConnectionSettings result = port.settings;
  result.window =
      replaced(result.window, "a number of messages", references, diagnostics, is_window);
  result.delay = replaced(result.delay, "a delay in seconds", references, diagnostics, is_delay);
  result.max_delay =
      replaced(result.max_delay, "a delay in seconds", references, diagnostics, is_delay);
  return result;
}

UnresolvedOutput draft_output(const PortManifest& port, Span span, const References& references,
                              Diagnostics& diagnostics) {
  UnresolvedOutput output;
  output.name = port.name.value;
  output.span = span;
  output.declared = partial_space(port.space, references, diagnostics);
  return output;
}

UnresolvedInput draft_input(const PortManifest& port, const std::string& written, Span span,
                            const References& references, Diagnostics& diagnostics) {
  UnresolvedInput input;
  input.name = port.name.value;
  input.written = written;
  input.span = span;
  input.declared = partial_space(port.space, references, diagnostics);
  input.settings = manifest_settings(port, references, diagnostics);
  input.entity_sets_delay = port.settings.max_delay.has_value();
  input.optional = port.optional;
  return input;
}

void apply_overrides(UnresolvedOutput& output, const ComponentSpec& said,
                     const std::string& written, Diagnostics& diagnostics) {
  if (said.settings.processor) {
    output.processor = said.settings.processor;
    output.published = {};  // of the processor that it replaces
  }
  if (!said.space) return;
  PartialSpace& space = output.processor ? output.published : output.declared;
  space = narrow(space, partial_space(*said.space, {}, diagnostics), written, diagnostics);
}

const ComponentSpec* find_component(const Selection& selection, std::string_view name) {
  return selection ? find_named(*selection, name) : nullptr;
}

bool report_unknown(const Selection& selection, const std::vector<PortManifest>& ports,
                    const Entity& entity, std::string_view what, Diagnostics& diagnostics) {
  if (!selection) return false;
  const std::size_t errors_before = diagnostics.error_count();
  for (const auto& component : *selection) {
    const auto& [name, span] = component.name;
    if (find_named(ports, name) != nullptr) continue;
    diagnostics
        .error("E0307", span, fmt::format("`{}` has no {} `{}`", entity.id.value, what, name))
        .help = suggestion(name, names_of(ports), fmt::format("it has no {}s", what));
  }
  return diagnostics.error_count() != errors_before;
}

void report_wrong_engine(const Entity& entity, const Entity& engine, Span span,
                         Diagnostics& diagnostics) {
  diagnostics
      .error("E0308", span,
             fmt::format("`{}` does not work on `{}`", entity.id.value, engine.id.value))
      .help = fmt::format("it works on {}", join(entity.engines, ", "));
}

}  // namespace eagerx::gen
