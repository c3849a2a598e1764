// Sums in the order of generated programs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <eagerx/policy/panel_size.hpp>

namespace eagerx::gen {

/// Sums groups of eight, as eagerx/policy.hpp says. `term(i)` is a rounded number.
template <class Real, class Term>
Real grouped_sum(Real start, std::size_t count, Term&& term) {
  constexpr std::size_t kGroup = eagerx::policy::kGroup;
  Real sum = start;
  for (std::size_t first = 0; first < count; first += kGroup) {
    Real part = term(first);
    for (std::size_t i = first + 1; i < std::min(first + kGroup, count); ++i) part = part + term(i);
    sum = sum + part;
  }
  return sum;
}

}  // namespace eagerx::gen
