#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <runtime/host/key/key_file.hpp>
#include <string_view>

namespace eagerx::key {
namespace {

// eagerx-gen key 1 <64 digits>, and the end of the line.
constexpr std::string_view kTitle = "eagerx-gen key 1 ";
constexpr std::string_view kDigits = "0123456789abcdef";
constexpr std::size_t kTextBytes = kTitle.size() + 2 * kKeyBytes + 1;

constexpr const char* kMakeOne = "\nhelp: `eagerx-gen key new FILE` writes one";

std::string text_of(const Key& key) {
  constexpr unsigned kHalf = 4, kLow = 15;
  std::string text(kTitle);
  for (const std::uint8_t byte : key) {
    text += kDigits[byte >> kHalf];
    text += kDigits[byte & kLow];
  }
  return text + "\n";
}

bool read_digits(std::string_view text, Key& key) {
  constexpr std::size_t kBase = 16;
  for (std::size_t i = 0; i < kKeyBytes; ++i) {
    const std::size_t high = kDigits.find(text[2 * i]);
    const std::size_t low = kDigits.find(text[2 * i + 1]);
    if (high == std::string_view::npos || low == std::string_view::npos) return false;
    key[i] = static_cast<std::uint8_t>(high * kBase + low);
  }
  return true;
}

/// The problem with the permissions of the file `path`.
std::string problem_of_rights(const std::string& path, const struct stat& status) {
  if (!S_ISREG(status.st_mode)) return "it is not a file" + std::string(kMakeOne);
  if (status.st_uid != geteuid())
    return "it belongs to another user\nhelp: make a copy for each user: `install -m 600 FILE "
           "COPY`";
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return "others can read it, or write it\nhelp: chmod 600 " + path +
           "; if others may have read it, take a new key";
  return {};
}

std::string problem_of_text(std::string_view text, Key& key) {
  if (text.size() != kTextBytes)
    return "it is not a key: it has " + std::to_string(text.size()) +
           (text.size() > kTextBytes ? " bytes or more" : " bytes") + ", a key has " +
           std::to_string(kTextBytes) + kMakeOne;
  if (!text.starts_with(kTitle) || text.back() != '\n' ||
      !read_digits(text.substr(kTitle.size()), key))
    return "it is not a key: a key is a line `" + std::string(kTitle) + "` and 64 of the digits " +
           std::string(kDigits) + kMakeOne;
  return {};
}

/// errno, 0: everything is on the disk.
int write_down(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 ? errno : EIO;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return fsync(file) == 0 ? 0 : errno;
}

}  // namespace

std::string read_key(const std::string& path, Key& key) {
  // A pipe would make the program wait.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) return std::strerror(errno) + std::string(errno == ENOENT ? kMakeOne : "");
  struct stat status {};
  std::array<char, kTextBytes + 1> bytes{};
  std::string problem =
      fstat(file, &status) == 0 ? problem_of_rights(path, status) : std::strerror(errno);
  if (problem.empty()) {
    const ssize_t size = ::read(file, bytes.data(), bytes.size());
    problem = size < 0 ? std::strerror(errno)
                       : problem_of_text({bytes.data(), static_cast<std::size_t>(size)}, key);
  }
  ::close(file);
  explicit_bzero(bytes.data(), bytes.size());
  return problem;
}

std::string new_key(const std::string& path) {
  Key key{};
  if (getrandom(key.data(), key.size(), 0) != static_cast<ssize_t>(key.size()))
    return std::strerror(errno);
  // With its rights from the first moment on, under a random name until it is complete.
  std::string draft = path + ".XXXXXX";
  const int file = mkostemp(draft.data(), O_CLOEXEC);
  if (file < 0) return std::strerror(errno);
  int number = write_down(file, text_of(key));
  explicit_bzero(key.data(), key.size());
  // Unlike a renaming this leaves what has the name alone.
  if (number == 0 && link(draft.c_str(), path.c_str()) != 0) number = errno;
  ::close(file);
  unlink(draft.c_str());
  if (number == EEXIST) return "there is a file of this name";
  return number == 0 ? std::string() : std::strerror(number);
}

}  // namespace eagerx::key
