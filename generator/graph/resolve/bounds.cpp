#include "generator/graph/resolve/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "generator/graph/resolve/unresolved_graph.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

bool check_side(const Space& space, const std::vector<double>& bounds, std::string_view name,
                Span place, Diagnostics& diagnostics) {
  if (bounds.size() > 1 && bounds.size() != space.size()) {
    diagnostics.error(
        "E0326", place,
        fmt::format("`{}` has {}, but {} has {}", name, counted(bounds.size(), "value"),
                    space.describe(), counted(space.size(), "element")));
    return false;
  }
  for (const double bound : bounds) {
    const bool floating = is_floating(space.dtype);
    if (floating && std::isinf(bound)) continue;
    const bool inside = bound >= lowest_of(space.dtype) && bound <= highest_of(space.dtype);
    if (inside && (floating || bound == std::trunc(bound))) continue;
    diagnostics.error(
        "E0326", place,
        fmt::format("`{}` cannot be a bound of {} {}", bound,
                    to_string(space.dtype).front() == 'i' ? "an" : "a", to_string(space.dtype)));
    return false;
  }
  return true;
}

}  // namespace

double bound_of(const std::vector<double>& bounds, std::size_t element, double otherwise) {
  if (bounds.size() == 1) return bounds.front();
  return element < bounds.size() ? bounds[element] : otherwise;
}

double rounded(const Space& space, double value) {
  return space.dtype == Dtype::float32 ? static_cast<double>(static_cast<float>(value)) : value;
}

bool check_bounds(const Space& space, Span place, Diagnostics& diagnostics) {
  if (!check_side(space, space.low, "low", place, diagnostics) ||
      !check_side(space, space.high, "high", place, diagnostics))
    return false;
  if (space.low.empty() || space.high.empty()) return true;
  for (std::size_t i = 0; i < std::max(space.low.size(), space.high.size()); ++i) {
    const double low = bound_of(space.low, i, 0.0);
    const double high = bound_of(space.high, i, 0.0);
    if (rounded(space, low) <= rounded(space, high)) continue;
    diagnostics.error("E0326", place, fmt::format("`low` ({}) is above `high` ({})", low, high));
    return false;
  }
  return true;
}

Span place_of_bounds(const PartialSpace& space, Span otherwise) {
  return space.bounds_span.line != 0 && space.bounds_span.file == otherwise.file ? space.bounds_span
                                                                                 : otherwise;
}

}  // namespace eagerx::gen
