#include "generator/tools/serve/graph_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <runtime/host/base/files.hpp>
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

FileText read_file(const std::string& path, std::size_t most_bytes = GraphFile::kMostBytes) {
  const Opened file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file && errno == ENOENT) return {};
  FileText read{"", true};
  struct stat facts {};
  if (!file || fstat(file.number(), &facts) != 0) {
    read.problem = std::strerror(errno);
  } else if (!S_ISREG(facts.st_mode)) {
    read.problem = S_ISDIR(facts.st_mode) ? "it is a folder" : "it is not a file";
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

GraphFile::Written GraphFile::write(const std::optional<std::string>& expected,
                                    const std::string& text) {
  host::AtomicFile draft(path_);
  int error = draft.write(text);
  if (error == 0) error = draft.put_over(expected);
  if (error == ECANCELED) return Written::changed;
  if (error != 0) {
    problem_ = host::problem_of_writing(error);
    return Written::failed;
  }
  seen_ = stamp();
  // Or somebody has written between the two, and that is to be seen.
  if (read_file(path_).text != text) seen_ = {};
  return Written::done;
}

}  // namespace eagerx::gen::serve
