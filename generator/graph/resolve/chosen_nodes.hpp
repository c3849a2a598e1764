// Nodes as `placement:`, `--split` and `--of` name them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// How a node matches a name: not at all; by its own name, or as an element of the array of this
/// name; or a part of such a composite.
enum class Called : std::uint8_t { no, itself, inside };

/// Whether `name` matches `node` ("leg[2]/knee"): "leg[2]/knee", "leg[2]", "leg", "leg[*]/knee".
/// `*` matches any index.
Called is_called(std::string_view node, std::string_view name);

/// The one of the nodes, composites and arrays in `known` that `name` means where none is called
/// so: `robot.driver` and `driver` are `robot/driver`. A note tells of it. `name` without one.
std::string node_meant(const std::string& name, const std::vector<std::string>& known, Span span,
                       Diagnostics& diagnostics);

}  // namespace eagerx::gen
