#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <runtime/host/web_socket/listener.hpp>

namespace eagerx::web_socket {
namespace {

bool is_loopback(const sockaddr* address) {
  constexpr std::uint32_t kNetwork = 127, kHostBits = 24;
  if (address->sa_family == AF_INET) {
    sockaddr_in v4{};
    std::memcpy(&v4, address, sizeof v4);
    return ntohl(v4.sin_addr.s_addr) >> kHostBits == kNetwork;
  }
  if (address->sa_family != AF_INET6) return false;
  sockaddr_in6 v6{};
  std::memcpy(&v6, address, sizeof v6);
  return std::memcmp(&v6.sin6_addr, &in6addr_loopback, sizeof v6.sin6_addr) == 0;
}

std::string port_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  std::array<char, NI_MAXSERV> text{};
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
      getnameinfo(reinterpret_cast<const sockaddr*>(&address), size, nullptr, 0, text.data(),
                  text.size(), NI_NUMERICSERV) != 0)
    return {};
  return text.data();
}

}  // namespace

std::string listen_on(const std::string& host, const std::string& port, Listener& listener) {
  constexpr int kWaiting = 128, kOn = 1;
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV | AI_PASSIVE;
  const int error = getaddrinfo(host.c_str(), port.c_str(), &hints, &found);
  if (error != 0) return "there is no host `" + host + "`: " + gai_strerror(error);
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, freeaddrinfo);
  listener.socket = ::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  // A port that an earlier run has left may be taken again.
  if (listener.socket >= 0 &&
      setsockopt(listener.socket, SOL_SOCKET, SO_REUSEADDR, &kOn, sizeof kOn) == 0 &&
      bind(listener.socket, found->ai_addr, found->ai_addrlen) == 0 &&
      listen(listener.socket, kWaiting) == 0) {
    listener.is_loopback = is_loopback(found->ai_addr);
    listener.port = port_of(listener.socket);
    return {};
  }
  std::string problem = std::strerror(errno);
  if (errno == EADDRINUSE) problem += "\nhelp: choose another port";
  if (listener.socket >= 0) ::close(listener.socket);
  listener.socket = -1;
  return problem;
}

}  // namespace eagerx::web_socket
