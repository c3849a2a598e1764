// A generated tree that needs no installed eagerx-gen: the headers and the target's files go with
// it.
#pragma once

#include "generator/backend/emit/emit.hpp"
#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Folder of the headers in such a tree.
inline constexpr const char* kHeaderFolder = "src/";

/// Adds the files that `files` include, directly or indirectly, below `src/`, and the folders of
/// the targets, the files that these name, and the toolchain files below `eagerx-gen/`. Headers
/// from other folders than ours are included from there, too. `only_headers`: nothing below
/// `eagerx-gen/`. Problems: E0901 a file that cannot be read, E0904 a header that is in none of
/// these folders, E0907 two files at one place.
bool carry_along(Run& run, const std::vector<const Target*>& targets, const std::string& output,
                 bool only_headers, std::vector<GeneratedFile>& files);

}  // namespace eagerx::gen
