#include "generator/languages/package.hpp"

#include "generator/emit/render.hpp"
#include "generator/languages/view.hpp"

namespace eagerx::gen {

std::optional<std::vector<GeneratedFile>> emit_language(const Plan& plan, std::size_t part,
                                                        std::uint64_t hash,
                                                        const std::string& version,
                                                        Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.error_count();
  check_languages(plan, part, diagnostics);
  if (diagnostics.error_count() != before) return std::nullopt;
  const PartLayout layout = layout_of_part(plan, part);
  const PlacedPart& placed = plan.graph->placement->parts[part];
  const std::uint64_t own = hash_of_part(hash, placed.name);
  const View view = language_view(plan, layout, own, version);
  std::vector<GeneratedFile> files;
  const auto add = [&](const std::vector<std::pair<std::string, std::string>>& templates,
                       bool yours) {
    for (const auto& [path, output] : templates) {
      auto text = render_file(path, output, view, diagnostics);
      if (text) files.push_back({output, std::move(*text), yours});
    }
  };
  add(placed.target->partner, false);
  add(placed.target->yours, true);
  files.push_back({kLayoutFile, layout_json(plan, layout, own, version)});
  if (diagnostics.error_count() != before) return std::nullopt;
  return files;
}

}  // namespace eagerx::gen
