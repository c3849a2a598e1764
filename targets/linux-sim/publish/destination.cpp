#include <charconv>
#include <targets/linux-sim/publish/destination.hpp>

namespace eagerx::linux_sim {
namespace {

bool is_port(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port > 0;
}

/// `HOST:PORT`
bool parse_address(std::string_view text, Destination& destination) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return false;
  const std::string_view port = text.substr(colon + 1);
  std::string_view host = text.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) {
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != std::string_view::npos) {
    return false;
  }
  if (!is_port(port) || host.empty()) return false;
  destination.host = host;
  destination.port = port;
  return true;
}

}  // namespace

bool parse_destination(std::string_view text, Destination& destination) {
  using Kind = Destination::Kind;
  if (text.starts_with("dds")) {
    destination.kind = Kind::dds;
    destination.written = text;
    return dds::parse_network(text.substr(3), destination.network);
  }
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return false;
  const std::string_view kind = text.substr(0, colon), rest = text.substr(colon + 1);
  destination.written = text;
  if (kind == "mcap") {
    destination.kind = Kind::mcap;
    destination.file = rest;
    return !rest.empty() && rest != "-";
  }
  if (kind == "foxglove") {
    destination.kind = Kind::foxglove;
    if (rest.find(':') != std::string_view::npos) return parse_address(rest, destination);
    destination.host = "127.0.0.1";
    destination.port = rest;
    return is_port(rest);
  }
  if (kind == "udp") {
    destination.kind = Kind::udp;
  } else if (kind == "teleplot") {
    destination.kind = Kind::teleplot;
  } else {
    return false;
  }
  return parse_address(rest, destination);
}

}  // namespace eagerx::linux_sim
