#include "generator/driver/build/packages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <set>

#include "generator/backend/emit/render.hpp"
#include "generator/driver/build/standalone.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/graph/resolve/needs.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPackageFile = "package.yaml";

fs::path folder_of_packages(const Run& run) {
  return fs::path(run.root) / "templates" / "packages";
}

FormatPtr package_format() {
  const FormatPtr places = format::file_map("places and templates of packages/shared");
  return format::record(
      "the description of a package",
      {{"about", format::text("one line"), true, "what it is"},
       {"headers", format::text("a folder"), true, "where headers go with --library"},
       {"library", places, false, "templates that are shared, with --library"},
       {"program", places, false, "templates that are shared, without --library"},
       {"yours", places, false, "templates of files that are written once, with --library"},
       {"taken", format::list("names that a graph cannot have here", format::text("a name")), false,
        "what the build system has of that name; `x_*`: all that begin with x_"}});
}

std::map<std::string, std::string> places_at(const YamlValue& yaml, std::string_view key) {
  std::map<std::string, std::string> places;
  if (const YamlValue* given = yaml.find(key)) {
    for (const auto& [place, span, item] : given->entries) places[place] = item.text;
  }
  return places;
}

std::vector<std::string> names_at(const YamlValue& yaml, std::string_view key) {
  std::vector<std::string> names;
  if (const YamlValue* given = yaml.find(key)) {
    for (const auto& item : given->items) names.push_back(item.text);
  }
  return names;
}

/// NAME.h of a tree lies in a folder of the compiler's search path: it must hide none of these, and
/// is not `hardware.h`, which is the user's.
constexpr std::array kHeaders = {
    "alloca",   "assert", "complex", "ctype",  "errno",    "fenv",    "float",     "hardware",
    "inttypes", "iso646", "limits",  "locale", "malloc",   "math",    "memory",    "pthread",
    "sched",    "search", "setjmp",  "signal", "stdalign", "stdarg",  "stdatomic", "stdbool",
    "stddef",   "stdint", "stdio",   "stdlib", "string",   "strings", "tgmath",    "threads",
    "time",     "uchar",  "unistd",  "wchar",  "wctype"};

/// Whether `taken` has the name, or `x_*` of one that begins so.
bool has_name(const std::vector<std::string>& taken, std::string_view name) {
  return std::ranges::any_of(taken, [&](std::string_view pattern) {
    return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1))
                                  : name == pattern;
  });
}

std::optional<Package> read_package(Run& run, const std::string& name) {
  const fs::path folder = folder_of_packages(run) / name;
  const YamlValue yaml =
      read_yaml_file((folder / kPackageFile).string(), run.sources, run.diagnostics);
  if (run.diagnostics.has_errors() || !check(yaml, *package_format(), run.diagnostics))
    return std::nullopt;
  return Package{name,
                 folder.string(),
                 yaml.find("headers")->text,
                 places_at(yaml, "library"),
                 places_at(yaml, "program"),
                 places_at(yaml, "yours"),
                 names_at(yaml, "taken")};
}

std::string with_name(std::string path, const std::string& name) {
  constexpr std::string_view kName = "@name@";
  for (auto at = path.find(kName); at != std::string::npos; at = path.find(kName))
    path.replace(at, kName.size(), name);
  return path;
}

}  // namespace

std::vector<std::string> names_of_packages(const Run& run) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of_packages(run), error)) {
    if (fs::exists(entry.path() / kPackageFile, error)) names.push_back(entry.path().filename());
  }
  std::ranges::sort(names);
  return names;
}

std::vector<Package> read_packages(Run& run, const GenerateOptions& options) {
  const std::vector<std::string> known = names_of_packages(run);
  std::vector<Package> packages;
  for (const auto& name : options.packages) {
    if (contains(known, name)) {
      if (auto package = read_package(run, name)) packages.push_back(std::move(*package));
      continue;
    }
    run.diagnostics.error("E0502", {}, fmt::format("unknown package `{}`", name)).help =
        suggestion(name, known);
  }
  return packages;
}

void check_names(Run& run, const std::vector<Package>& packages) {
  const std::string& name = run.graph->name;
  for (const Package& package : packages) {
    const bool is_header = ranges::contains(kHeaders, name);
    if (!is_header && !has_name(package.taken, name)) continue;
    run.diagnostics
        .error("E0504", run.spec ? run.spec->name.span : Span{},
               is_header ? fmt::format("a graph named `{0}` cannot be the package `{1}`: its "
                                       "header would be `{0}.h`, which is another one",
                                       name, package.name)
                         : fmt::format("a graph named `{0}` cannot be the package `{1}`, which has "
                                       "something named `{0}` already",
                                       name, package.name))
        .help = fmt::format("give the graph another `name:`, such as `{}_control`", name);
    return;
  }
}

