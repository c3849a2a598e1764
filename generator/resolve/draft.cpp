#include "generator/resolve/draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/read/scalar.hpp"

namespace eagerx::gen {
namespace {

constexpr std::uint64_t kMaxElements = 1U << 28U;  // of one message; more is surely a mistake

Dtype dtype_of(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Dtype::boolean); ++i) {
    if (to_string(static_cast<Dtype>(i)) == name) return static_cast<Dtype>(i);
  }
  return Dtype::float32;
}

std::optional<std::vector<std::uint64_t>> shape_of(const YamlValue& yaml,
                                                   Diagnostics& diagnostics) {
  std::vector<std::uint64_t> shape;
  std::uint64_t elements = 1;
  for (const auto& item : yaml.items) {
    if (is_unresolved(item)) return std::nullopt;
    const auto dimension = parse_int(item.text);
    if (!dimension || *dimension < 1 ||
        static_cast<std::uint64_t>(*dimension) > kMaxElements / elements) {
      diagnostics.error("E0325", item.span, fmt::format("`{}` is no size of a message", item.text))
          .label = fmt::format("a message has 1 to {} elements", kMaxElements);
      return std::nullopt;
    }
    elements *= static_cast<std::uint64_t>(*dimension);
    shape.push_back(static_cast<std::uint64_t>(*dimension));
  }
  return shape;
}

std::vector<double> bounds_of(const std::optional<YamlValue>& node, std::optional<Dtype> dtype,
                              const References& references, Diagnostics& diagnostics) {
  if (!node) return {};
  const YamlValue bounds = substitute(*node, references, diagnostics);
  if (!are_kept(bounds, dtype, "E0326", diagnostics)) return {};
  return numbers_of(bounds, diagnostics).value_or(std::vector<double>{});
}

}  // namespace

DraftInput* DraftNode::input(std::string_view name) {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const DraftInput& i) {
    return i.name == name && !i.feedthrough;
  });
  return found == inputs.end() ? nullptr : &*found;
}

DraftOutput* DraftNode::output(std::string_view name) {
  const auto found = std::find_if(outputs.begin(), outputs.end(),
                                  [&](const DraftOutput& o) { return o.name == name; });
  return found == outputs.end() ? nullptr : &*found;
}

PartialSpace partial_space(const SpaceSpec& spec, const References& references,
                           Diagnostics& diagnostics) {
  PartialSpace result;
  result.span = spec.span;
  if (spec.dtype) result.dtype = dtype_of(spec.dtype->value);
  if (spec.shape)
    result.shape = shape_of(substitute(*spec.shape, references, diagnostics), diagnostics);
  result.low = bounds_of(spec.low, result.dtype, references, diagnostics);
  result.high = bounds_of(spec.high, result.dtype, references, diagnostics);
  if (spec.like) {
    result.like = spec.like->value;
    result.like_span = spec.like->span;
  }
  const Span bounds = spec.low ? spec.low->span : spec.high ? spec.high->span : spec.span;
  result.bounds_span = bounds;
  const bool scalar_bounds =
      result.low.size() <= 1 || result.high.size() <= 1 || result.low.size() == result.high.size();
  if (!scalar_bounds) {
    diagnostics.error(
        "E0326", bounds,
        fmt::format("`low` has {} values and `high` {}", result.low.size(), result.high.size()));
    result.low.clear();  // told of; it need not be said again of what they are laid over
    result.high.clear();
  }
  for (std::size_t i = 0; scalar_bounds && !result.low.empty() && !result.high.empty() &&
                          i < std::max(result.low.size(), result.high.size());
       ++i) {
    const double low = result.low[result.low.size() == 1 ? 0 : i];
    const double high = result.high[result.high.size() == 1 ? 0 : i];
    if (low <= high) continue;
    diagnostics.error("E0326", bounds, fmt::format("`low` ({}) is above `high` ({})", low, high));
    result.low.clear();
    result.high.clear();
  }
  return result;
}

PartialSpace overlay(PartialSpace base, const PartialSpace& over) {
  if (over.dtype) base.dtype = over.dtype;
  if (over.shape) base.shape = over.shape;
  if (!over.low.empty()) base.low = over.low;
  if (!over.high.empty()) base.high = over.high;
  if (over.like) {
    base.like = over.like;
    base.like_span = over.like_span;
  }
  if (!over.low.empty() || !over.high.empty()) base.bounds_span = over.bounds_span;
  base.span = over.span;
  return base;
}

PartialSpace narrow(PartialSpace base, const PartialSpace& over, const std::string& what,
                    Diagnostics& diagnostics) {
  const bool dtype = !base.dtype || !over.dtype || *base.dtype == *over.dtype;
  const bool shape = !base.shape || !over.shape || *base.shape == *over.shape;
  if (!dtype || !shape) {
    diagnostics
        .error(
            dtype ? "E0306" : "E0305", over.span,
            fmt::format("`{}` is {}, which cannot become {}", what, describe(base), describe(over)))
        .notes.push_back({"as its manifest says", base.span, ""});
    return base;
  }
  return overlay(std::move(base), over);
}

