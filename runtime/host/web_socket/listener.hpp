// A listening socket.
#pragma once

#include <string>

namespace eagerx::web_socket {

struct Listener {
  int socket = -1;  // of the caller of listen_on()
  bool is_loopback = false;
  std::string port;  // that it got, if any was good enough
};

/// Port 0: any free port. Empty, or the problem.
std::string listen_on(const std::string& host, const std::string& port, Listener& listener);

}  // namespace eagerx::web_socket
