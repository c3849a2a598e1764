// How a state is sampled, as C++.
#pragma once

#include <string>

#include "generator/backend/emit/render.hpp"
#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// The lines ("line") that set `states.FIELD` from `random`; `constant`: the name of its range.
View sample_lines(const Random& random, const Space& space, const std::string& field,
                  const std::string& constant);

/// Whether samples need a range: a value and a choice do not.
inline bool needs_range(const Random& random) {
  return random.kind != RandomSpec::Kind::value && random.kind != RandomSpec::Kind::choice;
}
/// The distribution of a state.
Space range_of(const Random& random, const Space& space);

}  // namespace eagerx::gen
