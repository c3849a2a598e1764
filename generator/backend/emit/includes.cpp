// The headers of entities that a program includes.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "generator/backend/emit/emit.hpp"
#include "generator/backend/emit/names.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// Calls f(root of the includes, class, place of the manifest) for each class of the program.
template <class Names, class F>
void for_each_class(const Plan& plan, const Names& names, F&& f) {
  const Graph& graph = *plan.graph;
  const auto add = [&](const Entity& entity, const CppClass& cpp, const Config& config) {
    f(entity.include_root, cpp, entity.id.span);
    for (const ConfigValue& item : config) {
      const auto* use = std::get_if<std::shared_ptr<const ModelUse>>(&item.value);
      if (use == nullptr) continue;
      const ObjectEngine& made = *(*use)->implementation;
      f(made.include_root, made.model, made.engine.span);
    }
  };
  const auto add_processor = [&](const std::optional<Processor>& processor) {
    if (!processor) return;
    for (const Processor* stage : processor->stages())
      add(*stage->entity, stage->entity->cpp, stage->config);
  };
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const GraphNode& node = graph.nodes[n];
    if (names.receives(n)) {
      for (const auto& input : node.inputs) add_processor(input.processor);
    }
    for (const auto& target : node.reset_targets) add_processor(target.processor);
    if (!names.runs(n)) continue;
    if (node.entity != nullptr) add(*node.entity, names.class_of(*node.entity), node.config);
    for (const auto& output : node.outputs) add_processor(output.processor);
    for (const auto& state : node.states) add_processor(state.processor);
  }
  if (!names.has_engine()) return;
  add(*graph.engine().entity, graph.engine().entity->simulator, {});
  for (const auto& item : graph.objects) {
    const ObjectEngine& made = *item.implementation;
    f(made.include_root, made.model, made.engine.span);
    for (const auto& state : item.states) {
      add(*state.engine_state, state.engine_state->cpp, state.config);
      add_processor(state.processor);
    }
  }
}

/// The part of ProgramNames that a program of the whole graph needs, without its names, which take
/// as long as the rest of a check.
struct WholeProgram {
  const Graph& graph;
  [[nodiscard]] bool runs(std::size_t node) const { return runs_here(graph, Part::whole, node); }
  [[nodiscard]] bool receives(std::size_t node) const {
    return receives_here(graph, Part::whole, node);
  }
  [[nodiscard]] bool has_engine() const { return graph.has_engine() && runs(Graph::kEngine); }
  static const CppClass& class_of(const Entity& entity) { return entity.cpp; }
};

}  // namespace

View includes_view(const Plan& plan, const ProgramNames& names, const IncludePaths& paths) {
  std::set<std::string> headers;
  for_each_class(
      plan, names, [&](const std::string& root, const CppClass& cpp, const Span& /*place*/) {
        if (cpp.include.empty()) return;
        if (root.empty()) {  // generated along with the program
          headers.insert("\"" + cpp.include + "\"");
        } else if (root == paths.builtin_root) {
          headers.insert("<" + cpp.include + ">");
        } else {
          const fs::path header = fs::path(root) / cpp.include;
          headers.insert("\"" + header.lexically_relative(paths.here).generic_string() + "\"");
        }
      });
  View views = list();
  for (const auto& header : headers) {
    View view = object();
    view.set("include", header);
    views.push_back(view);
  }
  return views;
}

std::vector<UsedClass> used_classes(const Plan& plan) {
  const Graph& graph = *plan.graph;
  std::map<FileId, std::string> systems;  // by manifest
  const auto add_system = [&](const Entity* entity) {
    if (entity != nullptr && entity->system) systems[entity->id.span.file] = entity->system->value;
  };
  for (const GraphNode& node : graph.nodes) add_system(node.entity);
  for (const Object& item : graph.objects) {
    // A model for an engine runs where the engine does.
    if (graph.engine().entity->system)
      systems[item.implementation->engine.span.file] = graph.engine().entity->system->value;
    for (const State& state : item.states) add_system(state.engine_state);
  }
  std::vector<UsedClass> result;
  const auto add = [&](const std::string& root, const CppClass& cpp, const Span& place) {
    if (root.empty() || cpp.name.empty()) return;
    if (ranges::contains(result, cpp.name, &UsedClass::name)) return;
    result.push_back({cpp.include.empty() ? "" : (fs::path(root) / cpp.include).string(), cpp.name,
                      systems[place.file], cpp.span});
  };
  for_each_class(plan, ProgramNames(plan, Part::whole), add);
  return result;
}

void check_headers(const Plan& plan, const std::string& here, Diagnostics& diagnostics) {
  std::set<fs::path> missing;
  std::set<std::pair<std::string_view, std::string_view>> seen;  // a file is looked for once
  for_each_class(
      plan, WholeProgram{*plan.graph},
      [&](const std::string& root, const CppClass& cpp, const Span& place) {
        if (cpp.include.empty() || root.empty() || !seen.emplace(root, cpp.include).second) return;
        const fs::path header = fs::path(root) / cpp.include;
        // As it is written; what both have in common is not.
        const std::string text =
            here.empty() ? cpp.include : header.lexically_relative(here).string();
        const bool writable = text.find_first_of("\"\n\r") == std::string::npos;
        std::error_code ignored;
        if ((writable && fs::is_regular_file(header, ignored)) || !missing.insert(header).second)
          return;
        if (!writable) {
          diagnostics
              .io_error(
                  "E0301", place,
                  fmt::format("C++ cannot include `{}`: its path has a quotation mark or a line "
                              "break",
                              text))
              .help = "rename the folder";
          return;
        }
        diagnostics
            .io_error("E0301", cpp.header.line > 0 ? cpp.header : place,
                      fmt::format("there is no header `{}`", header.filename().string()))
            .help = fmt::format("`header:` is a file in the manifest's folder, with the class `{}`",
                                cpp.name);
      });
}

}  // namespace eagerx::gen
