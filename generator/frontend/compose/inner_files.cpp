#include "generator/frontend/compose/inner_files.hpp"

#include <filesystem>

#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// An empty path is the working directory.
fs::path absolute_folder(const fs::path& folder) {
  return absolute_path(folder / "x").lexically_normal().parent_path();
}

class Renamer {
 public:
  Renamer(const fs::path& from, const fs::path& to)
      : from_(absolute_folder(from)), to_(absolute_folder(to)) {}

  /// Those of an object or node.
  void entity(YamlValue& yaml) const {
    for (auto& entry : yaml.entries) {
      if (entry.key == "policy") policy(entry.value);
      if (entry.key == "config") tables(entry.value);
    }
  }

  void graph(YamlValue& yaml) const {
    for (auto& entry : yaml.entries) {
      if (entry.key == "library")
        for (auto& folder : entry.value.items) file(folder);
      if (entry.key == "agent") agent(entry.value);
      if (entry.key == "engine") entity(entry.value);
      if (entry.key == "objects" || entry.key == "nodes")
        for (auto& each : entry.value.entries) entity(each.value);
    }
  }

 private:
  void agent(YamlValue& yaml) const {
    for (auto& entry : yaml.entries)
      if (entry.key == "policy" || entry.key == "csv" || entry.key == "normalize" ||
          entry.key == "golden")
        file(entry.value);
  }

  /// `policy: FILE`, or a mapping with files.
  void policy(YamlValue& yaml) const {
    if (yaml.is_scalar()) file(yaml);
    for (auto& entry : yaml.entries)
      if (entry.key == "file" || entry.key == "normalize" || entry.key == "golden")
        file(entry.value);
  }

  /// Every `{csv: FILE}` below.
  void tables(YamlValue& yaml) const {
    for (auto& item : yaml.items) tables(item);
    for (auto& entry : yaml.entries) {
      if (entry.key == "csv" && entry.value.is_scalar()) file(entry.value);
      tables(entry.value);
    }
  }

  void file(YamlValue& name) const {
    if (name.is_scalar() && !name.text.empty() && fs::path(name.text).is_relative())
      name.text = (from_ / name.text).lexically_normal().lexically_relative(to_).generic_string();
  }

  fs::path from_, to_;
};

}  // namespace

void name_files_from(const Entity& composite, const std::string& graph_path, YamlValue& settings) {
  Renamer(fs::path(composite.path).parent_path(), fs::path(graph_path).parent_path())
      .entity(settings);
}

void name_files_of_graph(YamlValue& graph, const fs::path& from, const fs::path& to) {
  if (from != to) Renamer(from, to).graph(graph);
}

}  // namespace eagerx::gen
