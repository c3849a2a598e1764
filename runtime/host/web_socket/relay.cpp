#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <runtime/host/web_socket/relay.hpp>

namespace eagerx::web_socket {
namespace {

using namespace std::chrono_literals;

enum class Read : std::uint8_t { some, nothing, end };

bool would_block() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

Read read_some(int from, std::string& bytes) {
  std::array<char, 1 << 16> buffer;  // NOLINT(cppcoreguidelines-pro-type-member-init): is read into
  const ssize_t size = ::recv(from, buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (size < 0) return would_block() ? Read::nothing : Read::end;
  if (size == 0) return Read::end;
  bytes.assign(buffer.data(), static_cast<std::size_t>(size));
  return Read::some;
}

/// False: the other end is closed.
bool write_some(int to, std::string& bytes) {
  const ssize_t size = ::send(to, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (size < 0) return would_block();
  bytes.erase(0, static_cast<std::size_t>(size));
  return true;
}

}  // namespace

Relay::Relay(int client) : client_(client) {
  constexpr int kOn = 1;
  // A message is not kept back until the client has confirmed the one before.
  setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &kOn, sizeof kOn);
  std::array<int, 2> pair{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, pair.data()) != 0)
    return;
  inner_ = pair[0];
  outer_ = pair[1];
}

Relay::~Relay() {
  ::close(client_);
  if (outer_ >= 0) ::close(outer_);
}

bool Relay::carry() {
  const bool did_read = carry_in(), did_write = carry_out();
  return did_read || did_write;
}

bool Relay::carry_in() {
  bool did_something = false;
  if (!client_has_ended_ && from_client_.passed.empty() && !from_client_.is_waiting()) {
    std::string bytes;
    const Read read = read_some(client_, bytes);
    did_something = read != Read::nothing;
    client_has_ended_ = read == Read::end;
    // Bytes that arrive after the library has ended are read and dropped: otherwise a client that
    // waits for them to be read would not learn the reason.
    if (!library_has_ended_) from_client_.add(bytes);
    if (from_client_.is_no_request()) is_broken_ = true;
  }
  std::string& passed = from_client_.passed;
  const std::size_t before = passed.size();
  if (library_has_ended_ || (before > 0 && !write_some(outer_, passed))) passed.clear();
  if (client_has_ended_ && passed.empty()) ::shutdown(outer_, SHUT_WR);
  return did_something || passed.size() < before;
}

bool Relay::carry_out() {
  bool did_something = false;
  if (!library_has_ended_ && to_client_.empty()) {
    const Read read = read_some(outer_, to_client_);
    did_something = read != Read::nothing;
    library_has_ended_ = read == Read::end;
    if (library_has_ended_) ended_at_ = Clock::now();
  }
  const std::size_t before = to_client_.size();
  if (before > 0 && !write_some(client_, to_client_)) is_broken_ = true;
  if (library_has_ended_ && to_client_.empty()) ::shutdown(client_, SHUT_WR);
  return did_something || to_client_.size() < before;
}

bool Relay::is_over() const {
  constexpr auto kPatience = 1s;
  if (is_broken_) return true;
  if (!library_has_ended_) return false;
  return (client_has_ended_ && to_client_.empty()) || Clock::now() - ended_at_ > kPatience;
}

bool Relay::is_empty() const {
  int unread = 0;
  return to_client_.empty() && (ioctl(outer_, FIONREAD, &unread) != 0 || unread == 0);
}

}  // namespace eagerx::web_socket
