// Writes generated files to disk: all or none of them, and only those that changed.
#pragma once

#include <string>
#include <vector>

#include "generator/backend/emit/emit.hpp"

namespace eagerx::gen {

struct WriteResult {
  std::size_t written = 0, unchanged = 0, removed = 0;
  std::size_t kept = 0;  // that are the user's
};

/// False with E0906 if an output on the command line is also read, is another output, or is one of
/// `files`, which will be written below `folder`. Every writer calls it.
bool are_different(const std::string& folder, const std::vector<GeneratedFile>& files,
                   Diagnostics& diagnostics);

/// Writes `files` below `folder`. Writes every file under a temporary name first, then a journal of
/// the final names. From that moment the new output counts: if a run is killed while it renames
/// files, the next run completes it. Until then, or if the disk is full, the previous output stays.
/// Links below `folder` are not followed. Files of an earlier run that are no longer generated are
/// removed, using the list in `eagerx-gen.files`. Files that are not in that list, and existing
/// files with `yours`, are left alone. nullopt after a problem: E0901, E0903 a file that eagerx-gen
/// did not write, E0906 an output that is read or that is the same file as another output.
std::optional<WriteResult> write_files(const std::string& folder, std::vector<GeneratedFile> files,
                                       Diagnostics& diagnostics);

/// Whether a file that a command is going to write is none that it has read; E0906 if it is. For
/// commands that work for long before they write: write_file() looks, too.
bool spares_inputs(const std::string& path, Diagnostics& diagnostics);

/// Writes one file, and the folders that it is in, as runtime/host/base/files.hpp does: links are
/// followed, owner and mode stay, a FIFO or device is written. False: E0901, E0906.
bool write_file(const std::string& path, const std::string& text, Diagnostics& diagnostics);

}  // namespace eagerx::gen
