#include "generator/graph/resolve/unresolved_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/frontend/read/number.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr std::uint64_t kMaxElements = 1U << 28U;  // of one message; more is surely a mistake

std::optional<std::vector<std::uint64_t>> shape_of(const YamlValue& yaml,
                                                   Diagnostics& diagnostics) {
  std::vector<std::uint64_t> shape;
  std::uint64_t elements = 1;
  for (const auto& item : yaml.items) {
    if (is_unresolved(item)) return std::nullopt;
    const auto dimension = whole_of(item);
    if (!dimension || *dimension < 1 ||
        static_cast<std::uint64_t>(*dimension) > kMaxElements / elements) {
      diagnostics
          .error("E0325", item.span, fmt::format("`{}` cannot be the size of a message", item.text))
          .label = fmt::format("a message has 1 to {} elements", kMaxElements);
      return std::nullopt;
    }
    elements *= static_cast<std::uint64_t>(*dimension);
    shape.push_back(static_cast<std::uint64_t>(*dimension));
  }
  return shape;
}

std::vector<double> bounds_of(const std::optional<YamlValue>& written, std::optional<Dtype> dtype,
                              const References& references, Diagnostics& diagnostics) {
  if (!written) return {};
  const YamlValue bounds = substitute(*written, references, diagnostics);
  if (!are_exact_as_doubles(bounds, dtype, "E0326", diagnostics)) return {};
  return numbers_of(bounds, diagnostics).value_or(std::vector<double>{});
}

}  // namespace

UnresolvedInput* UnresolvedNode::input(std::string_view name) {
  return const_cast<UnresolvedInput*>(std::as_const(*this).input(name));
}

const UnresolvedInput* UnresolvedNode::input(std::string_view name) const {
  const auto found = ranges::find_if(
      inputs, [&](const UnresolvedInput& i) { return i.name == name && !i.feedthrough; });
  return found == inputs.end() ? nullptr : &*found;
}

UnresolvedOutput* UnresolvedNode::output(std::string_view name) {
  return find_named(outputs, name);
}

void UnresolvedGraph::add_object(UnresolvedObject object) {
  object_of_name.try_emplace(object.name, objects.size());
  objects.push_back(std::move(object));
}

const UnresolvedObject* UnresolvedGraph::find_object(std::string_view name) const {
  const auto found = object_of_name.find(name);
  return found == object_of_name.end() ? nullptr : &objects[found->second];
}

bool UnresolvedGraph::is_doubtful(const UnresolvedNode& node) const {
  return erroneous.contains(node.node.object ? objects[*node.node.object].name : node.node.name);
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
    result.low.clear();  // reported above: the signal that they limit gets no second error
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
  return result + (space.shape ? fmt::format(" [{}]", join(*space.shape, ", ")) : ", any shape");
}

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
