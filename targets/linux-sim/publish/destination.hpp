// The value of `--publish`.
#pragma once

#include <cstdint>
#include <runtime/host/dds/network.hpp>
#include <runtime/host/publish/address.hpp>
#include <string>
#include <string_view>

namespace eagerx::linux_sim {

/// With an address, if it has one: udp, teleplot, foxglove.
struct Destination : publish::Address {
  enum class Kind : std::uint8_t { udp, teleplot, mcap, foxglove, dds };
  Kind kind = Kind::udp;
  std::string file;      // of mcap
  dds::Network network;  // of dds
  std::string written;   // the whole text
};

/// False if the text is none of `udp:HOST:PORT`, `teleplot:HOST:PORT`, `mcap:FILE`,
/// `foxglove:[HOST:]PORT`, `dds[:DOMAIN][@INTERFACE]`. A host with colons is in brackets.
bool parse_destination(std::string_view text, Destination& destination);

}  // namespace eagerx::linux_sim
