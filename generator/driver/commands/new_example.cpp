#include "generator/driver/commands/new_example.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "generator/driver/commands/new_folder.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Empty without the folder of models and templates.
fs::path folder_of_examples() {
  const std::string root = data_root();
  return root.empty() ? fs::path() : fs::path(root) / "examples";
}

std::vector<NewFile> files_of(const fs::path& folder) {
  std::vector<NewFile> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    const std::string path = entry.path().lexically_relative(folder).string();
    // Skips files that a build or run left in the installed folder.
    if (!entry.is_regular_file(error) || path.starts_with("generated/") ||
        path.find("__pycache__") != std::string::npos)
      continue;
    std::ifstream file(entry.path(), std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    const bool is_program =
        (entry.status(error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    files.push_back({path, std::move(text), is_program});
  }
  std::ranges::sort(files, {}, &NewFile::path);
  return files;
}

/// Examples that a graph names as `../OTHER/…`.
std::vector<std::string> named_in(const std::vector<NewFile>& files,
                                  const std::vector<std::string>& examples) {
  std::vector<std::string> named;
  for (const std::string& example : examples) {
    const std::string path = fmt::format("../{}/", example);
    const bool is_named = std::ranges::any_of(files, [&](const NewFile& file) {
      return file.path.ends_with(".yaml") && file.text.find(path) != std::string::npos;
    });
    if (is_named) named.push_back(example);
  }
  return named;
}

/// Scripts that examples share: the check of an exercise sources one.
void copy_scripts(const fs::path& parent, const std::vector<NewFile>& files,
                  Diagnostics& diagnostics) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of_examples(), error)) {
    const std::string name = entry.path().filename().string();
    const bool is_named =
        name.ends_with(".sh") && std::ranges::any_of(files, [&](const NewFile& file) {
          return file.text.find("/../" + name) != std::string::npos;
        });
    if (!is_named || fs::exists(parent / name, error)) continue;
    fs::copy_file(entry.path(), parent / name, error);
    if (error)
      diagnostics.io_error(
          "E0902", {},
          fmt::format("cannot write `{}`: {}", (parent / name).string(), error.message()));
  }
}

}  // namespace

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of_examples(), error)) {
    if (fs::exists(entry.path() / "README.md", error))
      names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<fs::path> copy_example(const std::string& name, const fs::path& parent,
                                   Diagnostics& diagnostics) {
  const std::vector<std::string> examples = example_names();
  if (!ranges::contains(examples, name)) {
    diagnostics.error("E0301", {}, fmt::format("there is no example `{}`", name)).help =
        did_you_mean(name, examples,
                     examples.empty() ? "set EAGERX_HOME to the folder that has examples and models"
                                      : fmt::format("there are {}", join(examples, ", ")));
    return {};
  }
  if (!is_free_place(parent / name, diagnostics)) return {};
  std::vector<std::string> todo{name};
  std::vector<fs::path> made;
  for (std::size_t i = 0; i < todo.size(); ++i) {
    const fs::path folder = parent / todo[i];
    std::error_code error;
    const std::vector<NewFile> files = files_of(folder_of_examples() / todo[i]);
    for (const std::string& other : named_in(files, examples)) {
      if (!ranges::contains(todo, other) && !fs::exists(parent / other, error))
        todo.push_back(other);
    }
    write_new_folder(folder, files, diagnostics);
    if (!diagnostics.has_errors()) copy_scripts(parent, files, diagnostics);
    if (diagnostics.has_errors()) return {};
    made.push_back(folder);
  }
  return made;
}

}  // namespace eagerx::gen
