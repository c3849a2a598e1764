#include "generator/graph/resolve/partial_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/frontend/read/number.hpp"
#include "generator/support/diagnostics/join.hpp"

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

}  // namespace eagerx::gen
