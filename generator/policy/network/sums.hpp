// Sums in the order of generated programs.
#pragma once

#include <algorithm>
#include <array>
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

/// `start` and the sum of an output that is alone in its panel.
template <class Real, class Term>
Real chained_sum(Real start, std::size_t count, Term&& term) {
  constexpr std::size_t kChains = eagerx::policy::kChains;
  std::array<Real, kChains> sums{};
  for (std::size_t i = 0; i < (count + kChains - 1) / kChains * kChains; ++i) {
    const Real value = i < count ? term(i) : Real(0);
    sums[i % kChains] = i < kChains ? value : sums[i % kChains] + value;
  }
  for (std::size_t half = kChains / 2; half > 0; half /= 2) {
    for (std::size_t k = 0; k < half; ++k) sums[k] = sums[k] + sums[k + half];
  }
  return start + sums[0];
}

/// Output `out` of a layer with `outputs` of them.
template <class Real, class Term>
Real sum_of_output(Real start, std::size_t out, std::size_t outputs, std::size_t count,
                   Term&& term) {
  return eagerx::policy::alone_in_panel(out, outputs) ? chained_sum(start, count, term)
                                                      : grouped_sum(start, count, term);
}

}  // namespace eagerx::gen
