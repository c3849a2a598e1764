// The datagrams that `--publish udp:HOST:PORT` sends, see runtime/host/publish/datagrams.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::gen {

struct DatagramMessage {
  std::string channel;
  std::vector<double> values;  // at most kMostStreamElements; null is not a number
  std::uint64_t elements = 0;
};

struct Datagram {
  double time_s = 0.0;
  std::uint32_t episode = 0;
  std::uint64_t step = 0;
  std::optional<std::uint64_t> graph_hash;
  std::vector<DatagramMessage> messages;  // at most kMostStreamChannels
  std::uint64_t crowded_out = 0;          // messages and elements beyond that
};

/// Any bytes. Nothing if they are no such datagram.
std::optional<Datagram> read_datagram(std::string_view bytes);

/// The number in "0x0123456789abcdef".
std::optional<std::uint64_t> read_hash(std::string_view text);

}  // namespace eagerx::gen
