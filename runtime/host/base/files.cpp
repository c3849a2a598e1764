#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <runtime/host/base/files.hpp>
#include <utility>

namespace eagerx::host {
namespace {

int write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return fsync(file) == 0 ? 0 : errno;
}

}  // namespace

Draft::Draft(std::string path) : path_(std::move(path)), draft_(path_ + ".part") {}

Draft::~Draft() {
  if (is_there_) std::remove(draft_.c_str());
}

int Draft::write(std::string_view bytes) {
  constexpr mode_t kEverybodyReads = 0644;
  const int file = open(draft_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kEverybodyReads);
  if (file < 0) return errno;
  is_there_ = true;
  const int error = write_all(file, bytes);
  return close(file) == 0 || error != 0 ? error : errno;
}

int Draft::put() {
  if (std::rename(draft_.c_str(), path_.c_str()) != 0) return errno;
  is_there_ = false;
  return 0;
}

int write_whole(const std::string& path, std::string_view bytes) {
  Draft draft(path);
  const int error = draft.write(bytes);
  return error != 0 ? error : draft.put();
}

bool is_dev_null(const struct stat& status) {
  struct stat null {};
  return S_ISCHR(status.st_mode) && stat("/dev/null", &null) == 0 && status.st_rdev == null.st_rdev;
}

int print(std::FILE* out, std::string_view text) {
  errno = 0;
  const bool done =
      std::fwrite(text.data(), 1, text.size(), out) == text.size() && std::fflush(out) == 0;
  return done ? 0 : errno;
}

}  // namespace eagerx::host
