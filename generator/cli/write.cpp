#include "generator/cli/write.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = "eagerx-gen.files";

std::optional<std::string> read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Paths of an earlier run; anything that points out of the folder is not ours.
std::vector<std::string> earlier_files(const fs::path& folder) {
  std::vector<std::string> result;
  std::istringstream lines(read(folder / kList).value_or(""));
  for (std::string line; std::getline(lines, line);) {
    const fs::path path = fs::path(line).lexically_normal();
    if (!line.empty() && path.is_relative() && *path.begin() != "..") result.push_back(line);
  }
  return result;
}

GeneratedFile list_of(std::set<std::string> names) {
  names.erase(kList);
  std::string text = std::string(kList) + "\n";
  for (const auto& name : names) text += name + "\n";
  return {kList, text};
}

class Writer {
 public:
  Writer(const fs::path& folder, Diagnostics& diagnostics)
      : folder_(folder), diagnostics_(diagnostics) {}
  ~Writer() {
    std::error_code ignored;
    for (const auto& [temporary, path] : pending_) fs::remove(temporary, ignored);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  std::optional<WriteResult> run(const std::vector<GeneratedFile>& files) {
    const std::vector<std::string> earlier = earlier_files(folder_);
    if (!spares_others(earlier, files)) return std::nullopt;
    std::set<std::string> made;
    for (const auto& file : files) made.insert(file.path);
    std::set<std::string> both = made;
    both.insert(earlier.begin(), earlier.end());
    const bool same = read(folder_ / kList) == list_of(made).text;
    // At every moment the list names all that is ours: a run after one that was interrupted finds
    // no file of somebody else's.
    std::vector<GeneratedFile> all = {list_of(both)};
    all.insert(all.end(), files.begin(), files.end());
    if (!write(all)) return std::nullopt;
    remove_stale(earlier, made);
    if (!write({list_of(made)})) return std::nullopt;
    ++(same ? result_.unchanged : result_.written);
    return result_;
  }

  bool write(const std::vector<GeneratedFile>& files) {
    for (const auto& file : files) {
      if (!prepare(file)) return false;
    }
    for (const auto& [temporary, path] : pending_) {
      std::error_code error;
      fs::rename(temporary, path, error);
      if (error) return fail(path, error.message()).has_value();
      result_.written += path.filename() == kList ? 0U : 1U;
    }
    pending_.clear();
    return true;
  }

 private:
  /// A file that no earlier run wrote is somebody's: `-o .` in a project must not cost its
  /// CMakeLists.txt.
  bool spares_others(const std::vector<std::string>& earlier,
                     const std::vector<GeneratedFile>& files) {
    const std::set<std::string> ours(earlier.begin(), earlier.end());
    bool good = true;
    for (const auto& file : files) {
      std::error_code ignored;
      if (ours.contains(file.path) || !fs::is_regular_file(folder_ / file.path, ignored)) continue;
      const auto text = read(folder_ / file.path);
      if (text == file.text) continue;
      diagnostics_
          .io_error(
              "E0903", {},
              fmt::format("`{}` was not written by eagerx-gen", (folder_ / file.path).string()))
          .help = "choose another folder with `--output`, or move the file away";
      good = false;
    }
    return good;
  }

  bool prepare(const GeneratedFile& file) {
    const fs::path path = folder_ / file.path;
    if (read(path) == file.text) {
      result_.unchanged += file.path == kList ? 0U : 1U;
      return true;
    }
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) return fail(path.parent_path(), error.message()).has_value();
    if (fs::is_directory(path, error)) return fail(path, "it is a folder").has_value();
    const fs::path temporary =
        path.parent_path() / fmt::format(".{}.{}", path.filename().string(), getpid());
    pending_.emplace_back(temporary, path);
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out << file.text;
    out.close();
    return out ? true : fail(path, std::strerror(errno)).has_value();
  }

  void remove_stale(const std::vector<std::string>& earlier, const std::set<std::string>& made) {
    for (const auto& path : earlier) {
      std::error_code ignored;
      if (path != kList && !made.contains(path) && fs::remove(folder_ / path, ignored))
        ++result_.removed;
    }
  }

  std::optional<WriteResult> fail(const fs::path& path, const std::string& why) {
    diagnostics_.io_error("E0901", {}, fmt::format("cannot write `{}`: {}", path.string(), why));
    return std::nullopt;
  }

  fs::path folder_;
  Diagnostics& diagnostics_;
  std::vector<std::pair<fs::path, fs::path>> pending_;
  WriteResult result_;
};

}  // namespace

std::optional<WriteResult> write_files(const std::string& folder, std::vector<GeneratedFile> files,
                                       Diagnostics& diagnostics) {
  std::ranges::sort(files, {}, &GeneratedFile::path);
  return Writer(folder, diagnostics).run(files);
}

bool write_file(const std::string& path, const std::string& text, Diagnostics& diagnostics) {
  const fs::path folder = fs::path(path).parent_path();
  return Writer(folder.empty() ? "." : folder, diagnostics)
      .write({{fs::path(path).filename().string(), text}});
}

}  // namespace eagerx::gen
