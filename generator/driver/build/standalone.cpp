#include "generator/driver/build/standalone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// The name in `#include "name"` or `#include <name>`: [from, to) of the line.
struct Included {
  std::size_t from, to;
  bool quoted;
};

std::optional<Included> included(std::string_view line) {
  constexpr std::string_view kSpace = " \t";
  std::size_t at = line.find_first_not_of(kSpace);
  if (at == std::string_view::npos || line[at] != '#') return std::nullopt;
  at = line.find_first_not_of(kSpace, at + 1);
  constexpr std::string_view kInclude = "include";
  if (at == std::string_view::npos || !line.substr(at).starts_with(kInclude)) return std::nullopt;
  at = line.find_first_not_of(kSpace, at + kInclude.size());
  if (at == std::string_view::npos || (line[at] != '"' && line[at] != '<')) return std::nullopt;
  const std::size_t to = line.find(line[at] == '"' ? '"' : '>', at + 1);
  if (to == std::string_view::npos || to == at + 1) return std::nullopt;
  return Included{at + 1, to, line[at] == '"'};
}

/// Whether it may lead elsewhere in another tree: `"../x.hpp"`, `"a/../../x.hpp"`,
/// `"/home/me/x.hpp"`.
bool leads_away(const fs::path& name) {
  return name.is_absolute() || ranges::contains(name, fs::path(".."));
}

/// The file that a compiler finds at `place`: `..` behind a symbolic link is where that points to.
/// (The folder of the output need not be there yet.)
std::optional<fs::path> found_at(const fs::path& place) {
  std::error_code error;
  const fs::path path = fs::absolute(place, error);
  const fs::path short_path = path.lexically_normal();
  if (fs::is_regular_file(path, error) && !fs::equivalent(path, short_path, error)) {
    const fs::path real = fs::canonical(path, error);
    return error ? std::nullopt : std::optional(real);
  }
  return fs::is_regular_file(short_path, error) ? std::optional(short_path) : std::nullopt;
}

constexpr const char* kShareFolder = "eagerx-gen/";

class Carrier {
 public:
  Carrier(Run& run, const std::string& output, std::vector<GeneratedFile>& files)
      : run_(run), output_(output), files_(files) {
    std::set<std::string> roots = {run.root};
    for (const auto& [id, entity] : run.library.entities) roots.insert(entity.include_root);
    for (const auto& root : roots) {
      if (!root.empty()) roots_.push_back(absolute_path(root).lexically_normal());
    }
  }

  bool run(const std::vector<const Target*>& targets, bool only_headers) {
    for (const auto& file : files_) generated_.insert(file.path);
    if (!only_headers) add_package_files(targets);
    add_file(fs::path(run_.root) / "LICENSE",
             only_headers ? std::string("LICENSE") : std::string(kShareFolder) + "LICENSE");
    // Grows while it goes: headers include others.
    for (std::size_t i = 0; i < files_.size(); ++i) scan(i);
    return !failed_;
  }

 private:
  /// Files that stand for the installed package.
  void add_package_files(const std::vector<const Target*>& targets) {
    add_folder("targets/common");
    for (const Target* target : targets) add_target(*target);
    add_folder("runtime/host");
    add_folder("toolchains");
    for (const char* name : {"flags.cmake", "flags.txt"})
      add_file(fs::path(run_.root) / "runtime" / name, std::string(kShareFolder) + name);
  }

  /// The target's folder, and those that its target.cmake names.
  void add_target(const Target& target) {
    const std::string folder = target.templates.empty() ? std::string() : folder_of(target);
    std::vector<std::string> todo = {folder};
    std::set<std::string> seen;
    while (!todo.empty()) {
      const std::string name = todo.back();
      todo.pop_back();
      if (name.empty() || name == "common" || !seen.insert(name).second) continue;
      add_folder("targets/" + name);
      const std::string text =
          read(fs::path(run_.root) / "targets" / name / "target.cmake").value_or("");
      constexpr std::string_view kNamed = "${EAGERX_TARGETS_DIR}/";
      for (auto at = text.find(kNamed); at != std::string::npos; at = text.find(kNamed, at + 1)) {
        const auto from = at + kNamed.size();
        const auto to = text.find_first_of("/) \t\n", from);
        if (to != std::string::npos && text[to] == '/')
          todo.push_back(text.substr(from, to - from));
      }
    }
  }

