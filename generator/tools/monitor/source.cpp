#include "generator/tools/monitor/source.hpp"

namespace eagerx::gen {

std::unique_ptr<Source> open_source(const std::string& name, const std::string& layout,
                                    std::string& problem) {
  constexpr std::string_view kUdp = "udp:", kSerial = "serial:", kFoxglove = "foxglove:";
  if (name.starts_with(kUdp))
    return open_udp_source(name, std::string_view(name).substr(kUdp.size()), problem);
  if (name.starts_with(kFoxglove))
    return open_foxglove_source(name, std::string_view(name).substr(kFoxglove.size()), problem);
  if (name.starts_with(kSerial))
    return open_serial_source(name.substr(kSerial.size()), layout, problem);
  if (name.ends_with(".mcap")) return open_mcap_source(name, problem);
  return open_log_source(name, problem);
}

}  // namespace eagerx::gen
