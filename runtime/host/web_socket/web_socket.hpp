// WebSockets for the server of Foxglove's protocol, without the types of the library that speaks
// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace eagerx::web_socket {

using ClientId = std::uint64_t;

/// What a client says of itself before it is one.
struct Handshake {
  std::string key;     // of `?key=…` or `Authorization: Bearer …`
  std::string origin;  // of the page in a browser; empty: none
};

/// What is told of clients, within service() only.
class WebSocketOwner {
 public:
  /// False: it is refused.
  virtual bool admit(const Handshake& handshake) = 0;
  virtual void opened(ClientId client, const Handshake& handshake) = 0;
  /// A whole message. False: the client is disconnected.
  virtual bool received(ClientId client, std::string_view message, bool is_text) = 0;
  virtual void closed(ClientId client) = 0;

 protected:
  ~WebSocketOwner() = default;
};

struct WebSocketLimits {
  std::size_t connections = 32;       // those that have not said what they want included
  std::size_t message_bytes = 65536;  // of a client
  std::size_t queue_bytes = 4 << 20;  // that a client has not taken yet
  double handshake_s = 5.0;
  double silence_s = 10.0;  // of a client that takes nothing of what there is for it
};

/// One thread calls it; no call waits.
class WebSocketServer {
 public:
  virtual ~WebSocketServer() = default;
  /// Reads and writes what is possible now.
  virtual void service() = 0;
  /// False: there is no room for it. Answers may need a quarter more than `queue_bytes`.
  virtual bool send(ClientId client, bool is_text, bool is_answer, std::string_view message) = 0;
  virtual bool has_room(ClientId client) const = 0;
  virtual void disconnect(ClientId client) = 0;
  /// Whether everything is written.
  virtual bool is_empty() const = 0;
  virtual std::uint64_t refused() const = 0;
  /// Clients that were disconnected for what they did, or did not do.
  virtual std::uint64_t disconnected() const = 0;
};

/// Takes connections from `listening`, which does not block and is its own from now on. Null:
/// `problem` says why.
std::unique_ptr<WebSocketServer> web_socket_server(WebSocketOwner& owner, int listening,
                                                   std::string_view protocol,
                                                   const WebSocketLimits& limits,
                                                   std::string& problem);

}  // namespace eagerx::web_socket