bool is_standalone(const GenerateOptions& options) {
  return options.standalone || (options.part.empty() && !options.packages.empty());
}

bool is_bare(const GenerateOptions& options) {
  return options.makes_library() && !options.packages.empty() && !options.standalone;
}

void check_for_packages(Run& run, const GenerateOptions& options) {
  if (!options.makes_library() || options.packages.empty()) return;
  const Graph& graph = *run.graph;
  if (graph.has_engine()) {
    run.diagnostics
        .error("E0503", graph.engine().span,
               fmt::format("the main loop of a package reads and writes hardware itself, but "
                           "`{}` has the engine {}",
                           graph.name, graph.engine_id()))
        .help =
        "write a graph without `engine:` whose actions are the measurements and whose observations "
        "go to the hardware, with the policy as a node: `eagerx-gen explain E0503` has one; "
        "`--of NAME` cuts a controller out of this graph for it; without `--library` a package "
        "runs "
        "an episode of this graph";
    return;
  }
  for (const auto& name : options.packages) {
    Target package;
    package.id = {name, {}};
    check_system(graph, Part::whole, package, run.library, run.diagnostics);
  }
}

std::vector<ExtraTemplate> templates_of(const Run& run, const GenerateOptions& options,
                                        const std::vector<Package>& packages) {
  std::vector<ExtraTemplate> templates;
  const auto add_folder = [&](const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error))
      if (entry.path().extension() == ".mustache") found.push_back(entry.path());
    std::ranges::sort(found);
    for (const auto& path : found) {
      templates.push_back({path.lexically_relative(folder).replace_extension().generic_string(),
                           path.string(), false});
    }
  };
  const auto add_shared = [&](const std::map<std::string, std::string>& places, bool yours) {
    for (const auto& [place, name] : places) {
      const fs::path path = folder_of_packages(run) / "shared" / (name + ".mustache");
      // Two packages may have it at one place.
      if (ranges::contains(templates, place, &ExtraTemplate::output)) continue;
      templates.push_back({place, path.string(), yours});
    }
  };
  const fs::path standalone = fs::path(run.root) / "templates" / "standalone";
  if (is_standalone(options) && !is_bare(options)) add_folder(standalone / "both");
  if (is_standalone(options) && !options.makes_library()) add_folder(standalone / "program");
  for (const Package& package : packages) {
    const fs::path folder = package.folder;
    add_folder(folder / "both");
    add_folder(folder / (options.makes_library() ? "library" : "program"));
    add_shared(options.makes_library() ? package.library : package.program, false);
    if (options.makes_library()) add_shared(package.yours, true);
  }
  for (auto& item : templates) item.output = with_name(item.output, run.graph->name);
  return templates;
}

void place_headers(const Run& run, const GenerateOptions& options,
                   const std::vector<Package>& packages, const std::vector<ExtraTemplate>& others,
                   std::vector<GeneratedFile>& files) {
  constexpr std::string_view kLicense = "LICENSE";
  if (!options.makes_library() || packages.empty()) return;
  std::vector<GeneratedFile> headers;
  const auto is_other = [&](const GeneratedFile& file) {
    return ranges::contains(others, file.path, &ExtraTemplate::output);
  };
  for (const auto& file : files) {
    if (is_other(file) || file.path.ends_with(".map")) continue;
    if (file.path.starts_with(kHeaderFolder)) {
      headers.push_back({file.path.substr(std::string_view(kHeaderFolder).size()), file.text});
    } else if (file.path.ends_with(kLicense)) {
      headers.push_back({"../" + std::string(kLicense), file.text});
    }
  }
  if (is_bare(options)) std::erase_if(files, std::not_fn(is_other));
  std::set<std::string> placed;
  for (const auto& file : files) placed.insert(file.path);
  for (const Package& package : packages) {
    const fs::path folder = with_name(package.headers, run.graph->name);
    for (const auto& file : headers) {
      const std::string path = (folder / file.path).lexically_normal().generic_string();
      if (placed.insert(path).second) files.push_back({path, file.text});
    }
  }
}

std::string next_steps(Run& run, const GenerateOptions& options,
                       const std::vector<Package>& packages, const std::string& folder) {
  View view = object();
  view.set("name", run.graph->name);
  view.set("folder", folder);
  std::string text;
  for (const Package& package : packages) {
    const std::string file =
        options.makes_library() ? "next.library.sh.mustache" : "next.program.sh.mustache";
    text +=
        render_file((fs::path(package.folder) / file).string(), "next.sh", view, run.diagnostics)
            .value_or("");
  }
  return text;
}

}  // namespace eagerx::gen
