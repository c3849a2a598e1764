#include "targets/environments/client/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "targets/environments/client/problem.hpp"

namespace eagerx::client {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* what, const std::string& path, const std::string& why) {
  throw Problem(kInputOutput, std::string("cannot ") + what + " `" + path + "`: " + why);
}

std::string draft_of(const std::string& path) {
  return path + ".part";
}

/// Writes all of it down to the disk; false leaves errno.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(file) == 0;
}

int open_draft(const std::string& draft) {
  constexpr mode_t kEverybodyReads = 0644;
  return open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kEverybodyReads);
}

/// The file that takes the place of another, beside it.
class Draft {
 public:
  /// Throws Problem if it cannot be written.
  Draft(const std::string& path, std::string_view bytes) : path_(path) {
    const int file = open_draft(draft_of(path));
    if (file < 0) fail("write", path, std::strerror(errno));
    const bool is_written = write_all(file, bytes);
    const int why = errno;
    const bool is_closed = close(file) == 0;
    if (is_written && is_closed) return;
    const std::string reason = std::strerror(is_written ? errno : why);
    std::remove(draft_of(path).c_str());
    fail("write", path, reason);
  }
  /// Removes what was not put.
  ~Draft() { std::remove(draft_of(path_).c_str()); }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// Throws Problem if that is not possible.
  void put() const {
    if (std::rename(draft_of(path_).c_str(), path_.c_str()) == 0) return;
    fail("write", path_, std::strerror(errno));
  }

 private:
  std::string path_;
};

}  // namespace

void write_file(const std::string& path, std::string_view bytes) {
  const Draft draft(path, bytes);
  draft.put();
}

void write_files(const std::vector<NewFile>& files) {
  std::vector<std::unique_ptr<Draft>> drafts;
  for (const NewFile& file : files)
    drafts.push_back(std::make_unique<Draft>(file.path, file.bytes));
  for (const auto& draft : drafts) draft->put();
}

void print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return;
  throw Problem(kInputOutput,
                std::string("cannot write to the standard output: ") + std::strerror(errno));
}

void check_writable(const std::string& path) {
  std::error_code error;
  if (path.empty()) fail("write", path, "it has no name");
  if (fs::is_directory(path, error)) fail("write", path, "it is a folder");
  const std::string draft = draft_of(path);
  const int file = open_draft(draft);
  if (file < 0) fail("write", path, std::strerror(errno));
  close(file);
  std::remove(draft.c_str());
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail("read", path, std::strerror(errno));
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file || file.bad()) fail("read", path, "it cannot be read to its end");
  return std::move(bytes).str();
}

}  // namespace eagerx::client
