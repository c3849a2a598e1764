// In place of web_socket.cpp where libwebsockets is not installed.
#include <unistd.h>

#include <targets/linux-sim/publish/foxglove/web_socket.hpp>

namespace eagerx::linux_sim {

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

}  // namespace eagerx::linux_sim
