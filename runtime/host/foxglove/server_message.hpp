// Messages of servers in Foxglove's WebSocket protocol, for a client:
// https://github.com/foxglove/ws-protocol/blob/main/docs/spec.md
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eagerx::foxglove {

struct ServerMessage {
  enum class Kind : std::uint8_t {
    wrong,  // none of the protocol
    other,  // nothing that a reader of messages needs
    info,
    advertise,
    unadvertise,
    data
  };
  struct Channel {
    std::uint32_t id = 0;
    std::string topic, encoding;
  };

  Kind kind = Kind::wrong;
  std::vector<std::pair<std::string, std::string>> metadata;  // of info
  std::vector<Channel> channels;                              // of advertise
  std::vector<std::uint32_t> ids;                             // of unadvertise
  std::uint32_t subscription = 0;                             // of data
  std::int64_t time_ns = 0;
  std::string_view payload;  // within what was read

  /// "" if there is none.
  std::string_view about(std::string_view name) const;
};

ServerMessage read_server_text(std::string_view text);
ServerMessage read_server_bytes(std::string_view bytes);

/// `{"episode":0,"tick":3,"value":[0.5,null]}`: a message of a graph's channel.
struct ChannelValue {
  std::uint32_t episode = 0;
  std::uint64_t tick = 0;
  std::uint64_t elements = 0;
  std::vector<double> values;  // at most `most`; null is not a number
};
/// False: it is none.
bool read_channel_value(std::string_view json, std::size_t most, ChannelValue& to);

/// A message of drawing_topic(): rows of kSceneColumns numbers. False: it is none.
bool read_drawing(std::string_view json, std::uint32_t& episode, std::vector<float>& rows);

}  // namespace eagerx::foxglove
