// Whose line is the reason for a missing bound: loops of a library are those of its caller.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "generator/analysis/bound/analysis.hpp"
#include "generator/analysis/bound/places.hpp"

namespace eagerx::gen::bound {

struct Blamed {
  Frame place;                              // a line of the user's, or of the runtime
  std::optional<std::uint32_t> of_library;  // the function that is called there, if it is one
};

/// `roots`: the functions from which the obstacle was found. nullopt: no line is known.
std::optional<Blamed> blamed_for(const Obstacle& obstacle, const std::set<Address>& roots,
                                 Analysis& analysis, const Places& places);

}  // namespace eagerx::gen::bound
