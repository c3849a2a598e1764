// Replaces the other files where libwebsockets is not installed.
#include <unistd.h>

#include <runtime/host/web_socket/web_socket.hpp>

namespace eagerx::web_socket {
namespace {
constexpr const char* kProblem =
    "this program was built without libwebsockets\n"
    "help: apt install libwebsockets-dev, and build it again";
}  // namespace

std::unique_ptr<WebSocketServer> web_socket_server(WebSocketOwner& /*owner*/, int listening,
                                                   std::string_view /*protocol*/,
                                                   const WebSocketLimits& /*limits*/,
                                                   std::string& problem) {
  ::close(listening);
  problem = kProblem;
  return nullptr;
}

std::unique_ptr<WebSocketClient> web_socket_client(WebSocketListener& /*listener*/,
                                                   const WebSocketAddress& /*to*/,
                                                   std::size_t /*message_bytes*/,
                                                   std::string& problem) {
  problem = kProblem;
  return nullptr;
}

}  // namespace eagerx::web_socket
