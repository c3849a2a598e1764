// Relays the bytes of one connection between the client's socket and the library's, both ways. Of
// the client's bytes, the library receives those that ClientBytes lets through.
#pragma once

#include <chrono>
#include <runtime/host/web_socket/client_bytes.hpp>
#include <string>

namespace eagerx::web_socket {

class Relay {
 public:
  /// Takes ownership of `client`, a non-blocking socket.
  explicit Relay(int client);
  Relay(const Relay&) = delete;
  Relay& operator=(const Relay&) = delete;
  ~Relay();

  /// The library's end; it closes it. -1: there is none.
  int inner() const { return inner_; }
  void answered(ClientBytes::Answer with) { from_client_.answered(with); }
  bool is_no_request() const { return from_client_.is_no_request(); }
  bool is_unmasked() const { return from_client_.is_unmasked(); }
  /// Reads and writes as much as possible without blocking. True if there was anything.
  bool carry();
  /// Whether one end is gone, and its data has been sent to the other or takes too long.
  bool is_over() const;
  /// Whether the client has received everything that the library wrote.
  bool is_empty() const;

 private:
  using Clock = std::chrono::steady_clock;

  bool carry_in();
  bool carry_out();

  int client_, inner_ = -1, outer_ = -1;  // outer: what the library writes is read there
  ClientBytes from_client_;
  std::string to_client_;
  bool client_has_ended_ = false, library_has_ended_ = false, is_broken_ = false;
  Clock::time_point ended_at_;  // by the library
};

}  // namespace eagerx::web_socket
