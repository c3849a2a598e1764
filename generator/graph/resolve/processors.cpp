#include "generator/graph/resolve/processors.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/number.hpp"
#include "generator/graph/resolve/limits.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

/// One of a list, without those before it.
std::optional<Processor> make_stage(const Library& library, const ProcessorSpec& spec,
                                    const Space& arriving, Span source, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const Entity* entity = find_entity(library, spec.type, EntityKind::processor, diagnostics);
  if (entity == nullptr) return std::nullopt;
  Processor processor;
  processor.entity = entity;
  processor.span = spec.type.span;
  processor.config = resolve_config(library, *entity, spec.config, spec.type.span, diagnostics);
  if (diagnostics.error_count() != errors_before) return std::nullopt;  // spaces may refer to it
  const References references = references_of(*entity, spec.config);
  const PartialSpace takes = partial_space(entity->inputs.front().space, references, diagnostics);
  processor.input = arriving;
  if (!fits(takes, arriving)) {
    auto& problem = diagnostics.error("E0306", spec.type.span,
                                      fmt::format("`{}` takes {}, but gets {}", entity->id.value,
                                                  describe(takes), arriving.describe()));
    problem.notes.push_back({"it comes from here", source, arriving.describe()});
  }
  PartialSpace gives = partial_space(entity->outputs.front().space, references, diagnostics);
  if (gives.like) gives = overlay(partial_of(arriving), gives);
  const auto output = complete(gives);
  if (!output) {
    diagnostics.error(
        "E0312", spec.type.span,
        fmt::format("the manifest of `{}` does not say what it gives", entity->id.value));
  }
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  processor.output = *output;
  return processor;
}

std::optional<Processor> make_processor(const Library& library, const ProcessorSpec& spec,
                                        const Space& arriving, Span source,
                                        Diagnostics& diagnostics) {
  std::vector<Processor> before;
  for (const ProcessorSpec& each : spec.before) {
    auto stage = make_stage(library, each, before.empty() ? arriving : before.back().output,
                            before.empty() ? source : before.back().span, diagnostics);
    if (!stage) return std::nullopt;
    before.push_back(std::move(*stage));
  }
  auto last = make_stage(library, spec, before.empty() ? arriving : before.back().output,
                         before.empty() ? source : before.back().span, diagnostics);
  if (last) last->before = std::move(before);
  return last;
}

/// Settings of a processor that takes all elements of a message and is to give as many: indices are
/// all of them. Nothing if another parameter must be given.
std::optional<std::vector<Setting>> settings_for(const Entity& entity, std::uint64_t elements) {
  std::vector<Setting> settings;
  for (const Parameter& parameter : entity.config) {
    if (parameter.fallback) continue;
    if (parameter.type != Parameter::Type::integers) return std::nullopt;
    std::vector<YamlValue> indices;
    for (std::uint64_t i = 0; i < elements; ++i)
      indices.push_back(made_number(static_cast<std::int64_t>(i), {}));
    settings.push_back({parameter.name.value, {}, made_list(std::move(indices), {})});
  }
  return settings;
}

/// `processor: NAME`, or with its `config`, as a connection has it.
std::string text_of(const ProcessorSpec& spec) {
  std::vector<std::string> settings;
  for (const Setting& setting : spec.config) {
    std::vector<std::string> items;
    for (const YamlValue& item : setting.value.items) items.push_back(item.text);
    settings.push_back(fmt::format("{}: [{}]", setting.name, join(items, ", ")));
  }
  return settings.empty() ? fmt::format("processor: {}", spec.type.value)
                          : fmt::format("processor: {{type: {}, config: {{{}}}}}", spec.type.value,
                                        join(settings, ", "));
}

}  // namespace

std::optional<Processor> make_processor(UnresolvedGraph& draft, const ProcessorSpec& spec,
                                        const Space& arriving, Span source) {
  return make_processor(draft.library, spec, arriving, source, draft.diagnostics);
}

std::vector<std::string> fitting_processors(const Library& library, const PartialSpace& takes,
                                            const Space& arriving) {
  // More would be a list of numbers, not a fix.
  constexpr std::uint64_t kMostElements = 16;
  std::vector<std::string> found;
  if (!takes.shape || arriving.size() > kMostElements) return found;
  for (const std::string& id : library.ids(EntityKind::processor)) {
    const Entity& entity = *library.find(id);
    auto settings = settings_for(entity, arriving.size());
    if (!settings) continue;
    const ProcessorSpec spec{{id, {}}, std::move(*settings), {}};
    Diagnostics unsaid;
    const auto processor = make_processor(library, spec, arriving, {}, unsaid);
    if (!processor || !fits(takes, processor->output)) continue;
    if (check_limits(*processor, unsaid)) found.push_back(text_of(spec));
  }
  return found;
}

}  // namespace eagerx::gen
