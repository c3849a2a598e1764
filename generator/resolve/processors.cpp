// Processors: what they take must arrive, what they give is the receiver's space.
#include <fmt/format.h>

#include "generator/resolve/draft.hpp"

namespace eagerx::gen {

std::optional<Processor> make_processor(Draft& draft, const ProcessorSpec& spec,
                                        const Space& arriving, Span source) {
  Diagnostics& diagnostics = draft.diagnostics;
  const std::size_t errors_before = diagnostics.error_count();
  const Entity* entity = find_entity(draft.library, spec.type, EntityKind::processor, diagnostics);
  if (entity == nullptr) return std::nullopt;
  Processor processor;
  processor.entity = entity;
  processor.span = spec.type.span;
  processor.config = resolve_config(*entity, spec.config, spec.type.span, diagnostics);
  if (diagnostics.error_count() != errors_before) return std::nullopt;  // spaces may refer to it
  const References references = references_of(*entity, spec.config);
  const PartialSpace takes = partial_space(entity->inputs.front().space, references, diagnostics);
  processor.input = arriving;
  if (!fits(takes, arriving)) {
    auto& problem = diagnostics.error("E0306", spec.type.span,
                                      fmt::format("`{}` takes {}, but gets {}", entity->id.value,
                                                  describe(takes), arriving.describe()));
    problem.notes.push_back({"this is where it comes from", source, arriving.describe()});
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

}  // namespace eagerx::gen
