// Finds problems of a manifest without a graph that uses it.
#pragma once

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// Whether a file is read as a manifest: its name is `manifest.yaml`.
bool is_manifest(const std::string& path);

/// Reads a manifest with this text as a part of its library, and tests the entity with all ports: a
/// node in a graph of its own, an object on each of its engines. Reports only problems with a place
/// in the manifest. Requirements on parameters without defaults are not checked.
void check_manifest(Run& run, const LibraryOptions& options, const std::string& path,
                    const std::string& text);

}  // namespace eagerx::gen
