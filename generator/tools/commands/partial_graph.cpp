#include "generator/tools/commands/partial_graph.hpp"

#include <filesystem>
#include <system_error>

#include "generator/frontend/outline/outline.hpp"

namespace eagerx::gen {

LibraryOptions with_folders_of(LibraryOptions options, const std::string& path,
                               const std::string& text) {
  const OutlineNode outline = outline_of(text);
  const OutlineNode* const folders = outline.find("library");
  if (folders == nullptr) return options;
  for (const OutlineEntry& each : folders->entries) {
    std::error_code ignored;
    const std::filesystem::path folder =
        std::filesystem::path(path).parent_path() / each.value.text;
    if (!each.value.text.empty() && std::filesystem::is_directory(folder, ignored))
      options.paths.push_back(folder.lexically_normal().string());
  }
  return options;
}

}  // namespace eagerx::gen
