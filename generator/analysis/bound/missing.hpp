// Why something has no bound, for users.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "generator/analysis/bound/analysis.hpp"
#include "generator/analysis/bound/bound.hpp"
#include "generator/analysis/bound/places.hpp"

namespace eagerx::gen::bound {

/// Without NoBound::of. `roots`: the functions from which the obstacle was found; `names`: of
/// Places::functions(), as users write them.
NoBound no_bound(const Obstacle& obstacle, const std::set<Address>& roots, Analysis& analysis,
                 const Places& places, const std::vector<std::string>& names);

}  // namespace eagerx::gen::bound
