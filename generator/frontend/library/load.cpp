// Loads a library from folders: finds the manifests, and reads those that are needed.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWord =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

/// Copies in an output of eagerx-gen in `folder`, as its list names them: what a standalone tree
/// has of the installed package is no entity. (What eagerx-urdf writes is one, and has a list,
/// too.)
void add_generated(const fs::path& folder, std::set<fs::path>& generated) {
  std::ifstream list(folder / "eagerx-gen.files");
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with("eagerx-gen/")) generated.insert((folder / line).lexically_normal());
  }
}

/// Manifests below `folder`, sorted, so that the order of a directory listing never matters.
std::vector<std::string> find_manifests(const Spanned<std::string>& folder,
                                        Diagnostics& diagnostics) {
  std::vector<std::string> result;
  std::error_code error;
  std::set<fs::path> generated;
  add_generated(folder.value, generated);
  fs::recursive_directory_iterator walk(folder.value, fs::directory_options::skip_permission_denied,
                                        error);
  for (; !error && walk != fs::recursive_directory_iterator(); walk.increment(error)) {
    if (walk.depth() > 8) walk.disable_recursion_pending();
    std::error_code ignored;
    if (walk->is_directory(ignored)) add_generated(walk->path(), generated);
    if (walk->path().filename() == "manifest.yaml") result.push_back(walk->path().string());
  }
  std::erase_if(result, [&](const std::string& path) {
    return generated.contains(fs::path(path).lexically_normal());
  });
  if (error) {
    const bool missing = error == std::errc::no_such_file_or_directory;
    diagnostics
        .io_error("E0301", folder.span,
                  fmt::format("cannot read the folder `{}`: {}", folder.value,
                              missing ? "it does not exist" : error.message()))
        .help = missing ? "`library:` names folders from the graph's file on, `--path` from the "
                          "folder that you are in"
                        : "";
  }
  std::ranges::sort(result);
  return result;
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Whether two manifests are the same file, or copies of it: in a clone of this repository
/// `--path targets` has all that an installed eagerx-gen has, too. A copy with a header of its own
/// is none.
bool are_copies(const Span& first, const Span& second, const SourceMap& sources) {
  if (sources.text(first.file) != sources.text(second.file)) return false;
  const fs::path one = fs::path(sources.name(first.file)).parent_path();
  const fs::path two = fs::path(sources.name(second.file)).parent_path();
  std::error_code error;
  fs::recursive_directory_iterator walk(two, error);
  for (; !error && walk != fs::recursive_directory_iterator(); walk.increment(error)) {
    std::error_code ignored;
    const fs::path other = one / walk->path().lexically_relative(two);
    if (!walk->is_regular_file(ignored) || !fs::is_regular_file(other, ignored)) continue;
    if (walk->path().filename() != "README.md" && content(walk->path()) != content(other))
      return false;
  }
  return true;
}

/// Of two copies the first one counts.
template <class Item>
void add(std::map<std::string, Item>& items, Item item, const SourceMap& sources,
         Diagnostics& diagnostics) {
  const auto [place, added] = items.try_emplace(item.id.value, item);
  if (added || are_copies(place->second.id.span, item.id.span, sources)) return;
  auto& problem =
      diagnostics.error("E0302", item.id.span, fmt::format("`{}` is defined twice", item.id.value));
  problem.notes.push_back({"first here", place->second.id.span, ""});
}

/// Headers are included relative to the parent of the library folder: `<models/nodes/…>`.
void make_relative(CppClass& cpp, const fs::path& root) {
  if (cpp.include.empty()) return;
  cpp.include =
      absolute_path(cpp.include).lexically_normal().lexically_relative(root).generic_string();
}

void set_include_root(ObjectEngine& implementation, const fs::path& root) {
  implementation.include_root = root.string();
  make_relative(implementation.model, root);
}

void set_include_root(Entity& entity, const fs::path& root) {
  entity.include_root = root.string();
  make_relative(entity.cpp, root);
  make_relative(entity.simulator, root);
  for (auto& implementation : entity.object_engines) set_include_root(implementation, root);
}

/// Implementations that have manifests of their own are the objects' as if they stood there.
void add_to_object(Library& library, Implementation implementation, const SourceMap& sources,
                   Diagnostics& diagnostics) {
  // No structured binding: clang 14 lets no lambda capture one.
  const Spanned<std::string>& object = implementation.object;
  const ObjectEngine& engine = implementation.engine;
  const Entity* const found = library.find(object.value);
  if (found == nullptr || found->kind != EntityKind::object) {
    diagnostics
        .error("E0303", object.span,
               fmt::format("there is no object `{}` to implement", object.value))
        .help = did_you_mean(object.value, library.ids(EntityKind::object));
    return;
  }
  auto& engines = library.entities.at(object.value).object_engines;
  const auto first = ranges::find(
      engines, engine.engine.value, [](const auto& each) -> auto& { return each.engine.value; });
  if (first != engines.end()) {
    if (are_copies(first->engine.span, engine.engine.span, sources)) return;
    diagnostics
        .error("E0302", engine.engine.span,
               fmt::format("`{}` is implemented for `{}` twice", object.value, engine.engine.value))
        .notes.push_back({"first here", first->engine.span, ""});
    return;
  }
  engines.push_back(std::move(implementation.engine));
}

}  // namespace

class ManifestLoader {
 public:
  /// One whose text is loaded, not read yet.
  struct Manifest {
    std::string path;
    fs::path include_root;
    FileId file = FileId::none;
  };

