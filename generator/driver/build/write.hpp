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

/// False if a file that the command line names as an output is also read, is another output, or one
/// of `files`, which are about to be written below `folder`: E0906. All that writes asks it.
bool are_different(const std::string& folder, const std::vector<GeneratedFile>& files,
                   Diagnostics& diagnostics);

/// Writes `files` below `folder`. Every file is written under a temporary name first, then a
/// journal says where it belongs: from that moment the output is the new one, and a run that is
/// killed while it renames is completed by the next one. Until then, or if the disk is full, the
/// previous output stays as it was. Links below `folder` are not followed. Files of an earlier run
/// that are no longer made are removed; the list is kept in `eagerx-gen.files`. A file that is not
/// in that list is left alone, and so is one with `yours` that is there. Problems: E0901, E0903 a
/// file of somebody else, E0906 a file that is read, or two outputs that are one file; nullopt.
std::optional<WriteResult> write_files(const std::string& folder, std::vector<GeneratedFile> files,
                                       Diagnostics& diagnostics);

/// Whether a file that a command is going to write is none that it has read; E0906 if it is. For
/// commands that work for long before they write: write_file() looks, too.
bool spares_inputs(const std::string& path, Diagnostics& diagnostics);

/// Writes one file, and the folders that it is in, as runtime/host/base/files.hpp does: links are
/// followed, owner and mode stay, a FIFO or device is written. False: E0901, E0906.
bool write_file(const std::string& path, const std::string& text, Diagnostics& diagnostics);

}  // namespace eagerx::gen
