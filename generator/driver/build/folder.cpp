#include "generator/driver/build/folder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

namespace eagerx::gen {
namespace {

std::string last_name(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

/// A folder inside of another, without following a link.
Descriptor step_into(int folder, const std::string& name) {
  return Descriptor(openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

Descriptor::~Descriptor() {
  const int before = errno;
  if (number_ >= 0) close(number_);
  errno = before;
}

bool is_below(std::string_view path) {
  if (path.find_first_of(std::string_view("\n\0", 2)) != std::string_view::npos) return false;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string_view name = path.substr(begin, end - begin);
    if (name.empty() || name == "." || name == "..") return false;
    begin = end + 1;
  }
  return true;
}

std::optional<Folder> Folder::open(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  Descriptor self(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (error && !self) errno = error.value();
  return self ? std::optional(Folder(std::move(self))) : std::nullopt;
}

bool Folder::is_kept() const {
  struct stat mine {};
  if (fstat(self_.number(), &mine) != 0) return false;
  return std::ranges::any_of(KeptFolders::all(), [&](const Folder& kept) {
    struct stat its {};
    return fstat(kept.self_.number(), &its) == 0 && mine.st_dev == its.st_dev &&
           mine.st_ino == its.st_ino;
  });
}

std::vector<Folder>& KeptFolders::all() {
  static std::vector<Folder> folders;
  return folders;
}

bool KeptFolders::keep(const std::string& path, const std::function<void()>& waiting) {
  using namespace std::chrono_literals;
  constexpr auto kTells = 1s;
  constexpr auto kPatience = 10min;
  auto folder = Folder::open(path);
  if (!folder) return false;
  if (folder->is_kept()) return true;
  bool is_reported = false;
  for (const auto begin = std::chrono::steady_clock::now();;) {
    const bool is_ours = flock(folder->self_.number(), LOCK_EX | LOCK_NB) == 0;
    // Some file systems have no locks; then runs at the same time are the user's to avoid.
    if (is_ours || (errno != EWOULDBLOCK && errno != EINTR)) break;
    const auto waited = std::chrono::steady_clock::now() - begin;
    if (waited > kPatience) return errno = EWOULDBLOCK, false;
    if (waited > kTells && !std::exchange(is_reported, true)) waiting();
    std::this_thread::sleep_for(10ms);
  }
  all().push_back(std::move(*folder));
  return true;
}

std::string KeptFolders::hand_on() {
  std::string numbers;
  for (const Folder& folder : all()) {
    const int number = folder.self_.number();
    if (fcntl(number, F_SETFD, 0) == 0)
      numbers += (numbers.empty() ? "" : ",") + std::to_string(number);
  }
  return numbers;
}

bool Folder::lock() const {
  using namespace std::chrono_literals;
  if (is_kept()) return true;
  for (const auto end = std::chrono::steady_clock::now() + 10s;;) {
    if (flock(self_.number(), LOCK_EX | LOCK_NB) == 0) return true;
    // Some file systems have no locks; then runs at the same time are the user's to avoid.
    if (errno != EWOULDBLOCK && errno != EINTR) return true;
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(10ms);
  }
}

Descriptor Folder::parent(const std::string& path, bool make) const {
  if (!is_below(path)) {
    errno = EINVAL;
    return Descriptor();
  }
  Descriptor folder(fcntl(self_.number(), F_DUPFD_CLOEXEC, 0));
  std::size_t begin = 0;
  for (std::size_t end = path.find('/'); folder && end != std::string::npos;
       end = path.find('/', begin)) {
    const std::string name = path.substr(begin, end - begin);
    constexpr mode_t kAll = 0777;  // less the user's mask
    if (make && mkdirat(folder.number(), name.c_str(), kAll) != 0 && errno != EEXIST)
      return Descriptor();
    folder = step_into(folder.number(), name);
    begin = end + 1;
  }
  return folder;
}

Folder::Kind Folder::kind(const std::string& path) const {
  const Descriptor folder = parent(path, false);
  struct stat found = {};
  if (!folder ||
      fstatat(folder.number(), last_name(path).c_str(), &found, AT_SYMLINK_NOFOLLOW) != 0)
    return errno == ENOENT ? Kind::nothing : Kind::other;
  if (S_ISREG(found.st_mode)) return Kind::file;
  return S_ISDIR(found.st_mode) ? Kind::folder : Kind::other;
}

std::optional<std::string> Folder::read(const std::string& path) const {
  const Descriptor folder = parent(path, false);
  // A pipe must not be waited for.
  const Descriptor file(folder ? openat(folder.number(), last_name(path).c_str(),
                                        O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)
                               : -1);
  struct stat found = {};
  if (!file || fstat(file.number(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
  std::string text(static_cast<std::size_t>(found.st_size), '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const ssize_t count = ::read(file.number(), text.data() + size, text.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::nullopt;
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  text.resize(size);
  return text;
}

bool Folder::write_new(const std::string& path, std::string_view text) const {
  const Descriptor folder = parent(path, true);
  if (!folder) return false;
  constexpr mode_t kFile = 0666;  // less the user's mask
  const Descriptor file(openat(folder.number(), last_name(path).c_str(),
                               O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kFile));
  return file && write_all(file.number(), text);
}

bool Folder::rename(const std::string& from, const std::string& to) const {
  const Descriptor source = parent(from, false);
  if (!source) return false;
  const Descriptor target = parent(to, true);
  return target && renameat(source.number(), last_name(from).c_str(), target.number(),
                            last_name(to).c_str()) == 0;
}

bool Folder::remove(const std::string& path) const {
  const Descriptor folder = parent(path, false);
  if (!folder || unlinkat(folder.number(), last_name(path).c_str(), 0) != 0) return false;
  const std::size_t slash = path.rfind('/');
  if (slash != std::string::npos) remove_empty(path.substr(0, slash));
  return true;
}

void Folder::remove_empty(std::string path) const {
  for (;;) {
    const Descriptor folder = parent(path, false);
    if (!folder || unlinkat(folder.number(), last_name(path).c_str(), AT_REMOVEDIR) != 0) return;
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return;
    path.resize(slash);
  }
}

std::vector<std::string> Folder::names(const std::string& path) const {
  std::vector<std::string> result;
  const Descriptor folder = parent(path + "/.list", false);  // the folder itself
  const int copy = folder ? fcntl(folder.number(), F_DUPFD_CLOEXEC, 0) : -1;
  if (copy < 0) return result;
  const std::unique_ptr<DIR, int (*)(DIR*)> list(fdopendir(copy), closedir);
  while (const dirent* entry = list ? readdir(list.get()) : nullptr) {
    const std::string name = static_cast<const char*>(entry->d_name);
    if (name != "." && name != "..") result.push_back(name);
  }
  std::ranges::sort(result);
  return result;
}

bool Folder::takes(const std::string& path) const {
  for (std::size_t slash = path.find('/'); slash != std::string::npos;
       slash = path.find('/', slash + 1)) {
    const std::string folder = path.substr(0, slash);
    const Kind found = kind(folder);
    if (found == Kind::nothing) return true;
    if (found != Kind::folder) {
      errno = found == Kind::other ? ELOOP : ENOTDIR;
      return false;
    }
  }
  const Descriptor folder = parent(path, false);
  return folder && faccessat(folder.number(), ".", W_OK | X_OK, AT_EACCESS) == 0;
}

}  // namespace eagerx::gen
