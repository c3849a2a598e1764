#include "generator/tools/serve/graph_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <utility>

namespace eagerx::gen::serve {
namespace {

namespace fs = std::filesystem;

/// A descriptor that is closed.
class Opened {
 public:
  explicit Opened(int number) : number_(number) {}
  ~Opened() {
    if (number_ >= 0) close(number_);
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  [[nodiscard]] int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_;
};

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

FileText read_file(const std::string& path, std::size_t most_bytes = GraphFile::kMostBytes) {
  const Opened file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file && errno == ENOENT) return {};
  FileText read{"", true};
  struct stat facts {};
  if (!file || fstat(file.number(), &facts) != 0) {
    read.problem = std::strerror(errno);
  } else if (!S_ISREG(facts.st_mode)) {
    read.problem = S_ISDIR(facts.st_mode) ? "it is a folder" : "it is no file";
  }
  std::array<char, 1U << 16U> bytes{};
  while (read.problem.empty()) {
    const ssize_t count = ::read(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) read.problem = std::strerror(errno);
    if (count <= 0) break;
    read.text.append(bytes.data(), static_cast<std::size_t>(count));
    if (read.text.size() > most_bytes) read.problem = "it is too large";
  }
  if (!read.problem.empty()) read.text.clear();
  return read;
}

std::string name_beside(const std::string& path) {
  const fs::path where(path);
  return (where.parent_path() / ("." + where.filename().string() + ".eagerx-gen.new")).string();
}

/// A new file with this text; false: errno says why not.
bool make_file(const std::string& path, const std::string& text, mode_t mode, bool keeps_mode) {
  const Opened file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
  if (!file || !write_all(file.number(), text)) return false;
  return !keeps_mode || fchmod(file.number(), mode) == 0;
}

constexpr mode_t kNewFile = 0666;  // less the user's mask

}  // namespace

GraphFile::GraphFile(std::string path) : path_(std::move(path)) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path_, error);
  if (!error) path_ = real.string();
}

GraphFile::Stamp GraphFile::stamp() const {
  struct stat facts {};
  if (stat(path_.c_str(), &facts) != 0) return {};
  constexpr long long kNs = 1'000'000'000;
  return {static_cast<long long>(facts.st_dev), static_cast<long long>(facts.st_ino),
          static_cast<long long>(facts.st_size), facts.st_mtim.tv_sec * kNs + facts.st_mtim.tv_nsec,
          facts.st_ctim.tv_sec * kNs + facts.st_ctim.tv_nsec};
}

FileText GraphFile::read(std::size_t most_bytes) const {
  seen_ = stamp();  // before: what changes while it is read is seen the next time
  return read_file(path_, most_bytes);
}

bool GraphFile::may_have_changed() const {
  return stamp() != seen_;
}

bool GraphFile::write_beside(const std::string& beside, const std::string& text) {
  unlink(beside.c_str());  // of a run that was killed
  struct stat facts {};
  const bool exists = stat(path_.c_str(), &facts) == 0;
  return make_file(beside, text, exists ? facts.st_mode & 07777U : kNewFile, exists);
}

GraphFile::Written GraphFile::fail(const std::string& beside) {
  problem_ = std::strerror(errno);
  unlink(beside.c_str());
  return Written::failed;
}

GraphFile::Written GraphFile::write(const std::optional<std::string>& expected,
                                    const std::string& text) {
  const auto is_expected = [&](const FileText& found) {
    return found.problem.empty() && found.exists == expected.has_value() &&
           found.text == expected.value_or("");
  };
  if (!is_expected(read_file(path_))) return Written::changed;
  const std::string beside = name_beside(path_);
  if (!write_beside(beside, text)) return fail(beside);
  const auto swap = [&](unsigned flags) {
    return renameat2(AT_FDCWD, beside.c_str(), AT_FDCWD, path_.c_str(), flags) == 0;
  };
  if (swap(expected ? RENAME_EXCHANGE : RENAME_NOREPLACE)) {
    if (expected && !is_expected(read_file(beside))) {
      // Somebody was faster: theirs goes back, and ours away, unless it is not ours by now.
      if (!swap(RENAME_EXCHANGE)) return fail("");
      if (read_file(beside).text == text) unlink(beside.c_str());
      return Written::changed;
    }
    if (expected) unlink(beside.c_str());
    seen_ = stamp();
    return Written::done;
  }
  if (errno == EEXIST || errno == ENOENT) {
    unlink(beside.c_str());
    return Written::changed;
  }
  // A file system that cannot exchange: looked at once more.
  if (!is_expected(read_file(path_))) {
    unlink(beside.c_str());
    return Written::changed;
  }
  if (::rename(beside.c_str(), path_.c_str()) != 0) return fail(beside);
  seen_ = stamp();
  return Written::done;
}

std::string write_whole(const std::string& path, const std::string& text) {
  const std::string beside = name_beside(path);
  unlink(beside.c_str());
  if (make_file(beside, text, kNewFile, false) && ::rename(beside.c_str(), path.c_str()) == 0)
    return {};
  std::string why = std::strerror(errno);
  unlink(beside.c_str());
  return why;
}

}  // namespace eagerx::gen::serve