  /// Below targets/; a board of the user's own has its folder elsewhere.
  std::string folder_of(const Target& target) {
    const std::string& id = target.id.value;
    if (fs::exists(fs::path(run_.root) / "targets" / id)) return id;
    const fs::path own = fs::path(run_.sources.name(target.id.span.file)).parent_path();
    add_folder(own, std::string(kShareFolder) + "targets/" + id);
    return {};
  }

  void add_folder(const std::string& name) {
    add_folder(fs::path(run_.root) / name, kShareFolder + name);
  }

  void add_folder(const fs::path& folder, const std::string& to) {
    std::error_code error;
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
      const std::string extension = entry.path().extension();
      static const std::set<std::string> kKinds = {".cpp", ".hpp",  ".h",  ".cmake",
                                                   ".ld",  ".yaml", ".idl"};
      if (entry.is_regular_file(error) && kKinds.contains(extension)) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    for (const auto& path : found)
      add_file(path, to + "/" + path.lexically_relative(folder).generic_string());
  }

  static std::optional<std::string> read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  void add_file(const fs::path& from, const std::string& to) {
    if (generated_.contains(to)) return refuse_second(to, "what is generated", from);
    if (!added_.insert(to).second) {
      const fs::path& first = from_[to];
      if (first != from && read(first) != read(from))
        refuse_second(to, fmt::format("`{}`", first.string()), from);
      return;
    }
    auto text = read(from);
    if (!text) {
      run_.diagnostics.io_error("E0901", {}, fmt::format("cannot read `{}`", from.string()));
      failed_ = true;
      return;
    }
    files_.push_back({to, std::move(*text)});
    from_[to] = from;
  }

  void refuse_second(const std::string& to, const std::string& first, const fs::path& second) {
    if (!refused_.insert(second).second) return;
    failed_ = true;
    run_.diagnostics
        .error("E0907", place_in_manifest(second),
               fmt::format("`{}` would be both {} and `{}`", to, first, second.string()))
        .help = "rename one of them, or its folder";
  }

  /// Where a manifest names this header.
  Span place_in_manifest(const fs::path& header) const {
    Span place;
    const auto look = [&](const std::string& root, const CppClass& cpp) {
      if (!cpp.include.empty() && (fs::path(root) / cpp.include).lexically_normal() == header)
        place = cpp.header;
    };
    for (const auto& [id, entity] : run_.library.entities) {
      look(entity.include_root, entity.cpp);
      look(entity.include_root, entity.simulator);
      for (const auto& engine : entity.object_engines) look(engine.include_root, engine.model);
    }
    return place;
  }

