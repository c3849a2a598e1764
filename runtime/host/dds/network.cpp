#include <algorithm>
#include <charconv>
#include <runtime/host/dds/network.hpp>

namespace eagerx::dds {
namespace {
constexpr std::uint32_t kMostDomain = 232;
}  // namespace

bool is_interface(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
           c == '-' || c == '_';
  });
}

bool parse_network(std::string_view text, Network& network) {
  if (text.empty()) return true;
  const std::size_t at = text.find('@');
  if (at != std::string_view::npos) {
    if (!is_interface(text.substr(at + 1))) return false;
    network.interface = text.substr(at + 1);
    text = text.substr(0, at);
  }
  if (text.empty()) return true;
  if (text.front() != ':') return false;
  const auto [end, error] =
      std::from_chars(text.data() + 1, text.data() + text.size(), network.domain);
  return error == std::errc() && end == text.data() + text.size() && network.domain <= kMostDomain;
}

}  // namespace eagerx::dds
