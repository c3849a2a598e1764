// The contents of a folder, for messages about a missing file.
#pragma once

#include <string>
#include <vector>

#include "generator/support/diagnostics/fix.hpp"

namespace eagerx::gen {

/// Sorted names of a folder's entries, at most 1000; empty if the folder does not exist.
std::vector<std::string> entries_of_folder(const std::string& path);

/// Help for a missing file or folder at `path`, named `written` in the source: "did you mean `…`?"
/// with the nearest name in its folder, the few files of its kind there, or the missing folder.
/// Empty if nothing helps, or if `path` exists.
Help help_for_missing(const std::string& path, const std::string& written);

/// Help for a relative `path` if the working folder has been deleted; otherwise empty.
std::string help_for_deleted_folder(const std::string& path);

}  // namespace eagerx::gen
