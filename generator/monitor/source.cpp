#include "generator/monitor/source.hpp"

namespace eagerx::gen {

std::unique_ptr<Source> open_source(const std::string& name, std::string& problem) {
  constexpr std::string_view kUdp = "udp:";
  if (name.starts_with(kUdp))
    return open_udp_source(name, std::string_view(name).substr(kUdp.size()), problem);
  return open_log_source(name, problem);
}

}  // namespace eagerx::gen
