// Folders that are made from templates: `eagerx-gen new` and `import --missing`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "generator/backend/emit/render.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Printed instead of written: the next steps, as commands for a shell.
inline constexpr std::string_view kNextSteps = "next.sh";

/// my_filter, my-filter → MyFilter
std::string class_name_of(std::string_view name);

/// MyFilter, my filter → my_filter: a name that was probably meant.
std::string word_of(std::string_view name, char between);

/// The variables of the templates of a new folder.
View view_of_new(const std::string& name, const std::filesystem::path& folder);

struct NewFile {
  std::string path;
  std::string text;
  bool is_program;
};

/// Templates (`….blank`) as files of the new folder, in the order of their paths. `@name@` in a
/// path is the name.
std::vector<NewFile> rendered_files(const std::string& templates, const std::string& name,
                                    const View& view, Diagnostics& diagnostics);

/// False: E0902, there is something.
bool is_free_place(const std::filesystem::path& folder, Diagnostics& diagnostics);

/// All or nothing.
void write_new_folder(const std::filesystem::path& folder, const std::vector<NewFile>& files,
                      Diagnostics& diagnostics);

}  // namespace eagerx::gen
