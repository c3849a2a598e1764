// The contents of a folder, for messages about a missing file.
#pragma once

#include <string>
#include <vector>

#include "generator/support/diagnostics/fix.hpp"

namespace eagerx::gen {

/// Names of what is in a folder, sorted; none if there is no such folder. At most 1000 are read.
std::vector<std::string> entries_of_folder(const std::string& path);

/// Of a file or folder at `path` that is not there, and is called `written` where it is named: "did
/// you mean `…`?" with the nearest name in its folder, the few files of its kind that are there, or
/// the folder that is not there either. Empty: nothing helps, or there is something at `path`.
Help help_for_missing(const std::string& path, const std::string& written);

/// Of a relative `path`, if the folder that this runs in has been deleted: what to do. Else empty.
std::string help_for_deleted_folder(const std::string& path);

}  // namespace eagerx::gen
