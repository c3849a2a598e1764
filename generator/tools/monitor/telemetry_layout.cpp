#include "generator/tools/monitor/telemetry_layout.hpp"

#include <charconv>
#include <limits>

#include "generator/support/json/json.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kFormat = "eagerx telemetry 1";

/// All of a text as a number.
template <class T>
std::optional<T> number_in(std::string_view text, int base = 10) {
  T value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A whole number of JSON from 0 to `most`.
template <class T>
bool read_whole(const Json* value, T& into) {
  const auto* whole = value != nullptr ? value->as<std::int64_t>() : nullptr;
  if (whole == nullptr || *whole < 0 ||
      static_cast<std::uint64_t>(*whole) > std::numeric_limits<T>::max())
    return false;
  into = static_cast<T>(*whole);
  return true;
}

/// "125/4"
bool read_rate(const std::string& text, telemetry::Group& group) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return false;
  const auto num = number_in<std::uint64_t>(std::string_view(text).substr(0, slash));
  const auto den = number_in<std::uint64_t>(std::string_view(text).substr(slash + 1));
  group.rate_num = num.value_or(0);
  group.rate_den = den.value_or(0);
  return num && den;
}

bool read_channel(const Json& json, telemetry::Channel& channel) {
  channel.name = text_of(member(&json, "name"));
  channel.port = text_of(member(&json, "port"));
  const auto dtype = trace_log::dtype_of(text_of(member(&json, "dtype")));
  const auto shape = integers_of(member(&json, "shape"));
  if (!dtype || !shape || !read_whole(member(&json, "offset"), channel.offset)) return false;
  channel.dtype = *dtype;
  channel.size = 1;
  for (const std::int64_t length : *shape) {
    channel.shape.push_back(static_cast<std::uint64_t>(length));
    channel.size *= static_cast<std::uint64_t>(length);
  }
  return true;
}

bool read_group(const Json& json, telemetry::Group& group) {
  if (!read_rate(text_of(member(&json, "rate")), group) ||
      !read_whole(member(&json, "every"), group.every) ||
      !read_whole(member(&json, "bytes"), group.bytes))
    return false;
  const Json* channels = member(&json, "channels");
  const auto* list = channels != nullptr ? channels->as<Json::List>() : nullptr;
  if (list == nullptr) return false;
  for (const Json& channel : *list) {
    if (!read_channel(channel, group.channels.emplace_back())) return false;
  }
  return true;
}

bool read_runtime(const std::string& text, std::uint16_t& runtime) {
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos) return false;
  const auto major = number_in<std::uint8_t>(std::string_view(text).substr(0, dot));
  const auto minor = number_in<std::uint8_t>(std::string_view(text).substr(dot + 1));
  runtime = static_cast<std::uint16_t>(major.value_or(0) * 256 + minor.value_or(0));
  return major && minor;
}

bool read_members(const Json& json, telemetry::Layout& layout) {
  layout.graph = text_of(member(&json, "graph"));
  const std::string hash = text_of(member(&json, "hash"));
  const auto number = hash.starts_with("0x")
                          ? number_in<std::uint64_t>(std::string_view(hash).substr(2), 16)
                          : std::nullopt;
  layout.hash = number.value_or(0);
  if (!number || !read_runtime(text_of(member(&json, "runtime")), layout.runtime) ||
      !read_whole(member(&json, "baud"), layout.baud))
    return false;
  const Json* groups = member(&json, "groups");
  const auto* list = groups != nullptr ? groups->as<Json::List>() : nullptr;
  if (list == nullptr) return false;
  for (const Json& group : *list) {
    if (!read_group(group, layout.groups.emplace_back())) return false;
  }
  return true;
}

}  // namespace

std::optional<telemetry::Layout> read_telemetry_layout(std::string_view text,
                                                       std::string& problem) {
  const auto json = parse_json(text);
  if (!json || text_of(member(&*json, "format")) != kFormat) {
    problem = "no layout of telemetry: it does not begin with `\"format\": \"eagerx telemetry 1\"`";
    return std::nullopt;
  }
  telemetry::Layout layout;
  if (!read_members(*json, layout)) {
    problem = "a member is missing, or is not what it should be";
    return std::nullopt;
  }
  problem = telemetry::problem_with(layout);
  if (!problem.empty()) return std::nullopt;
  return layout;
}

}  // namespace eagerx::gen
