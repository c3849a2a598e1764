#include "generator/driver/commands/missing.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "generator/driver/commands/new_folder.hpp"
#include "generator/driver/pipeline/paths.hpp"
#include "generator/frontend/import/import.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

View ports_view(const std::vector<MissingEntity::Port>& ports) {
  View view = list();
  for (const auto& port : ports) {
    View item = object();
    item.set("name", port.name);
    item.set("space", port.space);
    item.set("optional", port.optional);
    view.push_back(item);
  }
  return view;
}

View texts_view(const std::vector<std::string>& lines) {
  View view = list();
  for (const auto& line : lines) {
    View item = object();
    item.set("text", line);
    view.push_back(item);
  }
  return view;
}

View view_of(const MissingEntity& entity, const std::string& name, const fs::path& folder) {
  View view = view_of_new(name, folder);
  view.set("type", entity.type);
  view.set("eagerx", entity.id);
  view.set("kind", entity.kind);
  view.set("manifest", entity.manifest);
  view.set("has_class", entity.kind != "object");
  view.set("is_engine", entity.kind == "engine");
  view.set("engine", entity.engine);
  view["implementation"] = texts_view(entity.implementation);
  view["model"] = texts_view(entity.model);
  view.set("users", fmt::format("{}", join(entity.users, ", ")));
  view["inputs"] = ports_view(entity.inputs);
  view["outputs"] = ports_view(entity.outputs);
  view["states"] = ports_view(entity.states);
  view["targets"] = ports_view(entity.targets);
  return view;
}

void make_folder(Run& run, const MissingEntity& entity, const std::string& name,
                 const fs::path& folder) {
  const fs::path templates = fs::path(data_root()) / "templates" / "missing";
  const View view = view_of(entity, name, folder);
  auto files = rendered_files((templates / entity.kind).string(), name, view, run.diagnostics);
  if (!entity.engine.empty()) {
    for (auto& file : rendered_files((templates / "model").string(), name, view, run.diagnostics))
      files.push_back(std::move(file));
  }
  if (!run.diagnostics.has_errors()) write_new_folder(folder, files, run.diagnostics);
}

}  // namespace

int list_missing(Run& run, const YamlValue& tree, const GraphOptions& options,
                 const std::string& output) {
  load(run, options);
  if (run.diagnostics.has_errors()) return finish(run, options);
  const auto missing =
      missing_entities(tree, run.library, {options.engine, options.engine_rate_hz, options.rate_hz},
                       run.diagnostics);
  if (!missing) return finish(run, options);
  if (missing->empty()) say("every class has a counterpart\n");
  for (const auto& entity : *missing) {
    const std::string name = word_of(entity.type, '_');
    const fs::path folder = fs::path(output) / name;
    say("{}: {} for {}", entity.id, entity.kind, join(entity.users, ", "));
    if (!output.empty() && is_free_place(folder, run.diagnostics)) {
      make_folder(run, entity, name, folder);
      if (!run.diagnostics.has_errors()) say(": {}", folder.string());
    }
    say("\n");
  }
  return finish(run, options);
}

}  // namespace eagerx::gen
