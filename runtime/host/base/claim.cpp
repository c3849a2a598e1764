#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <runtime/host/base/claim.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/hash.hpp>
#include <set>

namespace eagerx::host {
namespace {

/// The same for all names of a file, whether it is there or not: its folder and its name in it.
std::string key_of(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole =
      std::filesystem::absolute(behind_links(path), error).lexically_normal();
  struct stat folder {};
  if (stat(whole.parent_path().c_str(), &folder) != 0) return whole.string();
  return std::to_string(folder.st_dev) + ":" + std::to_string(folder.st_ino) + "/" +
         whole.filename().string();
}

/// The claims of this process.
std::mutex claimed_mutex;
std::set<std::string>& claimed() {
  static std::set<std::string> keys;
  return keys;
}

class Address {
 public:
  explicit Address(const std::string& key) {
    const std::string name = "eagerx-output-" + hex_text(fnv1a(key));
    address_.sun_family = AF_UNIX;
    std::ranges::copy(name, &address_.sun_path[1]);  // behind a zero: abstract
    size_ = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  }
  [[nodiscard]] const sockaddr* get() const {
    return reinterpret_cast<const sockaddr*>(&address_);  // NOLINT(*-reinterpret-cast)
  }
  [[nodiscard]] socklen_t size() const { return size_; }

 private:
  sockaddr_un address_{};
  socklen_t size_ = 0;
};

int new_socket() {
  return socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
}

/// Whether a TextFile has reserved it.
bool is_reserved(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (file < 0) return false;
  const bool is_free = flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  close(file);  // and the lock goes with it
  return !is_free;
}

}  // namespace

int claim_output(const std::string& path) {
  if (!is_replaced_by_output(path)) return 0;
  const std::string key = key_of(path);
  const std::scoped_lock lock(claimed_mutex);
  if (claimed().contains(key)) return 0;
  const Address address(key);
  const int held = new_socket();  // until the process ends
  if (held < 0) return 0;
  if (bind(held, address.get(), address.size()) != 0) {
    const bool is_taken = errno == EADDRINUSE;
    close(held);
    return is_taken ? EWOULDBLOCK : 0;
  }
  if (is_reserved(path)) {
    close(held);
    return EWOULDBLOCK;
  }
  claimed().insert(key);
  return 0;
}

bool is_claimed(const std::string& path) {
  const std::string key = key_of(path);
  const std::scoped_lock lock(claimed_mutex);
  if (claimed().contains(key)) return false;
  const Address address(key);
  const int probe = new_socket();
  if (probe < 0) return false;
  const bool found = connect(probe, address.get(), address.size()) == 0;
  close(probe);
  return found;
}

}  // namespace eagerx::host
