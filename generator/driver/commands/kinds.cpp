#include "generator/driver/commands/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/driver/pipeline/paths.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription = "kind.yaml";

/// Empty without the folder of models and templates.
fs::path folder_of_kinds() {
  const std::string root = data_root();
  return root.empty() ? fs::path() : fs::path(root) / "templates" / "new";
}

FormatPtr kind_format() {
  return format::record(
      "the description of a kind",
      {{"about", format::text("one line"), true, "what it is"},
       {"defines", format::keyword({"entity", "target"}), false,
        "what the new folder adds to a library"},
       {"name", format::keyword({"underscores", "dashes"}), false,
        "what may stand between words of names"},
       {"folder", format::path("a folder", false), false, "where new folders go"}});
}

}  // namespace

std::string Kind::with_article() const {
  const bool vowel = std::string_view("aeiou").find(name.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + name;
}

std::vector<std::string> kinds_of_new() {
  std::vector<std::string> kinds;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of_kinds(), error)) {
    if (fs::exists(entry.path() / kDescription, error))
      kinds.push_back(entry.path().filename().string());
  }
  std::ranges::sort(kinds);
  return kinds;
}

std::optional<Kind> read_kind(const std::string& name, SourceMap& sources,
                              Diagnostics& diagnostics) {
  const auto kinds = kinds_of_new();
  if (!ranges::contains(kinds, name)) {
    diagnostics.io_error("E0301", {}, fmt::format("there are no templates for a new `{}`", name))
        .help =
        "install eagerx-gen with `cmake --install`, or set EAGERX_HOME to the folder that "
        "has models and templates";
    return std::nullopt;
  }
  const fs::path folder = folder_of_kinds() / name;
  const YamlValue yaml = read_yaml_file((folder / kDescription).string(), sources, diagnostics);
  if (diagnostics.has_errors() || !check(yaml, *kind_format(), diagnostics)) return std::nullopt;
  const auto text = [&](const char* key) {
    const YamlValue* value = yaml.find(key);
    return value != nullptr ? value->text : std::string();
  };
  return Kind{name,           folder.string(),         text("about"), text("defines"),
              text("folder"), text("name") == "dashes"};
}

}  // namespace eagerx::gen
