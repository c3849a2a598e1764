// eagerx-gen new KIND NAME: a folder to begin with, made from the templates of its kind.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "generator/cli/kinds.hpp"
#include "generator/cli/new_folder.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/spec/format.hpp"

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
         name.back() != between && std::ranges::all_of(name, allowed);
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

/// What it would define must not be there: no graph could tell the two apart.
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

}  // namespace

int new_command(const Options& options) {
  Run run;
  const auto kind = read_kind(options.kind, run.sources, run.diagnostics);
  if (!kind) return finish(run, options);
  const fs::path parent = !options.output.empty() ? options.output : kind->parent;
  load(run, options);
  const fs::path folder = parent / options.entity;
  if (run.diagnostics.has_errors() || !check_name(*kind, options.entity, run) ||
      !is_free_place(folder, run.diagnostics) || !check_id(*kind, options.entity, run))
    return finish(run, options);
  const auto files = rendered_files(kind->folder, options.entity,
                                    view_of_new(options.entity, folder), run.diagnostics);
  if (!run.diagnostics.has_errors()) write_new_folder(folder, files, run.diagnostics);
  if (!run.diagnostics.has_errors() && !options.quiet) print_next(folder, files);
  return finish(run, options);
}

}  // namespace eagerx::gen
