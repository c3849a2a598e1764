// Incomplete spaces, until dtype and shape are known.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/frontend/parameters/config.hpp"
#include "generator/graph/resolve/graph.hpp"

namespace eagerx::gen {

/// As much of a space as is written down.
struct PartialSpace {
  std::optional<Dtype> dtype;
  std::optional<std::vector<std::uint64_t>> shape;
  std::vector<double> low, high;
  std::optional<std::string> like;  // an input of the same node; for actions a port of the graph
  Span span, like_span;
  Span bounds_span;  // of the bound that was written last
};

/// The space of a SpaceSpec, with references replaced. Problems: E0325 shape, E0326 bounds.
PartialSpace partial_space(const SpaceSpec& spec, const References& references,
                           Diagnostics& diagnostics);
/// `base` with everything that `over` says.
PartialSpace overlay(PartialSpace base, const PartialSpace& over);
/// The same where dtype and shape must not change: `what` has the space `base` (E0305, E0306).
PartialSpace narrow(PartialSpace base, const PartialSpace& over, const std::string& what,
                    Diagnostics& diagnostics);
/// The space if dtype and shape are known.
std::optional<Space> complete(const PartialSpace& partial);
PartialSpace partial_of(const Space& space);
/// Whether the arriving message has the declared dtype and shape, if declared.
bool fits(const PartialSpace& declared, const Space& arriving);
/// "float32 [2]", "any dtype, any shape"
std::string describe(const PartialSpace& space);

}  // namespace eagerx::gen
