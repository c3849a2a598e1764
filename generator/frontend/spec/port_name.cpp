#include "generator/frontend/spec/port_name.hpp"

#include <algorithm>

namespace eagerx::gen {

std::string PortName::within_owner() const {
  return section.empty() ? name : section + "." + name;
}

PortName parse_port(std::string_view text) {
  PortName port;
  const auto take = [&text] {
    std::string part(text.substr(0, text.find('.')));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
    return part;
  };
  port.owner = take();
  if (text.find('.') != std::string_view::npos) port.section = take();
  port.name = text;
  return port;
}

}  // namespace eagerx::gen
