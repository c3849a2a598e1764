#include "generator/backend/languages/package.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "generator/backend/emit/render.hpp"
#include "generator/backend/languages/view.hpp"
#include "generator/frontend/read/text.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The files in which nodes of a part in Python are written, each once.
std::vector<GeneratedFile> files_of_nodes(const Plan& plan, const PartLayout& layout,
                                          Diagnostics& diagnostics) {
  std::vector<GeneratedFile> files;
  std::map<std::string, std::string> taken;  // name → path
  const PlacedPart& placed = plan.graph->placement->parts[layout.part];
  for (const auto& [path, output] : placed.target->partner) taken[output];
  for (const auto& [path, output] : placed.target->yours) taken[output];
  for (const auto* turns : {&layout.before, &layout.after}) {
    for (const LayoutTurn& turn : *turns) {
      const GraphNode& node = plan.graph->nodes[turn.node];
      if (!turn.runs || !is_imported(*placed.target, node)) continue;
      const std::string& path = node.entity->python;
      const std::string name = fs::path(path).filename().string();
      const auto [found, is_new] = taken.emplace(name, path);
      if (!is_new && found->second == path) continue;
      LoadedFile file = load_file(path, ReadLimits().max_bytes);
      if (!is_new || !is_module(name)) {
        diagnostics
            .error("E0350", node.span,
                   fmt::format("part `{}` cannot import `{}`: {}", placed.name, path,
                               is_new ? "that is not a name of a module"
                                      : "another file of this part has the same name"))
            .help = "give the file another name: letters, digits and `_`, and `.py`";
      } else if (file.status != LoadedFile::Status::loaded) {
        diagnostics
            .io_error("E0301", node.entity->id.span,
                      fmt::format("cannot read `{}`: {}", path, file.reason))
            .help = "`python:` is a file in the manifest's folder";
      } else {
        files.push_back({name, std::move(file.bytes)});
      }
    }
  }
  return files;
}

}  // namespace

std::optional<std::vector<GeneratedFile>> emit_language(const Plan& plan, std::size_t part,
                                                        std::uint64_t hash,
                                                        const std::string& version,
                                                        Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  const PartLayout layout = layout_of_part(plan, part);
  const PlacedPart& placed = plan.graph->placement->parts[part];
  const std::uint64_t own = hash_of_part(hash, placed.name);
  auto own_files = files_of_nodes(plan, layout, diagnostics);
  const View view = language_view(plan, layout, own, version);
  const bool has_blanks = view.get("has_blanks")->is_true();
  std::vector<GeneratedFile> files = std::move(own_files);
  const auto add = [&](const std::vector<std::pair<std::string, std::string>>& templates,
                       bool yours) {
    for (const auto& [path, output] : templates) {
      auto text = render_file(path, output, view, diagnostics);
      if (text) files.push_back({output, std::move(*text), yours});
    }
  };
  add(placed.target->partner, false);
  add(placed.target->yours, has_blanks);
  files.push_back({kLayoutFile, layout_json(plan, layout, own, version)});
  if (diagnostics.error_count() != before) return std::nullopt;
  return files;
}

}  // namespace eagerx::gen
