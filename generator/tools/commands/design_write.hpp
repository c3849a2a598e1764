// Writes designed parameters into the text of a graph.
#pragma once

#include <string>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/tools/linear/design_report.hpp"

namespace eagerx::gen {

/// Gives a node of a graph these values, in memory.
void set_parameters(GraphNode& node, const std::vector<DesignedParameter>& parameters);
/// The numbers of a parameter, one or several; none if there is no such parameter.
std::vector<double> parameter_of(const Config& config, const std::string& name);

/// Writes them where the graph's file has them: below the node, or below the composite that hands
/// a parameter of its own on to it. All else stays as it is written. E0523 where that is not
/// possible, or the graph would then be another one; then the file stays as it is.
void write_parameters(Run& run, const GraphOptions& options, const std::string& node,
                      const std::vector<DesignedParameter>& parameters);

}  // namespace eagerx::gen
