// eagerx-gen new KIND NAME: a folder to begin with, made from the templates of its kind.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>

#include "generator/cli/kinds.hpp"
#include "generator/cli/paths.hpp"
#include "generator/cli/pipeline.hpp"
#include "generator/cli/write.hpp"
#include "generator/emit/render.hpp"
#include "generator/process/process.hpp"
#include "generator/spec/format.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBlank = ".blank";
/// Printed instead of written: the next steps, as commands for a shell.
constexpr std::string_view kNext = "next.sh";

/// my_filter, my-filter → MyFilter
std::string type_of(std::string_view name) {
  std::string type;
  bool begins = true;
  for (const char c : name) {
    if (c == '_' || c == '-') {
      begins = true;
      continue;
    }
    type += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return type;
}

/// MyFilter, my filter → my_filter: a name that was probably meant.
std::string word_of(std::string_view name, char between) {
  std::string word;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter >= 0x80 || std::isalnum(letter) == 0) {
      if (!word.empty() && word.back() != between) word += between;
      continue;
    }
    if (std::isupper(letter) != 0 && !word.empty() && word.back() != between) word += between;
    word += static_cast<char>(std::tolower(letter));
  }
  while (!word.empty() && (word.back() == between)) word.pop_back();
  return word;
}

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
  const std::string type = type_of(name);
  if (kind.defines == "target" && run.library.targets.contains(name)) {
    run.diagnostics.error("E0302", {}, fmt::format("there is already a target `{}`", name));
  } else if (kind.defines == "entity" && run.library.entities.contains(type)) {
    run.diagnostics.error("E0302", {}, fmt::format("there is already an entity `{}`", type)).help =
        "choose another name";
  }
  return !run.diagnostics.has_errors();
}

/// A command that starts this program from where the user is: its name, if the shell finds it.
std::string program_command() {
  std::error_code error;
  const std::string self = fs::read_symlink("/proc/self/exe", error).string();
  const std::string found = find_program("eagerx-gen");
  const bool same = !found.empty() && fs::equivalent(found, self, error);
  return same ? "eagerx-gen" : self;
}

/// Where CMake looks for packages by itself.
bool is_usual(const std::string& package) {
  return std::ranges::any_of(std::array{"/usr/share/", "/usr/local/share/"},
                             [&](const char* each) { return package.starts_with(each); });
}

View view_of(const std::string& name, const fs::path& folder) {
  View view = object();
  view.set("name", name);
  view.set("name_word", word_of(name, '_'));
  view.set("type", type_of(name));
  view.set("version", EAGERX_GEN_VERSION);
  view.set("folder", folder.string());
  view.set("parent", folder.has_parent_path() ? folder.parent_path().string() : ".");
  view.set("program", program_command());
  const std::string package = package_folder();
  view.set("package", text_or_false(is_usual(package) ? "" : package));
  return view;
}

struct NewFile {
  std::string path;
  std::string text;
  bool is_program;
};

/// The kind's templates as files of the new folder, in the order of their paths. `@name@` in a path
/// is the name.
std::vector<NewFile> rendered_files(const Kind& kind, const std::string& name, const View& view,
                                    Run& run) {
  std::vector<NewFile> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(kind.folder, error)) {
    std::string path = entry.path().lexically_relative(kind.folder).string();
    if (!entry.is_regular_file(error) || !path.ends_with(kBlank)) continue;
    path.resize(path.size() - kBlank.size());
    constexpr std::string_view kName = "@name@";
    for (std::size_t at = path.find(kName); at != std::string::npos; at = path.find(kName))
      path.replace(at, kName.size(), name);
    auto text = render_file(entry.path().string(), path, view, run.diagnostics);
    if (!text) return {};
    const bool is_program =
        (entry.status(error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    files.push_back({std::move(path), std::move(*text), is_program});
  }
  std::ranges::sort(files, {}, &NewFile::path);
  return files;
}

bool check_place(const fs::path& folder, Run& run) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return true;
  run.diagnostics
      .io_error("E0902", {}, fmt::format("there is already something at `{}`", folder.string()))
      .help = "choose another name, or another folder with --output";
  return false;
}

/// All or nothing.
void write_folder(const fs::path& folder, const std::vector<NewFile>& files, Run& run) {
  std::error_code error;
  // Beside its place: a folder without some of its files would not be taken for a broken one.
  const fs::path begun =
      folder.parent_path() / fmt::format(".{}.eagerx-gen.new", folder.filename().string());
  fs::remove_all(begun, error);  // of a run that was killed
  bool good = true;
  for (const NewFile& file : files) {
    const fs::path path = begun / file.path;
    if (file.path == kNext) continue;
    fs::create_directories(path.parent_path(), error);
    good = good && write_file(path.string(), file.text, run.diagnostics);
    if (good && file.is_program)
      fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                      fs::perm_options::add, error);
  }
  if (good) fs::rename(begun, folder, error);
  if (good && error)
    run.diagnostics.io_error("E0901", {},
                             fmt::format("cannot make `{}`: {}", folder.string(), error.message()));
  fs::remove_all(begun, error);
}

void print_next(const fs::path& folder, const std::vector<NewFile>& files) {
  std::string names, next;
  for (const NewFile& file : files) {
    if (file.path == kNext)
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
      !check_place(folder, run) || !check_id(*kind, options.entity, run))
    return finish(run, options);
  const auto files = rendered_files(*kind, options.entity, view_of(options.entity, folder), run);
  if (!run.diagnostics.has_errors()) write_folder(folder, files, run);
  if (!run.diagnostics.has_errors() && !options.quiet) print_next(folder, files);
  return finish(run, options);
}

}  // namespace eagerx::gen
