// Where messages are published to, as `--publish` says it.
#pragma once

#include <string>
#include <variant>

namespace eagerx::linux_sim {

/// One `--publish KIND:…`.
struct Destination {
  enum class Kind { udp, teleplot };
  Kind kind = Kind::udp;
  std::string text;  // as it was given
  std::string host;
  std::string port;
};

/// What `text` says; or what is wrong with it, in lines of `error:` and `help:`.
std::variant<Destination, std::string> read_destination(const std::string& text);

}  // namespace eagerx::linux_sim
