// Processors: checks their input space, and gives the receiver their output space.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/graph/resolve/unresolved_graph.hpp"

namespace eagerx::gen {

/// A processor between a port with the space `arriving` and its receiver; `source`: where the
/// message comes from. Problems: E0303 to E0306, E0312.
std::optional<Processor> make_processor(UnresolvedGraph& draft, const ProcessorSpec& spec,
                                        const Space& arriving, Span source);
/// Processors that convert a message with the space `arriving` to the declared space, as text for a
/// connection: "processor: {type: GetIndex, config: {index: [0]}}".
std::vector<std::string> fitting_processors(const Library& library, const PartialSpace& takes,
                                            const Space& arriving);

}  // namespace eagerx::gen
