#include <array>
#include <charconv>
#include <cmath>
#include <eagerx/scene.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/foxglove/scene_update.hpp>
#include <runtime/host/foxglove/server_text.hpp>
#include <runtime/host/trace/json_text.hpp>

namespace eagerx::foxglove {
namespace {

std::string json(std::string_view text) {
  std::string result;
  host::append_json_string(result, text);
  return result;
}

template <class T>
void append_json_number(std::string& to, T value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  if (std::isfinite(value)) {
    to.append(text.data(), result.ptr);
  } else {
    to += "null";
  }
}

std::string channel_text(std::size_t id, const std::string& topic, std::string_view schema_name,
                         const std::string& schema) {
  return "{\"id\":" + std::to_string(id) + ",\"topic\":" + json(topic) +
         R"(,"encoding":"json","schemaName":)" + json(schema_name) +
         R"(,"schemaEncoding":"jsonschema","schema":)" + json(schema) + "}";
}

std::string schema_text(std::string_view name, std::string_view schema) {
  return R"({"encoding":"json","schemaName":)" + json(name) +
         R"(,"schemaEncoding":"jsonschema","schema":)" + json(schema) + "}";
}

}  // namespace

Topic scene_topic() {
  return {"/scene", "foxglove.SceneUpdate", scene_update_schema()};
}

Topic drawing_topic() {
  return {"/drawing", "eagerx.Drawing",
          R"({"type":"object","properties":{"episode":{"type":"integer"},)"
          R"("rows":{"type":"array","items":{"type":["number","null"]}}}})"};
}

std::string drawing_text(const float* rows, std::size_t count, std::uint32_t episode) {
  std::string text = "{\"episode\":" + std::to_string(episode) + ",\"rows\":[";
  for (std::size_t i = 0; i < count * kSceneColumns; ++i) {
    if (i > 0) text += ',';
    append_json_number(text, rows[i]);
  }
  return text + "]}";
}

std::string server_info_text(std::string_view name, bool has_services, std::string_view session,
                             const std::vector<std::pair<std::string, std::string>>& about) {
  std::string text = R"({"op":"serverInfo","name":)" + json(name) +
                     R"(,"capabilities":["time","parameters","parametersSubscribe")" +
                     (has_services ? R"(,"services"])" : "]") +
                     R"(,"supportedEncodings":["json"],"metadata":{)";
  for (const auto& [key, value] : about)
    text += (text.back() == '{' ? "" : ",") + json(key) + ":" + json(value);
  return text + "},\"sessionId\":" + json(session) + "}";
}

std::string advertise_text(const publish::PublishedChannels& channels,
                           const std::vector<bool>& chosen, const std::vector<Topic>& topics) {
  std::string text = R"({"op":"advertise","channels":[)";
  for (std::size_t c = 0; c < channels.size(); ++c) {
    if (!chosen[c]) continue;
    const auto& channel = channels[c];
    if (text.back() != '[') text += ',';
    text += channel_text(c + 1, "/" + channel.name, channel.name, trace_log::json_schema(channel));
  }
  std::size_t id = channels.size();
  for (const Topic& topic : topics) {
    if (text.back() != '[') text += ',';
    text += channel_text(++id, topic.name, topic.schema_name, topic.schema);
  }
  return text + "]}";
}

std::string advertise_services_text() {
  constexpr std::array<std::string_view, kServices> kNames{"reset", "pause", "resume", "step"};
  constexpr std::string_view kNothing = R"({"type":"object","properties":{}})";
  constexpr std::string_view kSteps =
      R"({"type":"object","properties":{"steps":{"type":"integer","minimum":1}}})";
  constexpr std::string_view kPlace =
      R"({"type":"object","properties":{"episode":{"type":"integer"},"step":{"type":"integer"}}})";
  std::string text = R"({"op":"advertiseServices","services":[)";
  for (std::uint32_t i = 0; i < kServices; ++i) {
    const std::string name(kNames[i]);
    if (i > 0) text += ',';
    text += "{\"id\":" + std::to_string(i + 1) + ",\"name\":" + json("/" + name) +
            ",\"type\":" + json("eagerx/" + name) + ",\"request\":" +
            schema_text("eagerx/" + name + "_request", name == "step" ? kSteps : kNothing) +
            ",\"response\":" + schema_text("eagerx/place", kPlace) + "}";
  }
  return text + "]}";
}

std::string parameter_values_text(const std::vector<ParameterValue>& parameters,
                                  std::string_view id) {
  std::string text = R"({"op":"parameterValues","parameters":[)";
  for (const ParameterValue& parameter : parameters) {
    if (text.back() != '[') text += ',';
    text += "{\"name\":" + json(parameter.name);
    if (!parameter.numbers.empty()) {
      text += parameter.is_array ? R"(,"type":"float64_array","value":[)"
                                 : R"(,"type":"float64","value":)";
      for (std::size_t i = 0; i < parameter.numbers.size(); ++i) {
        if (i > 0) text += ',';
        const double value = parameter.numbers[i];
        parameter.is_float32 ? append_json_number(text, static_cast<float>(value))
                             : append_json_number(text, value);
      }
      if (parameter.is_array) text += ']';
    }
    text += '}';
  }
  text += ']';
  if (!id.empty()) text += ",\"id\":" + json(id);
  return text + "}";
}

std::string status_text(StatusLevel level, std::string_view message) {
  return R"({"op":"status","level":)" + std::to_string(static_cast<int>(level)) +
         ",\"message\":" + json(message) + "}";
}

std::string call_failure_text(std::uint32_t service, std::uint32_t call, std::string_view message) {
  return R"({"op":"serviceCallFailure","serviceId":)" + std::to_string(service) +
         ",\"callId\":" + std::to_string(call) + ",\"message\":" + json(message) + "}";
}

}  // namespace eagerx::foxglove
