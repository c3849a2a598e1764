#include "generator/frontend/import/import.hpp"

#include "generator/frontend/import/translate.hpp"

namespace eagerx::gen {

bool is_saved_graph(const YamlValue& root) {
  if (!root.is_map()) return false;
  const auto has = [&](const char* key) { return root.find(key) != nullptr; };
  // The first of them comes first in the file, so it is there when the rest is cut off.
  return has("backup") || (has("nodes") && has("connects") && has("gui_state"));
}

namespace {

/// EAGERx takes any text for the name of a port or a state.
void check_names(const GraphSpec& spec, Diagnostics& diagnostics) {
  const auto check = [&](const auto& named) {
    for (const auto& item : named) check_name(item.name.value, item.name.span, diagnostics);
  };
  const auto check_entity = [&](const EntitySpec& entity) {
    check(entity.states);
    for (const Selection* ports :
         {&entity.sensors, &entity.actuators, &entity.inputs, &entity.outputs}) {
      if (*ports) check(**ports);
    }
  };
  check_entity(spec.engine);
  for (const auto& object : spec.objects) check_entity(object);
  for (const auto& node : spec.nodes) check_entity(node);
  check(spec.actions);
  check(spec.observations);
}

}  // namespace

std::optional<ImportedGraph> import_graph(const YamlValue& root, const std::string& path,
                                          const Library& library, const ImportOptions& options,
                                          Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto failed = [&] { return diagnostics.error_count() != errors_before; };
  auto saved = read_saved_graph(root, diagnostics);
  if (!saved) return std::nullopt;
  EntityMapping mapping(library, diagnostics);
  const Pictures pictures = remove_pictures(*saved, mapping);
  const Processes processes = find_processes(*saved, diagnostics);
  rename_ports(*saved, mapping);
  require_all(*saved, mapping);
  const bool whole = !saved->flattened() || rebuild_objects(*saved, mapping, diagnostics);
  Translation t{*saved, mapping, options, diagnostics, {}, {}, {}, {}, {}};
  t.result.spec.file = root.span.file;
  t.result.spec.path = path;
  translate_names(t);
  translate_entities(t);
  // If something is missing, the rest is still translated, to find its problems.
  if (whole && !mapping.any_missing()) {
    choose_engine(t);
    if (!saved->flattened()) add_states_of_engine_nodes(t);
  }
  const std::size_t errors_without_connections = diagnostics.error_count();
  translate_connections(t);
  // The rate follows from what is connected.
  if (whole && diagnostics.error_count() == errors_without_connections) choose_rate(t);
  translate_environment(t);
  translate_pictures(t, pictures);
  translate_processes(t, processes);
  check_names(t.result.spec, diagnostics);
  mapping.report_missing();  // all of them at once
  if (failed()) return std::nullopt;
  return std::move(t.result);
}

}  // namespace eagerx::gen
