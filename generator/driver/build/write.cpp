#include "generator/driver/build/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <runtime/host/base/files.hpp>
#include <set>
#include <sstream>

#include "generator/driver/build/folder.hpp"
#include "generator/support/files/files.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = "eagerx-gen.files";
// Files that are about to be moved into place, and `journal`, which lists their places. If the
// journal exists, the new output is complete; otherwise the old output stays.
constexpr const char* kStage = ".eagerx-gen.new";
constexpr const char* kJournal = ".eagerx-gen.new/journal";
constexpr const char* kJournalBegun = ".eagerx-gen.new/journal.begun";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) result.push_back(line);
  return result;
}

GeneratedFile list_of(const std::vector<GeneratedFile>& files) {
  std::string text = std::string(kList) + "\n";
  for (const auto& file : files) {
    if (!file.yours) text += file.path + "\n";
  }
  return {kList, text};
}

/// Never true: the file that would be written is one that was read.
bool refuse_input(const std::string& path, const std::string& input, Diagnostics& diagnostics) {
  const std::string also = path == input ? "" : fmt::format(", as `{}`", input);
  diagnostics.usage_error("E0906", fmt::format("`{}` is a file that is read{}", path, also)).help =
      "give another name for what is written";
  return false;
}

/// One file of the output: written from its place in the stage, or removed.
struct Change {
  std::string staged;  // empty: removed
  std::string path;
};

class Writer {
 public:
  Writer(std::string name, Folder folder, Diagnostics& diagnostics)
      : name_(std::move(name)), folder_(std::move(folder)), diagnostics_(diagnostics) {}

  std::optional<WriteResult> run(std::vector<GeneratedFile> files) {
    if (!folder_.lock()) return fail("", "another run of eagerx-gen writes there");
    if (!finish_earlier_run()) return std::nullopt;
    spare_yours(files);
    const std::vector<std::string> earlier = earlier_files();
    if (!spares_others(earlier, files)) return std::nullopt;
    files.push_back(list_of(files));
    std::vector<Change> changes;
    if (!stage(files, changes)) {
      clear_stage();
      return std::nullopt;
    }
    add_stale(earlier, files, changes);
    if (!changes.empty() && (!commit(changes) || !apply(changes))) return std::nullopt;
    return result_;
  }

 private:
  /// Paths of an earlier run; anything that points out of the folder is not ours.
  [[nodiscard]] std::vector<std::string> earlier_files() const {
    std::vector<std::string> result = lines_of(folder_.read(kList).value_or(""));
    std::erase_if(result, [](const std::string& path) { return !is_below(path); });
    return result;
  }

  /// Files that are the user's once they are there.
  void spare_yours(std::vector<GeneratedFile>& files) {
    result_.kept += std::erase_if(files, [&](const GeneratedFile& file) {
      if (!file.yours || !is_below(file.path)) return false;
      const Folder::Kind kind = folder_.kind(file.path);
      return kind == Folder::Kind::file || kind == Folder::Kind::other;
    });
  }

  /// A file that no earlier run wrote is somebody's: `-o .` in a project must not cost its
  /// CMakeLists.txt.
  bool spares_others(const std::vector<std::string>& earlier,
                     const std::vector<GeneratedFile>& files) {
    const std::set<std::string> ours(earlier.begin(), earlier.end());
    bool good = true;
    for (const auto& file : files) {
      if (ours.contains(file.path) || !is_below(file.path)) continue;
      const Folder::Kind kind = folder_.kind(file.path);
      const bool may_be = kind == Folder::Kind::file || kind == Folder::Kind::other;
      if (!may_be || !folder_.takes(file.path) || folder_.read(file.path) == file.text) continue;
      diagnostics_
          .io_error("E0903", {},
                    fmt::format("`{}` was not written by eagerx-gen", place(file.path)))
          .help = "choose another folder with `--output`, or move the file away";
      good = false;
    }
    return good;
  }

  /// Writes what changes under temporary names in the same folder.
  bool stage(const std::vector<GeneratedFile>& files, std::vector<Change>& changes) {
    std::set<std::string> paths;
    for (const auto& file : files) {
      if (!is_below(file.path)) return refuse(file.path, "its name leaves the output folder");
      if (!paths.insert(file.path).second) return refuse(file.path, "two files have this name");
      if (folder_.read(file.path) == file.text) {
        ++result_.unchanged;
        continue;
      }
      if (const auto input = input_at(place(file.path)))
        return refuse_input(place(file.path), *input, diagnostics_);
      if (!folder_.takes(file.path)) return refuse(file.path, reason(file.path));
      if (folder_.kind(file.path) == Folder::Kind::folder)
        return refuse(file.path, "it is a folder");
      changes.push_back({fmt::format("{}/{}", kStage, changes.size()), file.path});
      if (!folder_.write_new(changes.back().staged, file.text))
        return refuse(file.path, reason(kJournal));
    }
    return true;
  }

  void add_stale(const std::vector<std::string>& earlier, const std::vector<GeneratedFile>& files,
                 std::vector<Change>& changes) const {
    std::set<std::string> made;
    for (const auto& file : files) made.insert(file.path);
    for (const auto& path : earlier) {
      const Folder::Kind kind = folder_.kind(path);
      if (!made.contains(path) && (kind == Folder::Kind::file || kind == Folder::Kind::other))
        changes.push_back({"", path});
    }
  }

