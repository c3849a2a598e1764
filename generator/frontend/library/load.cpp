// From folders to a library: which manifests there are, and which of them are read.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/library/mentions.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/paths.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

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
  const auto found = library.entities.find(object.value);
  if (found == library.entities.end() || found->second.kind != EntityKind::object) {
    diagnostics
        .error("E0303", object.span,
               fmt::format("there is no object `{}` to implement", object.value))
        .help = did_you_mean(object.value, library.ids(EntityKind::object));
    return;
  }
  auto& engines = found->second.object_engines;
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

/// A manifest whose text is loaded, not read yet.
struct Manifest {
  std::string path;
  fs::path include_root;
  FileId file = FileId::none;
};

class Loader {
 public:
  Loader(SourceMap& sources, Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {}

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

  void read(const Manifest& manifest, Mentions* mentions = nullptr) {
    trees_.push_back(read_loaded_yaml(manifest.file, sources_, diagnostics_));
    const YamlValue& tree = trees_.back();
    if (tree.is_null()) return;
    if (mentions != nullptr) mentions->add_manifest(tree);
    const YamlValue* kind = tree.find("kind");
    if (kind != nullptr && kind->text == "target") {
      if (auto target = read_target_manifest(tree, manifest.path, diagnostics_))
        add(library_.targets, *target, sources_, diagnostics_);
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
      add(library_.entities, *entity, sources_, diagnostics_);
    }
  }

  Library take() {
    for (auto& implementation : implementations_)
      add_to_object(library_, std::move(implementation), sources_, diagnostics_);
    return std::move(library_);
  }

 private:
  SourceMap& sources_;
  Diagnostics& diagnostics_;
  Library library_;
  std::vector<std::string> done_;
  std::vector<Implementation> implementations_;
  std::deque<YamlValue> trees_;  // which mentions point into
};

}  // namespace

Library load_library(const std::vector<Spanned<std::string>>& folders, SourceMap& sources,
                     Diagnostics& diagnostics) {
  Loader loader(sources, diagnostics);
  for (const auto& folder : folders) {
    for (const Manifest& manifest : loader.load(folder)) loader.read(manifest);
  }
  return loader.take();
}

Library load_mentioned(Mentions mentions, const std::vector<Spanned<std::string>>& folders,
                       const std::vector<Spanned<std::string>>& installed, SourceMap& sources,
                       Diagnostics& diagnostics) {
  Loader loader(sources, diagnostics);
  for (const auto& folder : folders) {
    for (const Manifest& manifest : loader.load(folder)) loader.read(manifest, &mentions);
  }
  // Every text is loaded, so that places are in the same order as in a library that is read whole.
  std::map<std::string, std::vector<Manifest>> unread;
  for (const auto& folder : installed) {
    for (Manifest& manifest : loader.load(folder)) {
      if (const auto id = declared_id(sources.text(manifest.file)))
        unread[std::string(*id)].push_back(std::move(manifest));
      else
        loader.read(manifest, &mentions);
    }
  }
  while (const auto text = mentions.next()) {
    const auto found = unread.find(*text);
    if (found == unread.end()) continue;
    for (const Manifest& manifest : found->second) loader.read(manifest, &mentions);
    unread.erase(found);
  }
  Library library = loader.take();
  library.whole = unread.empty();
  return library;
}

}  // namespace eagerx::gen
