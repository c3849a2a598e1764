#include <targets/linux-sim/publish/destination.hpp>

namespace eagerx::linux_sim {
bool parse_destination(std::string_view text, Destination& destination) {
  if (text.starts_with("dds")) {
    destination.kind = Destination::Kind::dds;
    destination.written = text;
    return dds::parse_network(text.substr(3), destination.network);
  }
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return false;
  const std::string_view kind = text.substr(0, colon), rest = text.substr(colon + 1);
  destination.written = text;
  destination.said = "--publish " + destination.written;
  if (kind == "mcap") {
    destination.kind = Destination::Kind::mcap;
    destination.file = rest;
    return !rest.empty() && rest != "-";
  }
  if (kind == "foxglove") {
    destination.kind = Destination::Kind::foxglove;
    return publish::parse_local_address(rest, destination);
  }
  if (kind == "udp") {
    destination.kind = Destination::Kind::udp;
  } else if (kind == "teleplot") {
    destination.kind = Destination::Kind::teleplot;
  } else {
    return false;
  }
  return publish::parse_address(rest, destination);
}

}  // namespace eagerx::linux_sim
