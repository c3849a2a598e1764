// Messages of clients in Foxglove's WebSocket protocol:
// https://github.com/foxglove/ws-protocol/blob/main/docs/spec.md
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::foxglove {

struct ClientMessage {
  enum class Kind : std::uint8_t {
    wrong,
    unsupported,  // something of the protocol that this server does not offer
    subscribe,
    unsubscribe,
    get_parameters,
    set_parameters,
    subscribe_parameters,
    unsubscribe_parameters,
    call
  };
  struct Subscription {
    std::uint32_t id = 0, channel = 0;
  };
  struct Parameter {
    std::string name;
    bool has_flags = false;       // `true` or `false` among them, as 1 and 0
    bool is_wrong = false;        // neither a number, a flag, an array of them, nor nothing
    std::vector<double> numbers;  // none: it is no longer set
  };

  Kind kind = Kind::wrong;
  std::string problem;                      // of wrong and unsupported
  std::vector<Subscription> subscriptions;  // of subscribe
  std::vector<std::uint32_t> ids;           // of unsubscribe
  std::vector<std::string> names;           // of parameters
  std::vector<Parameter> parameters;        // of set_parameters
  std::string id;                           // of get_parameters and set_parameters; may be empty
  std::uint32_t service = 0, call_id = 0;   // of call
  std::string encoding;
  std::string request;
};

ClientMessage read_client_text(std::string_view text);
ClientMessage read_client_bytes(std::string_view bytes);

/// The steps of a request for them, `{"steps":3}`; 1 of an empty one, 0 if it is none.
std::uint32_t steps_of_request(std::string_view request);

}  // namespace eagerx::foxglove
