// Bytes from strangers on a line with a key: greetings, records, and files that are not keys.
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <runtime/host/key/key_file.hpp>
#include <runtime/host/key/session.hpp>
#include <string>
#include <tests/fuzz/send_records.hpp>
#include <vector>

namespace {

using namespace eagerx;
using fuzz::Line;

const key::Functions& functions() {
  static std::string problem;
  static const key::Functions* const found = key::sodium(problem);
  if (found == nullptr) std::abort();
  return *found;
}

key::Key key_of(std::uint8_t byte) {
  key::Key key;
  key.fill(byte);
  return key;
}

Line said_by(key::Greeting& who) {
  const key::Bytes bytes = who.to_send();
  const Line copy(bytes.begin(), bytes.end());
  who.sent();
  return copy;
}

/// No peer without the key is let in, whatever it sends and in whatever pieces.
void greet_stranger(key::Role role, const std::uint8_t* data, std::size_t size) {
  key::Greeting greeting;
  greeting.begin(functions(), key_of(1), role);
  for (std::size_t at = 0; at < size;) {
    const std::size_t piece = std::min<std::size_t>(data[at] % 64U + 1U, size - at);
    const std::size_t taken = std::min(piece, greeting.wanted());
    if (taken == 0 || !greeting.take({data + at, taken})) break;
    if (greeting.to_send().size() > key::Greeting::kMostBytes) std::abort();
    greeting.sent();
    at += taken;
  }
  if (greeting.is_done()) std::abort();
}

struct Session {
  key::Records hub, part;
  Session() {
    key::Greeting connector, listener;
    connector.begin(functions(), key_of(1), key::Role::connects);
    listener.begin(functions(), key_of(1), key::Role::listens);
    if (!listener.take(said_by(connector)) || !connector.take(said_by(listener)) ||
        !listener.take(said_by(connector)))
      std::abort();
    connector.go_on(hub);
    listener.go_on(part);
  }
};

/// Opens all that comes; how many records of `text` it was. Anything else is a forgery that passed.
int open_all(key::Records& by, const Line& line, const Line& text) {
  std::vector<std::uint8_t> bytes(key::Records::kMostBytes);
  int opened = 0;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t count = std::min(by.room().size(), line.size() - at);
    std::copy_n(line.begin() + static_cast<std::ptrdiff_t>(at), count, by.room().begin());
    by.take(count);
    at += count;
    for (bool more = true; more;) {
      std::size_t size = 0;
      switch (by.open(bytes.data(), size)) {
        case key::Records::Found::record:
          if (size != text.size() || !std::equal(text.begin(), text.end(), bytes.begin()))
            std::abort();
          ++opened;
          break;
        case key::Records::Found::forged:
          if (size != 0) std::abort();
          return opened;
        case key::Records::Found::end:
          std::abort();  // no reason was given
        case key::Records::Found::nothing:
          more = false;
      }
    }
  }
  return opened;
}

void read_file(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("key", MFD_CLOEXEC);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (ftruncate(file, 0) != 0 || fchmod(file, 0600) != 0 ||
      pwrite(file, data, size, 0) != static_cast<ssize_t>(size))
    std::abort();
  key::Key key{};
  const std::string problem = key::read_key(path, key);
  if (problem.empty() && size != 82) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  greet_stranger(key::Role::listens, data, size);
  greet_stranger(key::Role::connects, data, size);
  Line titled(key::Greeting::kTitle.begin(), key::Greeting::kTitle.end());
  titled.insert(titled.end(), data, data + size);
  greet_stranger(key::Role::listens, titled.data(), titled.size());
  fuzz::send_records<Session>(data, size, key::Records::kMostBytes, open_all);
  read_file(data, size);
  return 0;
}
