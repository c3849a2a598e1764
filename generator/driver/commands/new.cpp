// eagerx-gen new KIND NAME: makes a folder to start from, using the templates of its kind.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/commands/kinds.hpp"
#include "generator/driver/commands/new_example.hpp"
#include "generator/driver/commands/new_folder.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// A plain name: of a folder, of a class, of a target of CMake, of a graph.
bool is_plain(std::string_view name, char between) {
  const auto allowed = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == between;
  };
  constexpr std::size_t kLongest = 64;
  return !name.empty() && name.size() <= kLongest && name.front() >= 'a' && name.front() <= 'z' &&
         name.back() != between && ranges::all_of(name, allowed);
}

/// Whether C++ and generated code leave the name free.
bool is_good(std::string_view name) {
  return is_identifier(name) && !is_reserved_name(name);
}

bool check_name(const Kind& kind, const std::string& name, Run& run) {
  const char between = kind.dashes ? '-' : '_';
  if (is_plain(name, between) && (kind.dashes || is_good(name))) return true;
  auto& problem = run.diagnostics.error(
      "E0303", {}, fmt::format("`{}` cannot be the name of {}", name, kind.with_article()));
  problem.help = fmt::format("use lower-case letters, digits and `{}`, a letter first", between);
  if (is_plain(name, between)) problem.help = "C++ or generated code uses this word itself";
  const std::string meant = word_of(name, between);
  if (meant != name && is_plain(meant, between) && (kind.dashes || is_good(meant)))
    problem.help += fmt::format(", such as `{}`", meant);
  return false;
}

/// The id must be new: no graph could tell two entities with one id apart.
bool check_id(const Kind& kind, const std::string& name, Run& run) {
  const std::string type = class_name_of(name);
  if (kind.defines == "target" && run.library.targets.contains(name)) {
    run.diagnostics.error("E0302", {}, fmt::format("there is already a target `{}`", name));
  } else if (kind.defines == "entity" && run.library.entities.contains(type)) {
    run.diagnostics.error("E0302", {}, fmt::format("there is already an entity `{}`", type)).help =
        "choose another name";
  }
  return !run.diagnostics.has_errors();
}

void print_next(const fs::path& folder, const std::vector<NewFile>& files) {
  std::string names, next;
  for (const NewFile& file : files) {
    if (file.path == kNextSteps)
      next = file.text;
    else
      names += (names.empty() ? "" : ", ") + file.path;
  }
  say("{}: {}\n{}", folder.string(), names, next);
}

struct NewOptions : LibraryOptions {
  std::string kind, name;
  std::string output;  // the folder around the new one; empty: that of its kind
};

/// Not one of the kinds with templates: it is copied as it is.
constexpr const char* kExample = "example";

int copy(const NewOptions& options, Run& run) {
  const auto folders = copy_example(options.name, options.output, run.diagnostics);
  if (!folders.empty() && !options.quiet) {
    for (std::size_t i = 1; i < folders.size(); ++i)
      say("{}: an example that it uses\n", folders[i].string());
    const fs::path& folder = folders.front();
    std::error_code error;
    const bool has_graph = fs::exists(folder / "graph.yaml", error);
    say("{0}: begin with {0}/README.md\n\n  cd {0}{1}\n", folder.string(),
        has_graph ? "\n  eagerx-gen run graph.yaml" : "");
  }
  return finish(run, options);
}

std::vector<std::string> all_kinds() {
  std::vector<std::string> kinds = kinds_of_new();
  if (!example_names().empty()) kinds.emplace_back(kExample);
  std::ranges::sort(kinds);
  return kinds;
}

int perform(const NewOptions& options) {
  Run run;
  if (options.kind == kExample) return copy(options, run);
  const auto kind = read_kind(options.kind, run.sources, run.diagnostics);
  if (!kind) return finish(run, options);
  const fs::path parent = !options.output.empty() ? options.output : kind->parent;
  load(run, options);
  const fs::path folder = parent / options.name;
  if (run.diagnostics.has_errors() || !check_name(*kind, options.name, run) ||
      !is_free_place(folder, run.diagnostics) || !check_id(*kind, options.name, run))
    return finish(run, options);
  const auto files = rendered_files(kind->folder, options.name, view_of_new(options.name, folder),
                                    run.diagnostics);
  if (!run.diagnostics.has_errors()) write_new_folder(folder, files, run.diagnostics);
  if (!run.diagnostics.has_errors() && !options.quiet) print_next(folder, files);
  return finish(run, options);
}

Command table(NewOptions& options) {
  Argument kind = required(choice("kind", all_kinds(), "kind of the folder",
                                  [&options](const std::string& name) { options.kind = name; }));
  if (kind.choices.empty()) kind.type = "KIND";  // its data are missing, which perform() says
  return {
      .name = "new",
      .about = "make a folder with a project, an example, an entity or a board to start from",
      .examples = {{"a project with a graph that runs", "eagerx-gen new project my_robot"},
                   {"a copy of an example or a tutorial",
                    "eagerx-gen new example tutorial_1_environment_creation"},
                   {"in the project, a node with a test", "eagerx-gen new node my_filter"},
                   {"a board, in targets/my-board", "eagerx-gen new board my-board"}},
      .arguments = joined(
          {{std::move(kind),
            required(text("name", options.name, "name of the folder and of its contents", "NAME")),
            folder(text("-o,--output", options.output,
                        "parent folder (default: the current folder; for a board: targets)",
                        "DIR"))},
           diagnostics(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command new_command() {
  return with_options<NewOptions>(table);
}

}  // namespace eagerx::gen
