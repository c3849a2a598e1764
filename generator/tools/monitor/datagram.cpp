#include "generator/tools/monitor/datagram.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <runtime/host/trace/channel_name.hpp>

#include "generator/support/json/json.hpp"
#include "generator/tools/monitor/stream.hpp"

namespace eagerx::gen {
namespace {

constexpr double kMostSeconds = 4e9;  // in nanoseconds that is half of 63 bits

/// A number, a truth or null.
std::optional<double> element_of(const Json& value) {
  if (value.is<std::monostate>()) return std::numeric_limits<double>::quiet_NaN();
  if (const auto truth = truth_of(&value)) return *truth ? 1.0 : 0.0;
  return number_of(&value);
}

/// False: no message.
bool read_message(const JsonMember& member, Datagram& datagram) {
  if (!trace_log::problem_with_channel_name(member.name).empty() || member.name.empty())
    return false;
  DatagramMessage message;
  message.channel = member.name;
  if (const auto* const list = member.value.as<Json::List>()) {
    for (const Json& item : *list) {
      const auto element = element_of(item);
      if (!element) return false;
      if (message.elements++ < kMostStreamElements) message.values.push_back(*element);
    }
    if (list->empty()) return false;
  } else {
    const auto element = element_of(member.value);
    if (!element) return false;
    message.values = {*element};
    message.elements = 1;
  }
  datagram.crowded_out += message.elements - message.values.size();
  if (datagram.messages.size() == kMostStreamChannels) {
    ++datagram.crowded_out;
  } else {
    datagram.messages.push_back(std::move(message));
  }
  return true;
}

template <class T>
bool read_whole(const Json& value, T& whole) {
  const auto* const number = value.as<std::int64_t>();
  if (number == nullptr || *number < 0) return false;
  if (static_cast<std::uint64_t>(*number) > std::numeric_limits<T>::max()) return false;
  whole = static_cast<T>(*number);
  return true;
}

bool read_time(const Json& value, double& time_s) {
  const auto number = number_of(&value);
  if (!number || !(*number >= 0.0) || *number > kMostSeconds) return false;
  time_s = *number;
  return true;
}

}  // namespace

std::optional<std::uint64_t> read_hash(std::string_view text) {
  constexpr std::size_t kDigits = 16;
  constexpr int kHexadecimal = 16;
  if (!text.starts_with("0x") || text.size() != kDigits + 2) return std::nullopt;
  text.remove_prefix(2);
  std::uint64_t hash = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), hash, kHexadecimal);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return hash;
}

std::optional<Datagram> read_datagram(std::string_view bytes) {
  const auto json = parse_json(bytes);
  const auto* const object = json ? json->as<Json::Object>() : nullptr;
  if (object == nullptr) return std::nullopt;
  Datagram datagram;
  bool has_time = false, has_episode = false, has_step = false;
  for (const JsonMember& member : *object) {
    bool is_right = false;
    if (member.name == "timestamp") {
      is_right = has_time = read_time(member.value, datagram.time_s);
    } else if (member.name == "episode") {
      is_right = has_episode = read_whole(member.value, datagram.episode);
    } else if (member.name == "step") {
      is_right = has_step = read_whole(member.value, datagram.step);
    } else if (member.name == "graph") {
      datagram.graph_hash = read_hash(text_of(&member.value));
      is_right = datagram.graph_hash.has_value();
    } else {
      is_right = read_message(member, datagram);
    }
    if (!is_right) return std::nullopt;
  }
  if (!has_time || !has_episode || !has_step) return std::nullopt;
  return datagram;
}

}  // namespace eagerx::gen
