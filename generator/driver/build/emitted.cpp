#include "generator/driver/build/emitted.hpp"

#include <filesystem>

#include "generator/backend/languages/package.hpp"
#include "generator/driver/build/built.hpp"
#include "generator/driver/build/targets.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The program of a part, in whatever language, and what it says with its hub. `hash`: of the
/// graph, 0 as long as it is unknown: its input is the same in every language.
std::optional<std::vector<GeneratedFile>> emit_part(Run& run, const EmitOptions& options,
                                                    std::size_t part, std::uint64_t hash) {
  const PlacedPart& placed = run.graph->placement->parts[part];
  if (hash != 0 && !placed.target->language.empty())
    return emit_language(*run.plan, part, hash, options.version, run.diagnostics);
  auto files = emit_whole(run, options);
  if (files && hash != 0)
    files->push_back({kLayoutFile, layout_json(*run.plan, layout_of_part(*run.plan, part),
                                               hash_of_part(hash, placed.name), options.version)});
  return files;
}

/// All programs of a placed graph: the hub in the folder `host`, each part in one of its name.
std::optional<std::vector<GeneratedFile>> emit_parts(Run& run, const EmitOptions& options) {
  std::vector<GeneratedFile> files;
  const auto add = [&](Part part, const std::string& folder, std::uint64_t hash) {
    EmitOptions of_part = options;
    of_part.part = part;
    of_part.graph_hash = hash;
    of_part.output = options.output + "/" + folder;
    if (part.is_placed() && hash != 0)
      of_part.targets = {run.graph->placement->parts[part.index()].target};
    auto made =
        part.is_placed() ? emit_part(run, of_part, part.index(), hash) : emit_whole(run, of_part);
    for (auto& file : made.value_or(std::vector<GeneratedFile>()))
      files.push_back({folder + "/" + file.path, std::move(file.text), file.yours});
    return made.has_value();
  };
  const auto add_all = [&](std::uint64_t hash) {
    const auto& parts = run.graph->placement->parts;
    if (!add(Part::hub, kHubFolder, hash)) return false;
    for (std::size_t part = 0; part < parts.size(); ++part)
      if (!add(Part::placed(part), parts[part].name, hash)) return false;
    return true;
  };
  // Emits the files once with 0 as the hash, and hashes them. Target and language of a part do not
  // affect the hash, as they do not change its messages.
  auto& parts = run.graph->placement->parts;
  const std::vector<PlacedPart> placed = parts;
  static const Target kAnywhere{};
  for (PlacedPart& part : parts) part = {part.name, &kAnywhere, {}, part.span, {}};
  const bool made = add_all(0);
  parts = placed;
  if (!made) return std::nullopt;
  const std::uint64_t hash = hash_of(files);
  files.clear();
  if (!add_all(hash)) return std::nullopt;
  return files;
}

}  // namespace

EmitOptions emit_options_for(const Run& run, std::vector<const Target*> targets,
                             std::string output) {
  EmitOptions options;
  options.templates = (fs::path(run.root) / "templates").string();
  options.targets = std::move(targets);
  options.version = EAGERX_GEN_VERSION;
  options.builtin_root = run.root;
  options.output = std::move(output);
  return options;
}

std::optional<std::vector<GeneratedFile>> emit_whole(Run& run, const EmitOptions& options) {
  return emit(*run.plan, run.policies.agent, node_policies(*run.spec, *run.graph, run.policies),
              options, run.diagnostics);
}

std::optional<std::vector<GeneratedFile>> emit_program(Run& run, const EmitOptions& options) {
  return run.graph->placement ? emit_parts(run, options) : emit_whole(run, options);
}

std::optional<ProgramFacts> facts_of_program(Run& run, const GraphOptions& options) {
  // It is equal for all targets and outputs.
  const auto files = emit_program(
      run, emit_options_for(run, find_targets(run, options), absolute_path(".").string()));
  const auto hash = files ? hash_in(*files) : std::nullopt;
  if (!hash) return std::nullopt;
  ProgramFacts facts{*hash, {}};
  for (const GeneratedFile& file : *files) {
    if (file.path.ends_with("/telemetry.json")) facts.telemetry = file.text;
  }
  return facts;
}

}  // namespace eagerx::gen
