#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/hash.hpp>
#include <runtime/host/base/text_file.hpp>
#include <thread>
#include <utility>

namespace eagerx::host {
namespace {

namespace fs = std::filesystem;

int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

bool is_same(const std::string& path, const struct stat& status) {
  struct stat found {};
  return lstat(path.c_str(), &found) == 0 && found.st_dev == status.st_dev &&
         found.st_ino == status.st_ino;
}

/// `a/q.csv` → `.q.csv.`: how the temporary names of a file begin.
std::string beginning_of_drafts(const fs::path& path) {
  constexpr std::size_t kMostOfName = 200;  // of the 255 bytes that a name has
  const std::string name = path.filename().string();
  return "." + (name.size() > kMostOfName ? std::string() : name) + ".";
}

/// `a/q.csv` → `a/.q.csv.4711.0123456789abcdef.part`, of process 4711, where no program expects it.
std::string name_next_to(const std::string& path, std::string_view ending) {
  std::uint64_t random = 0;
  if (getrandom(&random, sizeof random, 0) != sizeof random)
    random =
        static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
  const fs::path whole(path);
  return (whole.parent_path() / (beginning_of_drafts(whole) + std::to_string(getpid()) + "." +
                                 hex_text(random) + ".part"))
      .string()
      .append(ending);
}

/// Nothing if there is no file, or none that can be read.
std::optional<std::string> text_of(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) return std::nullopt;
  struct stat status {};
  const bool is_file = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  std::string text;
  std::string bytes(std::size_t{1} << 16U, '\0');
  ssize_t count = is_file ? 1 : -1;
  while (count > 0) {
    count = ::read(file, bytes.data(), bytes.size());
    if (count > 0) text.append(bytes, 0, static_cast<std::size_t>(count));
    if (count < 0 && errno == EINTR) count = 1;
  }
  close(file);
  return count == 0 ? std::optional(text) : std::nullopt;
}

/// Owner and mode of a file that is to be replaced. False if it cannot have them.
bool keep_owner(int file, const struct stat& replaced) {
  constexpr mode_t kPermissions = 07777;
  return fchown(file, replaced.st_uid, replaced.st_gid) == 0 &&
         fchmod(file, replaced.st_mode & kPermissions) == 0;
}

}  // namespace

std::string behind_links(const std::string& of) {
  fs::path path(of);
  constexpr int kMostLinks = 40;  // as Linux follows them
  std::error_code none;
  for (int i = 0; i < kMostLinks; ++i) {
    const fs::path next = fs::read_symlink(path, none);
    if (none) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path.string();
}

bool takes_output(const struct stat& status) {
  constexpr mode_t kAnyWrites = S_IWUSR | S_IWGRP | S_IWOTH;
  if (S_ISREG(status.st_mode)) return (status.st_mode & kAnyWrites) != 0;
  return S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode);
}

std::string problem_of_writing(int error) {
  switch (error) {
    case EINVAL:
      return "it is not a file, FIFO or character device";
    case ENXIO:
      return "no program reads it";
    case ETIMEDOUT:
      return "its reader is gone, or too slow";
    case EWOULDBLOCK:
      return "another program writes it";
    default:
      return std::strerror(error);
  }
}

void remove_left_drafts(const std::string& path) {
  const fs::path whole(behind_links(path));
  const std::string beginning = beginning_of_drafts(whole);
  std::error_code error;
  const fs::path folder = whole.has_parent_path() ? whole.parent_path() : fs::path(".");
  for (fs::directory_iterator item(folder, error), end; !error && item != end;
       item.increment(error)) {
    const std::string name = item->path().filename().string();
    if (!name.starts_with(beginning) || name.find(".part") == std::string::npos) continue;
    pid_t process = 0;
    const char* const first = name.data() + beginning.size();
    const auto [stop, wrong] = std::from_chars(first, name.data() + name.size(), process);
    const bool is_ours = wrong == std::errc() && stop != first && *stop == '.' && process > 0;
    if (is_ours && kill(process, 0) != 0 && errno == ESRCH) unlink(item->path().c_str());
  }
}

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)) {}

AtomicFile::~AtomicFile() {
  if (!draft_.empty()) unlink(draft_.c_str());
}

int AtomicFile::make_next_to(const struct stat* replaced, std::string_view ending, int& file) {
  constexpr int kTries = 8;
  constexpr mode_t kForAll = 0666, kForOwner = 0600;
  remove_left_drafts(place_);
  for (int i = 0; i < kTries && file < 0; ++i) {
    draft_ = name_next_to(place_, ending);
    file = open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                replaced == nullptr ? kForAll : kForOwner);
    if (file < 0 && errno != EEXIST) break;
  }
  const int error = file < 0 ? errno : 0;
  if (error != 0) draft_.clear();
  if (replaced == nullptr) return error;
  if (error == 0 && keep_owner(file, *replaced)) return 0;
  if (error != 0 && error != EACCES && error != EPERM && error != EROFS) return error;
  if (error == 0) close(std::exchange(file, -1));
  if (error == 0) unlink(std::exchange(draft_, std::string()).c_str());
  return 0;  // it is written into
}

