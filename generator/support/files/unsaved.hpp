// Unsaved texts of an editor, which readers use instead of the files.
//
// One list for the process, like that of inputs and outputs: a reader far from the commands cannot
// be forgotten by the code that has an editor.
#pragma once

#include <optional>
#include <string>

namespace eagerx::gen {

/// Sets the text that replaces the file at `path`, by any name; nullopt: the file on the disk.
void set_unsaved(const std::string& path, std::optional<std::string> text);

/// nullopt if there is none, so the file on the disk is read.
std::optional<std::string> unsaved_text(const std::string& path);

}  // namespace eagerx::gen
