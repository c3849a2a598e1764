// In place of web_socket.cpp where libwebsockets is not installed.
#include <unistd.h>

#include <runtime/host/web_socket/web_socket.hpp>

namespace eagerx::web_socket {

std::unique_ptr<WebSocketServer> web_socket_server(WebSocketOwner& /*owner*/, int listening,
                                                   std::string_view /*protocol*/,
                                                   const WebSocketLimits& /*limits*/,
                                                   std::string& problem) {
  ::close(listening);
  problem =
      "this program was built without libwebsockets\n"
      "help: apt install libwebsockets-dev, and build it again";
  return nullptr;
}

}  // namespace eagerx::web_socket