/// `file`: what was made, or none if something is written into. Returns what refuses both.
int AtomicFile::begin(std::string_view ending, int& file) {
  struct stat found {};
  if (stat(path_.c_str(), &found) != 0) {
    if (errno != ENOENT) return errno;
    place_ = behind_links(path_);
    return make_next_to(nullptr, ending, file);
  }
  if (S_ISDIR(found.st_mode)) return EISDIR;
  if (!takes_output(found)) return S_ISREG(found.st_mode) ? EACCES : EINVAL;
  if (faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) return errno;
  place_ = behind_links(path_);
  // The name of an open descriptor below /proc may lead nowhere.
  if (!S_ISREG(found.st_mode) || !is_same(place_, found)) return 0;
  return make_next_to(&found, ending, file);
}

int AtomicFile::make(std::string_view ending) {
  int file = -1;
  const int error = begin(ending, file);
  is_made_ = true;
  return file < 0 || close(file) == 0 ? error : errno;
}

int AtomicFile::write(std::string_view bytes, Durability durability) {
  int file = -1;
  if (const int refused = begin({}, file)) return refused;
  if (file < 0) {
    bytes_ = bytes;
    return 0;
  }
  int error = write_all(file, bytes);
  if (error == 0 && durability == Durability::synced && fsync(file) != 0) error = errno;
  return close(file) == 0 || error != 0 ? error : errno;
}

int AtomicFile::put() {
  if (draft_.empty()) return write_into();
  if (std::rename(draft_.c_str(), place_.c_str()) != 0) return errno;
  draft_.clear();
  return 0;
}

int AtomicFile::put_over(const std::optional<std::string>& expected) {
  // Programs of this project take turns; others meet the exchange.
  std::optional<FileLock> lock;
  if (expected && lock.emplace(path_, false).error() == EWOULDBLOCK) return EWOULDBLOCK;
  if (text_of(path_) != expected) return ECANCELED;
  return draft_.empty() ? write_into() : exchange(expected);
}

int AtomicFile::exchange(const std::optional<std::string>& expected) {
  const std::optional<std::string> mine = text_of(draft_);
  const auto swap = [&](unsigned flags) {
    return renameat2(AT_FDCWD, draft_.c_str(), AT_FDCWD, place_.c_str(), flags) == 0;
  };
  if (!swap(expected ? RENAME_EXCHANGE : RENAME_NOREPLACE)) {
    if (errno == EEXIST || errno == ENOENT) return ECANCELED;
    // A file system that cannot exchange: looked at once more.
    return text_of(path_) == expected ? put() : ECANCELED;
  }
  if (!expected) draft_.clear();
  if (!expected || text_of(draft_) == expected) return 0;  // what was there goes with the draft
  // A process has saved before the exchange: its text goes back. A text saved since then comes
  // back, too: it is the last.
  if (!swap(RENAME_EXCHANGE)) return errno;
  if (text_of(draft_) != mine && !swap(RENAME_EXCHANGE)) return errno;
  return ECANCELED;
}

int AtomicFile::write_into() {
  if (is_made_ || (bytes_.empty() && !is_replaced_by_output(path_))) return 0;
  TextFile file;
  if (file.open(path_ == "-" ? "./-" : path_)) file.text(bytes_);
  return file.close() ? 0 : file.error();
}

int write_whole(const std::string& path, std::string_view bytes, Durability durability) {
  AtomicFile draft(path);
  const int error = draft.write(bytes, durability);
  return error != 0 ? error : draft.put();
}

int problem_of_output(const std::string& path) {
  return AtomicFile(path).make({});
}

bool is_replaced_by_output(const std::string& path) {
  struct stat found {};
  return stat(path.c_str(), &found) != 0 || !(S_ISFIFO(found.st_mode) || S_ISCHR(found.st_mode));
}

FileLock::FileLock(const std::string& path, bool makes) : error_(take(path, makes)) {}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

/// The file that had the name may have been replaced while somebody else had its lock.
int FileLock::take(const std::string& path, bool makes) {
  using namespace std::chrono_literals;
  constexpr mode_t kForAll = 0666;
  constexpr int kTries = 1'000;
  for (int i = 0; i < kTries; ++i) {
    if (!is_replaced_by_output(path)) return 0;
    if (file_ < 0)
      file_ = open(path.c_str(),
                   O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY | (makes ? O_CREAT : 0), kForAll);
    if (file_ < 0) return errno;
    const bool is_mine = flock(file_, LOCK_EX | LOCK_NB) == 0;
    if (!is_mine && errno != EWOULDBLOCK) return 0;  // some file systems have no locks
    if (!is_mine) {
      std::this_thread::sleep_for(10ms);
      continue;
    }
    struct stat mine {
    }, its{};
    if (fstat(file_, &mine) != 0) return errno;
    if (stat(path.c_str(), &its) == 0 && mine.st_dev == its.st_dev && mine.st_ino == its.st_ino)
      return 0;
    close(std::exchange(file_, -1));
  }
  return EWOULDBLOCK;
}

bool is_dev_null(const struct stat& status) {
  struct stat null {};
  return S_ISCHR(status.st_mode) && stat("/dev/null", &null) == 0 && status.st_rdev == null.st_rdev;
}

void open_standard_files() {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest that is free is this one. Errors have nowhere to go; a summary has to arrive.
    const int mode = descriptor == STDOUT_FILENO ? O_RDONLY : O_RDWR;
    static_cast<void>(::open("/dev/null", mode));
  }
}

int print(std::FILE* out, std::string_view text) {
  errno = 0;
  const bool done =
      std::fwrite(text.data(), 1, text.size(), out) == text.size() && std::fflush(out) == 0;
  return done ? 0 : errno;
}

}  // namespace eagerx::host
