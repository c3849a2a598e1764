// The network that a program uses for DDS.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eagerx::dds {

/// `dds[:DOMAIN][@INTERFACE]`
struct Network {
  std::uint32_t domain = 0;  // to 232
  std::string interface;     // a name or an IPv4 address; empty: this machine only
};
/// Parses the text after `dds`. False if it is invalid.
bool parse_network(std::string_view text, Network& network);

/// Whether it can be the name or, where there is one, the address of an interface; it has nothing
/// that means something in XML.
bool is_interface(std::string_view text);

}  // namespace eagerx::dds
