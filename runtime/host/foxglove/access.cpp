#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <runtime/host/foxglove/access.hpp>

namespace eagerx::foxglove {
namespace {

constexpr std::size_t kLeastKey = 16, kMostKey = 512;

std::string about(const std::string& path) {
  return "error: `--publish-key " + path + "`: ";
}

}  // namespace

std::string read_key(const std::string& path, std::string& key) {
  // A pipe would make the program wait.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return about(path) + std::strerror(errno);
  struct stat status {};
  std::array<char, kMostKey + 3> text{};
  const bool is_file = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  const ssize_t size = is_file ? ::read(file, text.data(), text.size()) : 0;
  ::close(file);
  if (!is_file) return about(path) + "it is not a file";
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return about(path) + "others can read it, or write it\nhelp: chmod 600 " + path;
  key.assign(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  const std::size_t end = key.find_first_of("\r\n");
  key.resize(std::min(end, key.size()));
  const bool is_printable =
      std::all_of(key.begin(), key.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (key.size() >= kLeastKey && key.size() <= kMostKey && is_printable) return {};
  return about(path) + "its first line is not a key of " + std::to_string(kLeastKey) + " to " +
         std::to_string(kMostKey) +
         " printable characters\nhelp: openssl rand -hex 32 > FILE makes a good one";
}

bool is_key(std::string_view presented, std::string_view key) {
  unsigned difference = presented.size() == key.size() ? 0U : 1U;
  for (std::size_t i = 0; i < presented.size(); ++i)
    difference |= static_cast<unsigned char>(presented[i]) ^
                  static_cast<unsigned char>(key.empty() ? '\0' : key[i % key.size()]);
  return difference == 0;
}

bool is_known_origin(std::string_view origin) {
  if (origin == "https://app.foxglove.dev") return true;
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (!origin.starts_with(scheme)) continue;
    std::string_view host = origin.substr(scheme.size());
    const std::size_t port = host.rfind(':');
    if (port != std::string_view::npos &&
        host.find_first_not_of("0123456789", port + 1) == std::string_view::npos)
      host = host.substr(0, port);
    return host == "localhost" || host == "127.0.0.1" || host == "[::1]";
  }
  return false;
}

}  // namespace eagerx::foxglove
