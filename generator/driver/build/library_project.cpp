#include "generator/driver/build/library_project.hpp"

#include <filesystem>
#include <utility>

#include "generator/backend/emit/render.hpp"
#include "generator/driver/build/write.hpp"

namespace eagerx::gen {
namespace {

bool write_project(Run& run, const Target& target, const std::string& kind,
                   const std::string& folder, std::vector<GeneratedFile> files) {
  const std::filesystem::path templates = std::filesystem::path(run.root) / "templates" / kind;
  View view = object();
  view.set("version", EAGERX_GEN_VERSION);
  view.set("name", run.graph->name);
  view.set("namespace", "graphs::" + run.graph->name);
  view.set("file", run.graph->file_name);
  view.set("target", target.id.value);
  for (const char* file : {"CMakeLists.txt", "main.cpp"}) {
    auto text = render_file((templates / (std::string(file) + ".mustache")).string(), file, view,
                            run.diagnostics);
    if (!text) return false;
    files.push_back({file, std::move(*text)});
  }
  return write_files(folder, std::move(files), run.diagnostics).has_value();
}

}  // namespace

std::optional<BuiltProgram> build_library_project(Run& run, const GenerateOptions& options,
                                                  const Target& target, const std::string& kind,
                                                  const std::string& folder,
                                                  std::vector<GeneratedFile> more) {
  if (!write_project(run, target, kind, folder, std::move(more))) return std::nullopt;
  const Tree tree = tree_of(run, options, target, folder, false);
  if (!build_program(run, tree, target, run.graph->name, options.quiet)) return std::nullopt;
  return BuiltProgram{&target, tree.build,
                      tree.build + "/" + kind + (target.system.empty() ? ".elf" : "")};
}

}  // namespace eagerx::gen
