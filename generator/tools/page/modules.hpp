// The page's scripts: ES modules in templates/page, which become one script.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The text of a file of the page. Problems: E0301 it cannot be read.
std::optional<std::string> read_part(const std::filesystem::path& path, Diagnostics& diagnostics);

/// One script of the modules `entries` in `folder` and of all that these import: each once, after
/// those that it imports, without its own imports and exports. From file:// a browser loads no
/// module of another file, so a page has its script in itself. All modules share the names of their
/// first level: no two may declare the same one, and an import may not rename (tests/page finds
/// both). Problems: E0301 a module cannot be read, imports or exports in another form than
/// `import {a, b} from "./c.mjs";` and `export` before a declaration, or imports itself in a
/// circle.
std::optional<std::string> joined_modules(const std::filesystem::path& folder,
                                          const std::vector<std::string>& entries,
                                          Diagnostics& diagnostics);

}  // namespace eagerx::gen
