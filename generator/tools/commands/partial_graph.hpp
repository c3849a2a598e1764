// Options for a graph whose text may be incomplete, as in an editor.
#pragma once

#include <string>

#include "generator/driver/pipeline/options.hpp"

namespace eagerx::gen {

/// With the folders that `library:` of the text names, relative to the file `path`, if they exist.
LibraryOptions with_folders_of(LibraryOptions options, const std::string& path,
                               const std::string& text);

}  // namespace eagerx::gen