  /// From here on the new output is the valid one: the next run completes it.
  bool commit(const std::vector<Change>& changes) {
    std::string text;
    for (const auto& change : changes) text += change.staged + ":" + change.path + "\n";
    if (folder_.write_new(kJournalBegun, text) && folder_.rename(kJournalBegun, kJournal))
      return true;
    static_cast<void>(refuse(kJournal, reason(kJournal)));
    clear_stage();
    return false;
  }

  bool apply(const std::vector<Change>& changes) {
    for (const auto& [staged, path] : changes) {
      if (staged.empty()) {
        result_.removed += folder_.remove(path) ? 1U : 0U;  // or it went before
        continue;
      }
      // A file that is no longer in the stage has already been moved.
      if (folder_.kind(staged) == Folder::Kind::nothing) continue;
      if (!folder_.rename(staged, path)) return refuse(path, reason(path));
      ++result_.written;
    }
    static_cast<void>(folder_.remove(kJournal));  // or the next run does
    clear_stage();
    return true;
  }

  /// Completes or undoes what an earlier run left behind when it was killed.
  bool finish_earlier_run() {
    if (folder_.kind(kStage) != Folder::Kind::folder) return true;
    const auto journal = folder_.read(kJournal);
    if (!journal) {
      clear_stage();
      return true;
    }
    std::vector<Change> changes;
    for (const auto& line : lines_of(*journal)) {
      const std::size_t colon = std::min(line.find(':'), line.size());
      Change change{line.substr(0, colon), line.substr(std::min(colon + 1, line.size()))};
      const bool ours =
          change.staged.empty() || (change.staged.starts_with(kStage) && is_below(change.staged));
      if (!ours || !is_below(change.path)) return refuse(kJournal, "it is damaged: remove it");
      changes.push_back(std::move(change));
    }
    const bool complete = apply(changes);
    result_ = {};
    return complete;
  }

  void clear_stage() const {
    for (const auto& name : folder_.names(kStage))
      static_cast<void>(folder_.remove(fmt::format("{}/{}", kStage, name)));
    folder_.remove_empty(kStage);
  }

  /// Of what went wrong last; of links their own.
  [[nodiscard]] std::string reason(const std::string& path) const {
    const int error = errno;
    for (std::size_t slash = path.find('/'); slash != std::string::npos;
         slash = path.find('/', slash + 1)) {
      const std::string folder = path.substr(0, slash);
      if (folder_.kind(folder) == Folder::Kind::other)
        return fmt::format("`{}` is a link, and could lead out of the output folder",
                           place(folder));
    }
    return std::strerror(error);
  }

  [[nodiscard]] std::string place(const std::string& path) const {
    return (fs::path(name_) / path).string();
  }

  std::optional<WriteResult> fail(const std::string& path, const std::string& why) {
    diagnostics_.io_error(
        "E0901", {}, fmt::format("cannot write `{}`: {}", path.empty() ? name_ : place(path), why));
    return std::nullopt;
  }
  bool refuse(const std::string& path, const std::string& why) {
    return fail(path, why).has_value();
  }

  std::string name_;
  Folder folder_;
  Diagnostics& diagnostics_;
  WriteResult result_;
};

/// `what` is to be written there.
std::optional<Folder> open_folder(const std::string& name, const std::string& what,
                                  Diagnostics& diagnostics) {
  auto folder = Folder::open(name);
  if (!folder)
    diagnostics.io_error("E0901", {},
                         fmt::format("cannot write `{}`: {}", what, std::strerror(errno)));
  return folder;
}

}  // namespace

bool are_different(const std::string& folder, const std::vector<GeneratedFile>& files,
                   Diagnostics& diagnostics) {
  std::vector<std::string> paths;
  paths.reserve(files.size());
  for (const auto& file : files) paths.push_back((fs::path(folder) / file.path).string());
  const auto found = find_one_file(paths);
  if (!found) return true;
  diagnostics
      .usage_error("E0906", fmt::format("`{}` and `{}` are one file", found->output, found->other))
      .help = "give each its own";
  return false;
}

std::optional<WriteResult> write_files(const std::string& folder, std::vector<GeneratedFile> files,
                                       Diagnostics& diagnostics) {
  std::ranges::sort(files, {}, &GeneratedFile::path);
  if (!are_different(folder, files, diagnostics)) return std::nullopt;
  auto open = open_folder(folder, folder, diagnostics);
  if (!open) return std::nullopt;
  return Writer(folder, std::move(*open), diagnostics).run(std::move(files));
}

namespace {

/// Of a file; what is none, such as a device, has none.
bool has_text(const std::string& path, const std::string& text) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) != text.size()) return false;
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {}) == text;
}

}  // namespace

bool spares_inputs(const std::string& path, Diagnostics& diagnostics) {
  const auto input = input_at(path);
  return !input || refuse_input(path, *input, diagnostics);
}

bool write_file(const std::string& path, const std::string& text, Diagnostics& diagnostics) {
  if (!are_different({}, {}, diagnostics) || !spares_inputs(path, diagnostics)) return false;
  const std::string parent = fs::path(path).parent_path().string();
  std::error_code error;
  if (!parent.empty()) fs::create_directories(parent, error);
  const auto fail = [&](const std::string& why) {
    diagnostics.io_error("E0901", {}, fmt::format("cannot write `{}`: {}", path, why));
    return false;
  };
  if (!is_below(fs::path(path).filename().string())) return fail("it is not a name of a file");
  if (error) return fail(error.message());
  if (has_text(path, text)) {
    host::remove_left_drafts(path);
    return true;
  }
  const int refused = host::write_whole(path, text);
  if (refused == EISDIR) return fail("it is a folder");
  return refused == 0 || fail(host::problem_of_writing(refused));
}

}  // namespace eagerx::gen
