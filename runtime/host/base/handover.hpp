// Data from eagerx-gen to the program or library that it builds and starts: in the
// environment, so that every program can be started by hand as well.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::host {

/// The hash of the graph that was built, as hex_text() writes it.
inline constexpr const char* kExpectedGraph = "EAGERX_EXPECTED_GRAPH";
/// Descriptors of folders that nothing else builds in as long as they are open: "5,7".
inline constexpr const char* kOutputLocks = "EAGERX_OUTPUT_LOCKS";

/// The problem if another graph is expected than this one, whose hash is `graph`; empty if
/// nothing is. Asks once: what this program starts is something else.
std::string problem_of_graph(std::string_view graph);

/// Closes the folders. They are not needed any more once what was built is open.
void release_output_locks();

}  // namespace eagerx::host