std::optional<Space> complete(const PartialSpace& partial) {
  if (!partial.dtype || !partial.shape) return std::nullopt;
  return Space{*partial.dtype, *partial.shape, partial.low, partial.high};
}

PartialSpace partial_of(const Space& space) {
  PartialSpace partial;
  partial.dtype = space.dtype;
  partial.shape = space.shape;
  partial.low = space.low;
  partial.high = space.high;
  return partial;
}

bool fits(const PartialSpace& declared, const Space& arriving) {
  return (!declared.dtype || *declared.dtype == arriving.dtype) &&
         (!declared.shape || *declared.shape == arriving.shape);
}

std::string describe(const PartialSpace& space) {
  std::string result = space.dtype ? std::string(to_string(*space.dtype)) : "any dtype";
  return result +
         (space.shape ? fmt::format(" [{}]", fmt::join(*space.shape, ", ")) : ", any shape");
}

std::string suggestion(const std::string& name, const std::vector<std::string>& known,
                       const std::string& otherwise) {
  const std::string near = nearest(name, known);
  if (!near.empty()) return fmt::format("did you mean `{}`?", near);
  return known.empty() ? otherwise : fmt::format("there is {}", fmt::join(known, ", "));
}

namespace {

std::optional<std::uint32_t> window_of(const PortManifest& port, const References& references,
                                       Diagnostics& diagnostics) {
  if (!port.window) return std::nullopt;
  constexpr std::int64_t kMost = 1'000'000;
  const YamlValue window = substitute(*port.window, references, diagnostics);
  const auto count = window.is_scalar() ? parse_int(window.text) : std::nullopt;
  if (count && *count >= 0 && *count <= kMost) return static_cast<std::uint32_t>(*count);
  if (!is_unresolved(window)) {
    diagnostics.error("E0204", window.span,
                      fmt::format("expected a number of messages, found {}", describe(window)));
  }
  return std::nullopt;
}

}  // namespace

ConnectionSettings manifest_settings(const PortManifest& port, const References& references,
                                     Diagnostics& diagnostics) {
  ConnectionSettings result;
  result.window = window_of(port, references, diagnostics);
  result.delay_s = port.delay_s;
  result.skip = port.skip;
  return result;
}

DraftOutput draft_output(const PortManifest& port, Span span, const References& references,
                         Diagnostics& diagnostics) {
  DraftOutput output;
  output.name = port.name.value;
  output.span = span;
  output.declared = partial_space(port.space, references, diagnostics);
  return output;
}

DraftInput draft_input(const PortManifest& port, const std::string& written, Span span,
                       const References& references, Diagnostics& diagnostics) {
  DraftInput input;
  input.name = port.name.value;
  input.written = written;
  input.span = span;
  input.declared = partial_space(port.space, references, diagnostics);
  input.settings = manifest_settings(port, references, diagnostics);
  input.entity_sets_delay = port.max_delay.has_value();
  input.optional = port.optional;
  if (!port.max_delay) return input;
  const YamlValue longest = substitute(*port.max_delay, references, diagnostics);
  const auto seconds = longest.is_scalar() ? Rational::parse(longest.text) : std::nullopt;
  if (seconds && *seconds >= Rational()) {
    input.settings.max_delay_s = Spanned<Rational>{*seconds, longest.span};
  } else if (!is_unresolved(longest)) {
    diagnostics.error("E0204", longest.span,
                      fmt::format("expected a delay in seconds, found {}", describe(longest)));
  }
  return input;
}

void settle(DraftOutput& output, const ComponentSpec& settings, const std::string& written,
            Diagnostics& diagnostics) {
  if (settings.processor) {
    output.processor = settings.processor;
    output.published = {};  // of the processor that it replaces
  }
  if (!settings.space) return;
  PartialSpace& space = output.processor ? output.published : output.declared;
  space = narrow(space, partial_space(*settings.space, {}, diagnostics), written, diagnostics);
}

ConnectionSettings overlay(ConnectionSettings base, const ConnectionSettings& over) {
  if (over.window) base.window = over.window;
  if (over.delay_s) base.delay_s = over.delay_s;
  if (over.skip) base.skip = over.skip;
  if (over.processor) base.processor = over.processor;
  if (over.max_delay_s) base.max_delay_s = over.max_delay_s;
  // A delay that is written replaces one that is drawn, and the other way round.
  if (over.delay_s) base.random_delay.reset();
  if (over.random_delay) {
    base.random_delay = over.random_delay;
    if (!over.delay_s) base.delay_s.reset();
  }
  return base;
}

const ObjectEngine* find_implementation(const Library& library, const Entity& entity,
                                        const Entity& engine, Span span, Diagnostics& diagnostics) {
  if (const ObjectEngine* found = entity.implementation(engine)) return found;
  std::vector<std::string> known;
  for (const auto& id : library.ids(EntityKind::engine)) {
    if (entity.implementation(*library.find(id)) != nullptr) known.push_back(id);
  }
  auto& problem = diagnostics.error(
      "E0308", span,
      fmt::format("`{}` is not implemented for `{}`", entity.id.value, engine.id.value));
  problem.help = known.empty() ? "it has no implementation at all"
                               : fmt::format("it is made for {}", fmt::join(known, ", "));
  return nullptr;
}

}  // namespace eagerx::gen
