// Data from eagerx-gen to the program or library that it builds and starts: in the
// environment, so that every program can be started by hand as well.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::host {

/// The hash of the graph that was built, as hex_text() writes it.
inline constexpr const char* kExpectedGraph = "EAGERX_EXPECTED_GRAPH";
/// Descriptors of locked build folders: no other process builds there while they are open. "5,7"
inline constexpr const char* kOutputLocks = "EAGERX_OUTPUT_LOCKS";

/// The problem if another graph than this one, with the hash `graph`, is expected; otherwise empty.
/// Reads the variable once, and removes it, because programs that this one starts are not
/// concerned.
std::string problem_of_graph(std::string_view graph);

/// Closes the folders, which are no longer needed once the built files are open.
void release_output_locks();

}  // namespace eagerx::host
