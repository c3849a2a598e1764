#include "generator/cli/standalone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

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

constexpr const char* kShareFolder = "eagerx-gen/";

class Carrier {
 public:
  Carrier(Run& run, const std::string& output, std::vector<GeneratedFile>& files)
      : run_(run), output_(output), files_(files) {
    std::set<std::string> roots = {run.root};
    for (const auto& [id, entity] : run.library.entities) roots.insert(entity.include_root);
    for (const auto& root : roots) {
      if (!root.empty()) roots_.push_back(fs::absolute(root).lexically_normal());
    }
  }

  bool run(const std::vector<const Target*>& targets, bool only_headers) {
    if (!only_headers) add_package_files(targets);
    add_file(fs::path(run_.root) / "LICENSE",
             only_headers ? std::string("LICENSE") : std::string(kShareFolder) + "LICENSE");
    // Grows while it goes: headers include others.
    for (std::size_t i = 0; i < files_.size(); ++i) scan(i);
    return !failed_;
  }

 private:
  /// What stands for the installed package.
  void add_package_files(const std::vector<const Target*>& targets) {
    add_folder("targets/common");
    for (const Target* target : targets) add_target(*target);
    add_folder("runtime/host");
    add_folder("toolchains");
    add_file(fs::path(run_.root) / "runtime" / "flags.cmake",
             std::string(kShareFolder) + "flags.cmake");
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
      static const std::set<std::string> kKinds = {".cpp", ".hpp", ".h", ".cmake", ".ld", ".yaml"};
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
    if (!added_.insert(to).second) return;
    auto text = read(from);
    if (!text) {
      run_.diagnostics.io_error("E0901", {}, fmt::format("cannot read `{}`", from.string()));
      failed_ = true;
      return;
    }
    files_.push_back({to, std::move(*text)});
    from_[to] = from;
  }

  /// Adds what a file includes. `"../library/x.hpp"` becomes `"library/x.hpp"`, which is where it
  /// is then.
  void scan(std::size_t index) {
    std::stringstream lines(files_[index].text);
    std::string text;
    const std::string path = files_[index].path;
    for (std::string line; std::getline(lines, line);) {
      if (const auto include = included(line)) {
        const std::string name = line.substr(include->from, include->to - include->from);
        const auto place = carried(path, name, include->quoted);
        if (place && name.starts_with(".."))
          line.replace(include->from - 1, name.size() + 2, '"' + *place + '"');
      }
      text += line + "\n";
    }
    if (!files_[index].text.empty() && files_[index].text.back() == '\n') files_[index].text = text;
  }

  /// Where an included header is below src/; nullopt if it is none of ours (`<array>`), or is there
  /// already.
  std::optional<std::string> carried(const std::string& includer, const std::string& name,
                                     bool quoted) {
    std::vector<fs::path> places;
    if (quoted) {
      const auto origin = from_.find(includer);
      const fs::path beside = origin == from_.end()
                                  ? fs::path(output_) / fs::path(includer).parent_path()
                                  : origin->second.parent_path();
      places.push_back(beside / name);
    }
    places.push_back(fs::path(run_.root) / "runtime" / name);
    for (const auto& root : roots_) places.push_back(root / name);
    for (const auto& place : places) {
      const fs::path path = fs::absolute(place).lexically_normal();
      std::error_code ignored;
      if (!fs::is_regular_file(path, ignored)) continue;
      auto relative = relative_to_root(path);
      if (!relative && !from_.contains(includer)) return std::nullopt;  // of an earlier run
      if (!relative) {
        run_.diagnostics
            .error("E0904", {},
                   fmt::format("`{}` includes `{}`, which is in no folder of entities", includer,
                               path.string()))
            .help = "move it below the folder that `library:` or `--path` names";
        failed_ = true;
        return std::nullopt;
      }
      // What programs of targets include is there already.
      if (!includer.starts_with(kHeaderFolder) &&
          (relative->starts_with("targets/") || is_in_package(path)))
        return std::nullopt;
      add_file(path, kHeaderFolder + *relative);
      return relative;
    }
    return std::nullopt;
  }

  /// Whether it has its place in what stands for the installed package.
  bool is_in_package(const fs::path& path) const {
    const fs::path root = fs::absolute(run_.root).lexically_normal();
    return added_.contains(kShareFolder + path.lexically_relative(root).generic_string());
  }

  std::optional<std::string> relative_to_root(const fs::path& path) const {
    std::vector<fs::path> roots = {
        fs::absolute(fs::path(run_.root) / "runtime").lexically_normal()};
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
  std::vector<fs::path> roots_;  // of headers
  std::set<std::string> added_;
  std::map<std::string, fs::path> from_;  // where a file of the tree was copied from
  bool failed_ = false;
};

}  // namespace

bool carry_along(Run& run, const std::vector<const Target*>& targets, const std::string& output,
                 bool only_headers, std::vector<GeneratedFile>& files) {
  return Carrier(run, output, files).run(targets, only_headers);
}

}  // namespace eagerx::gen
