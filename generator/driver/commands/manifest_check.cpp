#include "generator/driver/commands/manifest_check.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <utility>

#include "generator/driver/commands/check_targets.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/unsaved.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

fs::path full_path(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal();
}

/// Of two files that define the same, puts the problem into the one that `is_here`, and names the
/// other one, whose text is not there.
template <class IsHere>
void name_other_file(Diagnostic& problem, IsHere&& is_here, const SourceMap& sources) {
  Span& other = problem.notes.front().span;
  if (is_here(other)) std::swap(problem.span, other);
  if (other.file == FileId::none || is_here(other)) return;
  problem.notes.front() = {
      fmt::format("also defined in `{}:{}`", sources.name(other.file), other.line), {}, ""};
}

/// Takes the problems in the manifest's own file, with places in `into`.
void take(const Diagnostics& found, const SourceMap& sources, const fs::path& path, FileId file,
          Diagnostics& into) {
  // Problems with values and rates that a graph gives are not the manifest's.
  constexpr std::array kOfValues = {"E0306", "E0312", "E0322", "E0326", "E0327", "E0328"};
  const auto is_here = [&](const Span& span) {
    return span.file != FileId::none && full_path(sources.name(span.file)) == path;
  };
  for (Diagnostic each : found.all()) {
    if (each.code == "E0302" && !each.notes.empty()) name_other_file(each, is_here, sources);
    if (ranges::contains(kOfValues, each.code)) continue;
    if (!is_here(each.span)) continue;
    each.span.file = file;
    std::erase_if(each.notes, [&](const Diagnostic::Note& note) {
      return note.span.file != FileId::none && !is_here(note.span);
    });
    for (Diagnostic::Note& note : each.notes) {
      if (note.span.file != FileId::none) note.span.file = file;
    }
    into.take(std::move(each));
  }
}

/// A graph with one entity, all of whose ports are connected to the environment.
class Trial {
 public:
  Trial(const Entity& entity, const YamlValue& manifest) : entity_(entity), manifest_(manifest) {}

  [[nodiscard]] std::string node() {
    ports("inputs", "outputs");
    return fmt::format("name: trial\nrate: 100\nnodes:\n  it: {{type: {}, rate: 100{}}}\n{}",
                       entity_.id.value, config(), environment());
  }
  [[nodiscard]] std::string object(const std::string& engine) {
    ports("actuators", "sensors");
    return fmt::format(
        "name: trial\nrate: 100\nengine: {{type: {}, rate: 100}}\nobjects:\n  it: {{type: "
        "{}{}}}\n{}",
        engine, entity_.id.value, config(), environment());
  }

 private:
  std::vector<std::string> names(const char* section) const {
    std::vector<std::string> result;
    const YamlValue* const all = manifest_.find(section);
    if (all == nullptr) return result;
    for (const auto& entry : all->entries) result.push_back(entry.key);
    return result;
  }
  void ports(const char* takes, const char* gives) {
    for (const std::string& name : names(takes)) {
      actions_ += fmt::format("  in_{0}: {{space: {{like: it.{0}}}}}\n", name);
      connections_ += fmt::format("  - {{from: actions.in_{0}, to: it.{0}}}\n", name);
    }
    for (const std::string& name : names(gives)) {
      observations_ += fmt::format("{}out_{}", observations_.empty() ? "" : ", ", name);
      connections_ += fmt::format("  - {{from: it.{0}, to: observations.out_{0}}}\n", name);
    }
  }
  [[nodiscard]] std::string environment() const {
    return fmt::format("actions:{}{}observations: [{}]\nconnections:{}{}",
                       actions_.empty() ? " {}\n" : "\n", actions_, observations_,
                       connections_.empty() ? " []\n" : "\n", connections_);
  }
  /// Something for each parameter that must be given.
  [[nodiscard]] std::string config() const {
    std::string text;
    for (const Parameter& parameter : entity_.config) {
      if (!parameter.fallback)
        text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", parameter.name.value,
                            value_for(parameter));
    }
    return text.empty() ? text : fmt::format(", config: {{{}}}", text);
  }
  static std::string value_for(const Parameter& parameter) {
    switch (parameter.type) {
      case Parameter::Type::integer:
      case Parameter::Type::number:
        return "1";
      case Parameter::Type::boolean:
        return "true";
      case Parameter::Type::integers:
      case Parameter::Type::numbers:
        return "[1, 1, 1, 1, 1, 1, 1, 1]";
      case Parameter::Type::keyword:
        return parameter.options.empty() ? "none" : parameter.options.front();
      case Parameter::Type::text:
      case Parameter::Type::model:
        break;
    }
    return "none";
  }

  const Entity& entity_;
  const YamlValue& manifest_;
  std::string actions_, observations_, connections_;
};

