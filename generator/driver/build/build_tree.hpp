// Configures and builds generated trees.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "generator/driver/pipeline/pipeline.hpp"

namespace eagerx::gen {

/// A generated project of CMake, for one target.
struct Tree {
  std::string source, build;                                  // folders
  std::string toolchain;                                      // its file; empty: this machine's
  std::vector<std::pair<std::string, std::string>> settings;  // variables of CMake
};

/// The tree of `target` in the output `folder`. `several`: the folder contains other trees.
Tree tree_of(const Run& run, const GenerateOptions& options, const Target& target,
             const std::string& folder, bool several);
/// The folder of a target's manifest.
std::string folder_of(const Run& run, const Target& target);
/// Whether it is none of eagerx-gen's.
bool is_own(const Run& run, const Target& target);

/// Configures a tree if necessary, and builds what is out of date, with Ninja and ccache if they
/// are installed. The environment variables of CMake (CMAKE_GENERATOR, CMAKE_BUILD_TYPE, …) and CXX
/// apply. Unless `quiet`, prints the progress to the standard error at least every 5 s.
/// `cmake_target`: builds only this target; empty: all. False after E0513, a missing program, or
/// E0514, a failed build.
bool build_tree(const Tree& tree, const std::string& name, bool quiet, Diagnostics& diagnostics,
                const std::string& cmake_target = {});

}  // namespace eagerx::gen
