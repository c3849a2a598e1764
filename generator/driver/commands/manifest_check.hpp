// Finds problems of a manifest without a graph that uses it.
#pragma once

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Whether a file is read as a manifest: its name is `manifest.yaml`.
bool is_manifest(const std::string& path);

/// Reads a manifest of this text as a part of its library, and tries the entity: a node in a graph
/// of its own, an object on every engine that it is made for, with all ports. Only problems whose
/// place is in the manifest are reported. What its parameters need and has no default is not tried.
void check_manifest(Run& run, const LibraryOptions& options, const std::string& path,
                    const std::string& text);

}  // namespace eagerx::gen
