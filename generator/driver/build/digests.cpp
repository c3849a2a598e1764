#include "generator/driver/build/digests.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <runtime/host/base/hash.hpp>
#include <sstream>
#include <utility>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

std::int64_t ns_of(const timespec& time) {
  constexpr std::int64_t kNs = 1'000'000'000;
  return time.tv_sec * kNs + time.tv_nsec;
}

/// Of the rule in a depfile: `main.o: main.cpp a\ node.hpp \` and more lines.
std::vector<std::string> prerequisites(const std::string& text) {
  std::vector<std::string> paths;
  std::string path;
  const auto end_path = [&] {
    if (!path.empty()) paths.push_back(std::exchange(path, {}));
  };
  for (std::size_t i = std::min(text.find(": "), text.size()) + 1; i < text.size(); ++i) {
    const char next = i + 1 < text.size() ? text[i + 1] : '\n';
    if (text[i] == '\\' && next == '\n') {
      ++i;
      end_path();
    } else if ((text[i] == '\\' && (next == ' ' || next == '#')) ||
               (text[i] == '$' && next == '$')) {
      path += text[++i];
    } else if (text[i] == ' ') {
      end_path();
    } else if (text[i] == '\n') {
      break;  // rules without prerequisites follow
    } else {
      path += text[i];
    }
  }
  end_path();
  return paths;
}

}  // namespace

/// Lines `INODE SIZE CHANGED_NS DIGEST PATH`; what is damaged is as good as not there.
Digests::Digests(std::string build) : build_(std::move(build)) {
  std::ifstream kept(fs::path(build_) / kDigests);
  File file;
  std::string path;
  while (kept >> file.inode >> file.size >> file.changed_ns >> file.digest && kept.ignore() &&
         std::getline(kept, path))
    files_[path] = file;
}

std::string Digests::place_of(const std::string& path) const {
  return (fs::path(build_) / path).string();  // an absolute path stays as it is
}

/// Reads the file only if it may be another one than `file`: ctime cannot be set. False: there is
/// none, which build tools notice.
bool Digests::look(const std::string& path, File& file, timespec& modified) const {
  struct stat status {};
  const std::string place = place_of(path);
  if (stat(place.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  modified = status.st_mtim;
  File found{static_cast<std::int64_t>(status.st_ino), status.st_size, ns_of(status.st_ctim),
             file.digest};
  if (found.inode != file.inode || found.size != file.size || found.changed_ns != file.changed_ns) {
    std::ifstream in(place, std::ios::binary);
    found.digest = host::fnv1a(std::string(std::istreambuf_iterator<char>(in), {}));
  }
  file = found;
  return true;
}

bool Digests::have_unseen_change(const timespec& last_build) const {
  for (const auto& [path, before] : files_) {
    File file = before;
    timespec modified{};
    if (look(path, file, modified) && file.digest != before.digest &&
        ns_of(modified) <= ns_of(last_build))
      return true;
  }
  return false;
}

std::string listed_in_depfiles(const std::string& build) {
  std::string listed;
  std::error_code error;
  for (fs::recursive_directory_iterator item(build, error), end; !error && item != end;
       item.increment(error)) {
    if (item->path().extension() != ".d") continue;
    std::ifstream in(item->path(), std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    listed += item->path().string() + ":\n";
    for (const std::string& path : prerequisites(text)) listed += "    " + path + "\n";
  }
  return listed;
}

std::string Digests::now(const std::string& listed) const {
  std::map<std::string, File> files;
  std::istringstream lines(listed);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == 0 || begin == std::string::npos) continue;  // the name of what was made
    std::string path = line.substr(begin);
    const auto known = files_.find(path);
    File file = known != files_.end() ? known->second : File();
    timespec modified{};
    if (!files.contains(path) && look(path, file, modified)) files[std::move(path)] = file;
  }
  std::string text;
  for (const auto& [path, file] : files)
    text +=
        fmt::format("{} {} {} {} {}\n", file.inode, file.size, file.changed_ns, file.digest, path);
  return text;
}

}  // namespace eagerx::gen
