// Files of a program: checks that descriptors are open, and that files differ.
#pragma once

#include <cstdio>
#include <runtime/host/base/files.hpp>
#include <string>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

using host::open_standard_files;

/// Finds outputs that are an input, another output or the destination of the summary, by any name,
/// link or descriptor, and those that are not files (/dev/null is allowed). Returns the problem, or
/// an empty text. Opens nothing.
std::string problem_with_files(const Options& options);

/// Writes `text` to `out`, all of it; says why if that is not possible, and returns false.
bool print(std::FILE* out, const std::string& text);

}  // namespace eagerx::linux_sim
