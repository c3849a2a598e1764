// Changes that clients may make to a run. The owner of a run implements them; a server without an
// owner is read-only.
#pragma once

#include <cstdint>
#include <runtime/host/foxglove/client_message.hpp>
#include <runtime/host/foxglove/server_text.hpp>
#include <runtime/host/web_socket/web_socket.hpp>
#include <string>
#include <vector>

namespace eagerx::foxglove {

class Steering {
 public:
  /// The owner of values whose client has disconnected.
  static constexpr web_socket::ClientId kNoClient = ~web_socket::ClientId{0};

  virtual ~Steering() = default;

  /// Parameters with these names, or all if none is given.
  virtual std::vector<ParameterValue> values(const std::vector<std::string>& names) = 0;
  virtual bool has(const std::string& name) const = 0;
  /// Empty, or the problem.
  virtual std::string set(web_socket::ClientId client, const ClientMessage::Parameter& wanted) = 0;
  /// Resets the values that a client has set. True: there were any.
  virtual bool release(web_socket::ClientId client) = 0;
  /// Another one each time that parameters change by themselves; odd while they do.
  virtual std::uint64_t version() const = 0;

  /// Whether a client may ask for services: a simulation.
  virtual bool has_services() const = 0;
  /// The number of the request, which has been done when done() is not below it; 0: it is busy.
  virtual std::uint64_t ask(Service service, std::uint32_t steps) = 0;
  virtual std::uint64_t done() const = 0;
};

}  // namespace eagerx::foxglove
