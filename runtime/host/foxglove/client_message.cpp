#include <array>
#include <cmath>
#include <runtime/host/base/json_reader.hpp>
#include <runtime/host/foxglove/client_message.hpp>

namespace eagerx::foxglove {
namespace {

using Json = host::JsonValue;
using host::read_json;

using Asked = ClientMessage::Kind;

ClientMessage wrong(std::string problem) {
  ClientMessage message;
  message.problem = std::move(problem);
  return message;
}

/// A whole number below 2^32.
bool read_id(const Json* value, std::uint32_t& id) {
  constexpr double kEnd = 4294967296.0;
  if (value == nullptr || value->kind != Json::Kind::number) return false;
  if (!(value->number >= 0.0 && value->number < kEnd) || value->number != std::floor(value->number))
    return false;
  id = static_cast<std::uint32_t>(value->number);
  return true;
}

const std::vector<Json>* array_of(const Json& object, std::string_view name) {
  const Json* const value = object.find(name);
  return value != nullptr && value->kind == Json::Kind::array ? &value->items : nullptr;
}

bool read_subscriptions(const Json& object, ClientMessage& to) {
  const auto* const list = array_of(object, "subscriptions");
  if (list == nullptr) return false;
  for (const Json& each : *list) {
    auto& subscription = to.subscriptions.emplace_back();
    if (!read_id(each.find("id"), subscription.id) ||
        !read_id(each.find("channelId"), subscription.channel))
      return false;
  }
  return true;
}

bool read_ids(const Json& object, ClientMessage& to) {
  const auto* const list = array_of(object, "subscriptionIds");
  if (list == nullptr) return false;
  for (const Json& each : *list)
    if (!read_id(&each, to.ids.emplace_back())) return false;
  return true;
}

bool read_names(const Json& object, ClientMessage& to) {
  const auto* const list = array_of(object, "parameterNames");
  if (list == nullptr) return false;
  for (const Json& each : *list) {
    if (each.kind != Json::Kind::text) return false;
    to.names.push_back(each.text);
  }
  return true;
}

bool read_number(const Json& value, ClientMessage::Parameter& to) {
  const bool is_flag = value.kind == Json::Kind::boolean;
  if (!is_flag && value.kind != Json::Kind::number) return false;
  to.has_flags = to.has_flags || is_flag;
  to.numbers.push_back(is_flag ? (value.boolean ? 1.0 : 0.0) : value.number);
  return true;
}

void read_value(const Json* value, ClientMessage::Parameter& to) {
  if (value == nullptr || value->kind == Json::Kind::null) return;
  if (value->kind != Json::Kind::array) {
    to.is_wrong = !read_number(*value, to);
    return;
  }
  to.is_wrong = value->items.empty();
  for (const Json& each : value->items) to.is_wrong = to.is_wrong || !read_number(each, to);
}

bool read_parameters(const Json& object, ClientMessage& to) {
  const auto* const list = array_of(object, "parameters");
  if (list == nullptr) return false;
  for (const Json& each : *list) {
    const Json* const name = each.find("name");
    if (name == nullptr || name->kind != Json::Kind::text) return false;
    auto& parameter = to.parameters.emplace_back();
    parameter.name = name->text;
    read_value(each.find("value"), parameter);
  }
  return true;
}

struct Operation {
  std::string_view name;
  Asked kind;
  bool (*read)(const Json& object, ClientMessage& to);
};
constexpr std::array kOperations{
    Operation{"subscribe", Asked::subscribe, read_subscriptions},
    Operation{"unsubscribe", Asked::unsubscribe, read_ids},
    Operation{"getParameters", Asked::get_parameters, read_names},
    Operation{"setParameters", Asked::set_parameters, read_parameters},
    Operation{"subscribeParameterUpdates", Asked::subscribe_parameters, read_names},
    Operation{"unsubscribeParameterUpdates", Asked::unsubscribe_parameters, read_names}};
constexpr std::array<std::string_view, 5> kUnsupported{"advertise", "unadvertise",
                                                       "subscribeConnectionGraph",
                                                       "unsubscribeConnectionGraph", "fetchAsset"};

/// Little-endian; `at` moves behind it.
bool read_u32(std::string_view bytes, std::size_t& at, std::uint32_t& value) {
  if (bytes.size() - at < sizeof(value)) return false;
  value = 0;
  for (unsigned i = 0; i < sizeof(value); ++i)
    value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << 8U * i;
  at += sizeof(value);
  return true;
}

}  // namespace

ClientMessage read_client_text(std::string_view text) {
  const auto object = read_json(text);
  if (!object || object->kind != Json::Kind::object) return wrong("this is not a JSON object");
  const Json* const op = object->find("op");
  if (op == nullptr || op->kind != Json::Kind::text) return wrong("there is no `op`");
  for (const std::string_view name : kUnsupported) {
    if (op->text != name) continue;
    ClientMessage message = wrong("this server has no `" + op->text + "`");
    message.kind = Asked::unsupported;
    return message;
  }
  for (const Operation& operation : kOperations) {
    if (op->text != operation.name) continue;
    ClientMessage message;
    const Json* const id = object->find("id");
    if (id != nullptr && id->kind == Json::Kind::text) message.id = id->text;
    if (!operation.read(*object, message)) return wrong("`" + op->text + "` is incomplete");
    message.kind = operation.kind;
    return message;
  }
  return wrong("the operation is unknown");
}

ClientMessage read_client_bytes(std::string_view bytes) {
  enum Op : unsigned char { kMessageData = 1, kCall = 2 };
  if (bytes.empty()) return wrong("the message is empty");
  const auto op = static_cast<unsigned char>(bytes[0]);
  ClientMessage message;
  if (op == kMessageData) {
    message = wrong("this server takes no messages");
    message.kind = Asked::unsupported;
    return message;
  }
  if (op != kCall) return wrong("the operation is unknown");
  std::size_t at = 1;
  std::uint32_t size = 0;
  if (!read_u32(bytes, at, message.service) || !read_u32(bytes, at, message.call_id) ||
      !read_u32(bytes, at, size) || size > bytes.size() - at)
    return wrong("the call is incomplete");
  message.kind = Asked::call;
  message.encoding = bytes.substr(at, size);
  message.request = bytes.substr(at + size);
  return message;
}

std::uint32_t steps_of_request(std::string_view request) {
  if (request.empty()) return 1;
  const auto object = read_json(request);
  if (!object || object->kind != Json::Kind::object) return 0;
  const Json* const steps = object->find("steps");
  std::uint32_t count = 1;
  return steps == nullptr || read_id(steps, count) ? count : 0;
}

}  // namespace eagerx::foxglove
