// Where models, targets and templates are: next to an installed eagerx-gen, or in the source tree
// it was built from.
#pragma once

#include <string>

namespace eagerx::gen {

/// The folder that contains models/, targets/, templates/, toolchains/; the environment variable
/// EAGERX_HOME takes precedence. Empty if there is none.
std::string data_root();
/// The folder of eagerx-gen's CMake package: next to it, or in the build folder that it is in.
/// Empty if there is none.
std::string package_folder();
/// A program that only other commands start: where it is installed, or next to eagerx-gen in the
/// build folder.
std::string helper_program(const std::string& name);
/// The build folder of an image: the given one, or the folder that contains the image.
std::string build_folder_of(const std::string& image, const std::string& said);

/// The folder of the reference that `docs` opens: where it is installed, or in the build folder.
/// Empty if there is none.
std::string reference_folder();

}  // namespace eagerx::gen
