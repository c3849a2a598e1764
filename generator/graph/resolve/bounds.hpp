// Bounds of spaces, and their lookup.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/graph/resolve/partial_space.hpp"

namespace eagerx::gen {

/// Checks that bounds are one number or one for each element, fit the dtype, and leave a nonempty
/// range (E0326 at `place`). Call it before any other use of bounds.
bool check_bounds(const Space& space, Span place, Diagnostics& diagnostics);
/// Where the bounds are written, if that is in the file of `otherwise`.
Span place_of_bounds(const PartialSpace& space, Span otherwise);
/// The bound of an element; `otherwise` if there is none.
double bound_of(const std::vector<double>& bounds, std::size_t element, double otherwise);
/// float32 bounds are written as decimals: 3.14 is allowed where the bound is float32(3.14), and
/// back.
double rounded(const Space& space, double value);

}  // namespace eagerx::gen
