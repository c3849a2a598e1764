// A WebSocket server and client, without the types of the library that implements them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace eagerx::web_socket {

using ClientId = std::uint64_t;

/// A client's request before it is accepted.
struct Handshake {
  std::string key;        // of `?key=…` or `Authorization: Bearer …`
  std::string origin;     // of the page in a browser; empty: none
  std::string host = {};  // `HOST:PORT`, as it calls the server
};

/// A page for a browser.
struct Page {
  std::string text;
  const char* type = "";  // of MIME
};

/// Events of clients, within service() only.
class WebSocketOwner {
 public:
  /// False: it is refused.
  virtual bool admit(const Handshake& handshake) = 0;
  virtual void opened(ClientId client, const Handshake& handshake) = 0;
  /// A whole message. False: the client is disconnected.
  virtual bool received(ClientId client, std::string_view message, bool is_text) = 0;
  virtual void closed(ClientId client) = 0;
  /// The page at a path, which must outlive the server. Null if there is none, or none for this
  /// client.
  virtual const Page* page(std::string_view /*path*/, const Handshake& /*handshake*/) {
    return nullptr;
  }

 protected:
  ~WebSocketOwner() = default;
};

struct WebSocketLimits {
  std::size_t connections = 32;       // those that have not said what they want included
  std::size_t message_bytes = 65536;  // of a client
  std::size_t queue_bytes = 4 << 20;  // that a client has not taken yet
  double handshake_s = 5.0;
  double silence_s = 10.0;  // of a client that takes none of its messages
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
  /// Number of clients that were disconnected for their behavior.
  virtual std::uint64_t disconnected() const = 0;
};

/// Takes connections from `listening`, which does not block and is its own from now on. Null:
/// `problem` says why.
std::unique_ptr<WebSocketServer> web_socket_server(WebSocketOwner& owner, int listening,
                                                   std::string_view protocol,
                                                   const WebSocketLimits& limits,
                                                   std::string& problem);

/// Events for a client, within service() only.
class WebSocketListener {
 public:
  virtual void opened() = 0;
  /// A whole message. False: that was enough for now.
  virtual bool received(std::string_view message, bool is_text) = 0;

 protected:
  ~WebSocketListener() = default;
};

struct WebSocketAddress {
  std::string host, port;
  std::string protocol;
};

/// One thread calls it; no call waits, but where the host's name has to be looked up.
class WebSocketClient {
 public:
  enum class State : std::uint8_t {
    connecting,
    open,
    absent,   // no server listens there: connect() again
    refused,  // by the server, or it speaks another protocol
    closed    // it was open
  };
  virtual ~WebSocketClient() = default;
  /// Reconnects if it is not connected.
  virtual void connect() = 0;
  /// Reads and writes as much as possible without blocking. True if there may be more to read.
  virtual bool service() = 0;
  virtual State state() const = 0;
  virtual void send(std::string_view text) = 0;
  /// The file descriptor to wait on; -1: none now.
  virtual int descriptor() const = 0;
  /// Messages that were larger than the limit, and are lost.
  virtual std::uint64_t too_large() const = 0;
};

/// Null: `problem` says why. Messages have at most `message_bytes`.
std::unique_ptr<WebSocketClient> web_socket_client(WebSocketListener& listener,
                                                   const WebSocketAddress& to,
                                                   std::size_t message_bytes, std::string& problem);

}  // namespace eagerx::web_socket