  ManifestLoader(SourceMap& sources, Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {}

  /// Keeps the manifest for `read_id` if its text says its id, else reads it.
  void keep(Manifest manifest, Library& library) {
    if (const auto id = declared_id(sources_.text(manifest.file)))
      unread_[std::string(*id)].push_back(std::move(manifest));
    else
      read(manifest, library);
  }

  void read_id(const std::string& id, const Library& library) {
    if (const auto found = unread_.extract(id)) {
      for (const Manifest& manifest : found.mapped()) read(manifest, library);
    }
  }
  /// Reads those whose ids were read already, which is an error.
  void find_twice(const Library& library) {
    std::vector<std::string> ids;
    for (const auto& [id, entity] : library.entities) ids.push_back(id);
    for (const auto& [id, target] : library.targets) ids.push_back(id);
    for (const std::string& id : ids) read_id(id, library);
  }
  void read_all(const Library& library) {
    while (!unread_.empty()) read_id(std::string(unread_.begin()->first), library);
  }

  /// The manifests of a folder that none of the others was, in the order of their paths.
  std::vector<Manifest> load(const Spanned<std::string>& folder) {
    std::error_code error;
    const fs::path root = fs::absolute(folder.value, error).lexically_normal();
    if (folder.value.empty() || error) {
      diagnostics_.io_error("E0301", folder.span,
                            folder.value.empty() ? "a folder of a library has no name"
                                                 : fmt::format("cannot read the folder `{}`: {}",
                                                               folder.value, error.message()));
      return {};
    }
    const std::string key = (root.has_filename() ? root : root.parent_path()).string();
    if (contains(done_, key)) return {};
    done_.push_back(key);
    std::vector<Manifest> manifests;
    for (const auto& path : find_manifests(folder, diagnostics_)) {
      if (const auto file = load_yaml_file(path, sources_, diagnostics_))
        manifests.push_back({path, fs::path(key).parent_path(), *file});
    }
    return manifests;
  }

  void read(const Manifest& manifest, const Library& library) {
    const YamlValue tree = read_loaded_yaml(manifest.file, sources_, diagnostics_);
    if (tree.is_null()) return;
    const YamlValue* kind = tree.find("kind");
    if (kind != nullptr && kind->text == "target") {
      if (auto target = read_target_manifest(tree, manifest.path, diagnostics_))
        add(library.targets, *target, sources_, diagnostics_);
      return;
    }
    if (kind != nullptr && kind->text == "implementation") {
      if (auto implementation = read_implementation_manifest(tree, manifest.path, diagnostics_)) {
        set_include_root(implementation->engine, manifest.include_root);
        implementations_.push_back(std::move(*implementation));
      }
      return;
    }
    if (auto entity = read_entity_manifest(tree, manifest.path, diagnostics_)) {
      set_include_root(*entity, manifest.include_root);
      add(library.entities, *entity, sources_, diagnostics_);
    }
  }

  void add_implementations(Library& library) {
    for (auto& implementation : implementations_)
      add_to_object(library, std::move(implementation), sources_, diagnostics_);
    implementations_.clear();
  }

 private:
  SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::vector<std::string> done_;
  std::vector<Implementation> implementations_;
  std::map<std::string, std::vector<Manifest>> unread_;  // by the id
};

const Entity* Library::find(const std::string& id) const {
  if (unread != nullptr) unread->read_id(id, *this);
  const auto found = entities.find(id);
  return found == entities.end() ? nullptr : &found->second;
}

const Target* Library::find_target(const std::string& id) const {
  if (unread != nullptr) unread->read_id(id, *this);
  const auto found = targets.find(id);
  return found == targets.end() ? nullptr : &found->second;
}

void Library::read_all() const {
  if (unread != nullptr) unread->read_all(*this);
}

const std::map<std::string, Entity>& Library::all_entities() const {
  read_all();
  return entities;
}

const std::map<std::string, Target>& Library::all_targets() const {
  read_all();
  return targets;
}

Library load_library(const std::vector<Spanned<std::string>>& folders, SourceMap& sources,
                     Diagnostics& diagnostics, const std::vector<Spanned<std::string>>& installed) {
  Library library;
  auto loader = std::make_shared<ManifestLoader>(sources, diagnostics);
  for (const auto& folder : folders) {
    for (const auto& manifest : loader->load(folder)) loader->read(manifest, library);
  }
  // Every text is loaded, so that places are in the same order whatever is read first.
  for (const auto& folder : installed) {
    for (auto& manifest : loader->load(folder)) loader->keep(std::move(manifest), library);
  }
  if (!installed.empty()) library.unread = loader;
  loader->find_twice(library);
  loader->add_implementations(library);
  return library;
}

std::optional<std::string_view> declared_id(std::string_view text) {
  constexpr std::string_view kKey = "\nid:";
  std::size_t at = text.starts_with(kKey.substr(1)) ? kKey.size() - 1 : std::string_view::npos;
  if (const std::size_t line = text.find(kKey); line != std::string_view::npos) {
    const bool twice =
        at != std::string_view::npos || text.find(kKey, line + 1) != std::string_view::npos;
    if (twice) return std::nullopt;
    at = line + kKey.size();
  }
  if (at == std::string_view::npos || text.substr(at, 1) != " ") return std::nullopt;
  const std::string_view line = text.substr(at, text.find('\n', at) - at);
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t end = std::min(line.find_first_not_of(kWord, begin), line.size());
  const std::string_view rest = line.substr(end);
  const std::size_t next = std::min(rest.find_first_not_of(' '), rest.size());
  const bool ends = next == rest.size() || (next > 0 && rest[next] == '#');
  if (end == begin || !ends) return std::nullopt;
  return line.substr(begin, end - begin);
}

}  // namespace eagerx::gen
