// Generated files on disk: all or nothing, and untouched where nothing changed.
#pragma once

#include <string>
#include <vector>

#include "generator/emit/emit.hpp"

namespace eagerx::gen {

struct WriteResult {
  std::size_t written = 0, unchanged = 0, removed = 0;
};

/// Writes `files` below `folder`. Everything is written beside its place first and then renamed, so
/// that a full disk leaves the previous output as it was. Files of an earlier run that are no
/// longer made are removed; the list is kept in `eagerx-gen.files`. A file of this name that is not
/// in that list is left alone. Problems: E0901, E0903 a file of somebody else; nullopt.
std::optional<WriteResult> write_files(const std::string& folder, std::vector<GeneratedFile> files,
                                       Diagnostics& diagnostics);

/// Writes one file, also beside its place first. False: E0901.
bool write_file(const std::string& path, const std::string& text, Diagnostics& diagnostics);

}  // namespace eagerx::gen