/// The folder of the library that a manifest is in: one of `options`, or what installed manifests
/// are in, or else its own folder with the folders next to it.
LibraryOptions with_folder_of(LibraryOptions options, const Run& run, const fs::path& path) {
  std::vector<std::string> folders = options.paths;
  for (const char* const part : {"models", "targets"})
    folders.push_back((fs::path(run.root) / part).string());
  const bool is_known = ranges::any_of(folders, [&](const std::string& folder) {
    const std::string inside = path.lexically_relative(full_path(folder)).string();
    return !inside.empty() && !inside.starts_with("..");
  });
  if (is_known) return options;
  options.paths.push_back(path.parent_path().string());
  std::error_code error;
  for (fs::directory_iterator each(path.parent_path().parent_path(), error);
       !error && each != fs::directory_iterator(); each.increment(error)) {
    std::error_code ignored;
    if (each->path() != path.parent_path() && fs::exists(each->path() / "manifest.yaml", ignored))
      options.paths.push_back(each->path().string());
  }
  return options;
}

/// While a manifest is checked, the editor's text counts, saved or not.
class Meanwhile {
 public:
  Meanwhile(std::string path, const std::string& text)
      : path_(std::move(path)), before_(unsaved_text(path_)) {
    set_unsaved(path_, text);
  }
  ~Meanwhile() { set_unsaved(path_, std::move(before_)); }
  Meanwhile(const Meanwhile&) = delete;
  Meanwhile& operator=(const Meanwhile&) = delete;

 private:
  std::string path_;
  std::optional<std::string> before_;
};

}  // namespace

bool is_manifest(const std::string& path) {
  return fs::path(path).filename() == "manifest.yaml";
}

void check_manifest(Run& run, const LibraryOptions& options, const std::string& path,
                    const std::string& text) {
  const fs::path here = full_path(path);
  run.tree = read_yaml_text(path, text, run.sources, run.diagnostics);
  if (run.diagnostics.has_errors()) return;
  const FileId file = run.tree.span.file;
  const Meanwhile counts(path, text);
  Run installed;
  load(installed, {});
  const LibraryOptions with = with_folder_of(options, installed, here);
  Run library;
  load(library, with);
  take(library.diagnostics, library.sources, here, file, run.diagnostics);
  const auto entity = ranges::find_if(library.library.entities, [&](const auto& each) {
    return full_path(each.second.path) == here;
  });
  if (run.diagnostics.has_errors() || entity == library.library.entities.end()) return;
  std::vector<std::string> graphs;
  if (entity->second.kind == EntityKind::node)
    graphs.push_back(Trial(entity->second, run.tree).node());
  if (entity->second.kind == EntityKind::object) {
    for (const ObjectEngine& engine : entity->second.object_engines)
      graphs.push_back(Trial(entity->second, run.tree).object(engine.engine.value));
  }
  for (const std::string& graph : graphs) {
    GraphOptions trial;
    static_cast<LibraryOptions&>(trial) = with;
    trial.graph = (here.parent_path() / "trial.yaml").string();
    Run tried;
    check_text(tried, trial, graph);
    take(tried.diagnostics, tried.sources, here, file, run.diagnostics);
  }
  run.diagnostics.drop_repeats();
}

}  // namespace eagerx::gen
