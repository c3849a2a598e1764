#include <cmath>
#include <eagerx/scene.hpp>
#include <limits>
#include <runtime/host/base/json_reader.hpp>
#include <runtime/host/foxglove/server_message.hpp>

namespace eagerx::foxglove {
namespace {

using Json = host::JsonValue;
using host::read_json;

using MessageKind = ServerMessage::Kind;

/// A whole number below 2^53, or what T can have.
template <class T>
bool read_whole(const Json* value, T& to) {
  constexpr double kEnd = 9007199254740992.0;
  if (value == nullptr || value->kind != Json::Kind::number) return false;
  const double x = value->number;
  if (!(x >= 0.0 && x < kEnd) || x != std::floor(x)) return false;
  if (x > static_cast<double>(std::numeric_limits<T>::max())) return false;
  to = static_cast<T>(x);
  return true;
}

bool read_text(const Json* value, std::string& to) {
  if (value == nullptr || value->kind != Json::Kind::text) return false;
  to = value->text;
  return true;
}

bool read_element(const Json& value, double& to) {
  switch (value.kind) {
    case Json::Kind::number:
      to = value.number;
      return true;
    case Json::Kind::boolean:
      to = value.boolean ? 1.0 : 0.0;
      return true;
    case Json::Kind::null:
      to = std::numeric_limits<double>::quiet_NaN();
      return true;
    default:
      return false;
  }
}

void read_info(const Json& object, ServerMessage& to) {
  const Json* const metadata = object.find("metadata");
  if (metadata == nullptr || metadata->kind != Json::Kind::object) return;
  for (std::size_t i = 0; i < metadata->items.size(); ++i) {
    if (metadata->items[i].kind == Json::Kind::text)
      to.metadata.emplace_back(metadata->names[i], metadata->items[i].text);
  }
}

bool read_channels(const Json& object, ServerMessage& to) {
  const Json* const list = object.find("channels");
  if (list == nullptr || list->kind != Json::Kind::array) return false;
  for (const Json& each : list->items) {
    auto& channel = to.channels.emplace_back();
    if (!read_whole(each.find("id"), channel.id) || !read_text(each.find("topic"), channel.topic) ||
        !read_text(each.find("encoding"), channel.encoding))
      return false;
  }
  return true;
}

bool read_ids(const Json& object, ServerMessage& to) {
  const Json* const list = object.find("channelIds");
  if (list == nullptr || list->kind != Json::Kind::array) return false;
  for (const Json& each : list->items)
    if (!read_whole(&each, to.ids.emplace_back())) return false;
  return true;
}

/// Little-endian.
template <class T>
T whole_at(std::string_view bytes, std::size_t at) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    value |= static_cast<T>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

}  // namespace

std::string_view ServerMessage::about(std::string_view name) const {
  for (const auto& [known, value] : metadata)
    if (known == name) return value;
  return {};
}

ServerMessage read_server_text(std::string_view text) {
  ServerMessage message;
  const auto object = read_json(text);
  std::string op;
  if (!object || !read_text(object->find("op"), op)) return message;
  if (op == "serverInfo") {
    message.kind = MessageKind::info;
    read_info(*object, message);
  } else if (op == "advertise") {
    if (read_channels(*object, message)) message.kind = MessageKind::advertise;
  } else if (op == "unadvertise") {
    if (read_ids(*object, message)) message.kind = MessageKind::unadvertise;
  } else {
    message.kind = MessageKind::other;
  }
  return message;
}

ServerMessage read_server_bytes(std::string_view bytes) {
  constexpr unsigned char kMessageData = 1;
  constexpr std::size_t kSubscription = 1, kTime = 5, kPayload = 13;
  ServerMessage message;
  if (bytes.empty()) return message;
  if (static_cast<unsigned char>(bytes[0]) != kMessageData) {
    message.kind = MessageKind::other;
    return message;
  }
  if (bytes.size() < kPayload) return message;
  const auto time_ns = whole_at<std::uint64_t>(bytes, kTime);
  if (time_ns > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max() / 2))
    return message;
  message.kind = MessageKind::data;
  message.subscription = whole_at<std::uint32_t>(bytes, kSubscription);
  message.time_ns = static_cast<std::int64_t>(time_ns);
  message.payload = bytes.substr(kPayload);
  return message;
}

bool read_channel_value(std::string_view json, std::size_t most, ChannelValue& to) {
  const auto object = read_json(json);
  if (!object || !read_whole(object->find("episode"), to.episode) ||
      !read_whole(object->find("tick"), to.tick))
    return false;
  const Json* const value = object->find("value");
  if (value == nullptr) return false;
  to.values.clear();
  double element = 0.0;
  if (value->kind != Json::Kind::array) {
    to.elements = 1;
    if (!read_element(*value, element)) return false;
    to.values.push_back(element);
    return true;
  }
  to.elements = value->items.size();
  for (const Json& each : value->items) {
    if (!read_element(each, element)) return false;
    if (to.values.size() < most) to.values.push_back(element);
  }
  return to.elements > 0;
}

bool read_drawing(std::string_view json, std::uint32_t& episode, std::vector<float>& rows) {
  const auto object = read_json(json);
  if (!object || !read_whole(object->find("episode"), episode)) return false;
  const Json* const list = object->find("rows");
  if (list == nullptr || list->kind != Json::Kind::array || list->items.size() % kSceneColumns != 0)
    return false;
  rows.clear();
  double element = 0.0;
  for (const Json& each : list->items) {
    if (!read_element(each, element)) return false;
    rows.push_back(static_cast<float>(element));
  }
  return true;
}

}  // namespace eagerx::foxglove