  /// Adds what a file includes. `"../library/x.hpp"` becomes the way from this file to where it is
  /// then: another tree of the same program may have another `library/x.hpp` in its include path.
  void scan(std::size_t index) {
    std::stringstream lines(files_[index].text);
    std::string text;
    const std::string path = files_[index].path;
    std::uint32_t number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      if (const auto include = included(line)) {
        const std::string name = line.substr(include->from, include->to - include->from);
        const Line here{path, number, *include};
        const auto place = carried(here, name);
        if (place && leads_away(name))
          line.replace(include->from - 1, name.size() + 2, '"' + way_to(*place, path) + '"');
      }
      text += line + "\n";
    }
    if (!files_[index].text.empty() && files_[index].text.back() == '\n') files_[index].text = text;
  }

  /// How `file` includes a header below src/. What all trees have alike is found in the include
  /// path, so that it is there once.
  std::string way_to(const std::string& header, const std::string& file) const {
    const fs::path root = absolute_path(run_.root).lexically_normal();
    const auto origin = from_.find(kHeaderFolder + header);
    const bool is_own =
        origin != from_.end() && *origin->second.lexically_relative(root).begin() == "..";
    if (!is_own || !file.starts_with(kHeaderFolder)) return header;
    return fs::path(kHeaderFolder + header)
        .lexically_relative(fs::path(file).parent_path())
        .generic_string();
  }

  /// An `#include` in a file of the tree.
  struct Line {
    const std::string& file;
    std::uint32_t number;
    Included name;
  };

  /// Where an included header is below src/; nullopt if it is none of ours (`<array>`), or is there
  /// already.
  std::optional<std::string> carried(const Line& line, const std::string& name) {
    std::vector<fs::path> places;
    const auto origin = from_.find(line.file);
    if (line.name.quoted) {
      const fs::path same_folder = origin == from_.end()
                                       ? fs::path(output_) / fs::path(line.file).parent_path()
                                       : origin->second.parent_path();
      places.push_back(same_folder / name);
    }
    const std::size_t in_same_folder = places.size();
    places.push_back(fs::path(run_.root) / "runtime" / name);
    for (const auto& root : roots_) places.push_back(root / name);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i == in_same_folder && generated_.contains(kHeaderFolder + name)) return std::nullopt;
      const auto path = found_at(places[i]);
      if (!path) continue;
      auto relative = relative_to_root(*path);
      if (!relative && origin == from_.end() && is_in_output(*path))
        return std::nullopt;  // of an earlier run
      if (!relative) {
        refuse_outside(line, *path);
        return std::nullopt;
      }
      // Headers that programs of targets include are already copied.
      if (!line.file.starts_with(kHeaderFolder) &&
          (relative->starts_with("targets/") || is_in_package(*path)))
        return std::nullopt;
      add_file(*path, kHeaderFolder + *relative);
      return relative;
    }
    return std::nullopt;
  }

  /// A header that a manifest names, or one that another header includes.
  void refuse_outside(const Line& line, const fs::path& path) {
    if (!refused_.insert(path).second) return;
    failed_ = true;
    Span place = place_in_manifest(path);
    const auto origin = from_.find(line.file);
    if (origin != from_.end()) {
      const FileId file =
          run_.sources.add(origin->second.string(), read(origin->second).value_or(""));
      place = {file, line.number, static_cast<std::uint32_t>(line.name.from + 1),
               static_cast<std::uint32_t>(line.name.to - line.name.from)};
    }
    run_.diagnostics
        .error("E0904", place,
               fmt::format("`{}` includes `{}`, which is in no folder of entities", line.file,
                           path.string()))
        .help =
        "move it below the folder that `library:` or `--path` names, or next to that folder: a "
        "tree "
        "has what lies there, too";
  }

  bool is_in_output(const fs::path& path) const {
    const fs::path relative = path.lexically_relative(absolute_path(output_).lexically_normal());
    return !relative.empty() && *relative.begin() != "..";
  }

  /// Whether it has its place in what stands for the installed package.
  bool is_in_package(const fs::path& path) const {
    const fs::path root = absolute_path(run_.root).lexically_normal();
    return added_.contains(kShareFolder + path.lexically_relative(root).generic_string());
  }

  std::optional<std::string> relative_to_root(const fs::path& path) const {
    std::vector<fs::path> roots = {
        absolute_path(fs::path(run_.root) / "runtime").lexically_normal()};
    roots.insert(roots.end(), roots_.begin(), roots_.end());
    for (const auto& root : roots) {
      const std::string relative = path.lexically_relative(root).generic_string();
      if (!relative.empty() && !relative.starts_with("..")) return relative;
    }
    return std::nullopt;
  }

  Run& run_;
  std::string output_;
  std::vector<GeneratedFile>& files_;
  std::vector<fs::path> roots_;      // of headers
  std::set<std::string> generated_;  // paths in the tree
  std::set<std::string> added_;
  std::set<fs::path> refused_;
  std::map<std::string, fs::path> from_;  // where a file of the tree was copied from
  bool failed_ = false;
};

}  // namespace

bool carry_along(Run& run, const std::vector<const Target*>& targets, const std::string& output,
                 bool only_headers, std::vector<GeneratedFile>& files) {
  return Carrier(run, output, files).run(targets, only_headers);
}

}  // namespace eagerx::gen
