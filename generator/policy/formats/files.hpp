// Bytes of files, and the problems of those that cannot be used.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/policy/formats/common/read_context.hpp"
#include "generator/policy/network/problem.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The bytes of a file. `what` is for messages ("policy", "statistics"). E0601, E0602.
std::optional<std::string> read_bytes(const std::string& path, const std::string& name,
                                      Span mention, const char* what, Diagnostics& diagnostics);

/// Files in the folder of `path`, no links, no larger than policies may be.
FilesInFolder files_in_folder_of(const std::string& path);

/// Adds "{what} `{name}` {problem}" at `mention`.
void report_problem(const PolicyProblem& problem, const char* what, const std::string& name,
                    Span mention, Diagnostics& diagnostics);

}  // namespace eagerx::gen
