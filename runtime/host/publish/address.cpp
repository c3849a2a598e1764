#include <cstdint>
#include <runtime/host/base/number.hpp>
#include <runtime/host/publish/address.hpp>

namespace eagerx::publish {

bool is_port(std::string_view text) {
  std::uint16_t port = 0;
  return host::read_number(text, port) && port > 0;
}

bool parse_address(std::string_view text, Address& address) {
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
  address.host = host;
  address.port = port;
  return true;
}

bool parse_local_address(std::string_view text, Address& address) {
  if (!is_port(text)) return parse_address(text, address);
  address.host = "127.0.0.1";
  address.port = text;
  return true;
}

}  // namespace eagerx::publish
