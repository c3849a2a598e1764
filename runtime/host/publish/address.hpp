// The destination of messages, and the name of their graph.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::publish {

struct Address {
  std::string host;
  std::string port;
  std::string said = {};  // what the user wrote, for messages: "--publish udp:HOST:PORT"
};

/// A number from 1 to 65535.
bool is_port(std::string_view text);
/// False if the text is not `HOST:PORT`. A host with colons is in brackets.
bool parse_address(std::string_view text, Address& address);

/// The same of `[HOST:]PORT`; without a host it is this machine's own, 127.0.0.1.
bool parse_local_address(std::string_view text, Address& address);

}  // namespace eagerx::publish
