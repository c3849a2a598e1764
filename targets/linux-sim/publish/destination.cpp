#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <targets/linux-sim/nearest.hpp>
#include <targets/linux-sim/publish/destination.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr const char* kLoopback = "127.0.0.1";

struct Known {
  const char* name;
  Destination::Kind kind;
};
constexpr std::array kKinds{Known{"udp", Destination::Kind::udp},
                            Known{"teleplot", Destination::Kind::teleplot}};

bool is_port(std::string_view text) {
  constexpr unsigned kMost = 65'535;
  unsigned port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port >= 1 && port <= kMost;
}

std::string wrong(const std::string& text, const std::string& help) {
  return "error: nothing can be published to `" + text + "`\nhelp: " + help;
}

}  // namespace

std::variant<Destination, std::string> read_destination(const std::string& text) {
  constexpr const char* kForm =
      "it is udp:HOST:PORT or teleplot:HOST:PORT; without HOST: this machine";
  if (text.find('\0') != std::string::npos) return wrong(text.c_str(), kForm);
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const auto* const known = std::find_if(kKinds.begin(), kKinds.end(),
                                         [&](const Known& each) { return name == each.name; });
  if (known == kKinds.end()) {
    constexpr std::size_t kLongestTypo = 2;
    for (const Known& each : kKinds) {
      if (edit_distance(name, each.name) <= kLongestTypo)
        return wrong(text, "did you mean `" + (each.name + text.substr(name.size())) + "`?");
    }
    return wrong(text, kForm);
  }
  if (colon == std::string::npos) return wrong(text, kForm);
  const std::string place = text.substr(colon + 1);
  const std::size_t last = place.rfind(':');
  Destination destination{known->kind, text, kLoopback, place};
  if (last != std::string::npos) {
    destination.host = place.substr(0, last);
    destination.port = place.substr(last + 1);
  }
  std::string& host = destination.host;
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')  // IPv6
    host = host.substr(1, host.size() - 2);
  if (host.empty()) return wrong(text, kForm);
  if (!is_port(destination.port)) return wrong(text, "PORT is a number from 1 to 65535");
  return destination;
}

}  // namespace eagerx::linux_sim
