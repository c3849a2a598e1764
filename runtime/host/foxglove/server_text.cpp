#include <array>
#include <eagerx/scene.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/foxglove/scene_update.hpp>
#include <runtime/host/foxglove/server_text.hpp>
#include <runtime/host/trace/json_text.hpp>

namespace eagerx::foxglove {
namespace {

/// An operation, without its end.
host::Json operation(const char* name) {
  host::Json json(host::Json::Style::compact);
  json.begin_object().key("op").text(name);
  return json;
}

void add_schema(host::Json& json, std::string_view name, std::string_view schema) {
  json.key("schemaName").text(name);
  json.key("schemaEncoding").text("jsonschema").key("schema").text(schema);
}

void add_channel(host::Json& json, std::size_t id, const std::string& topic,
                 std::string_view schema_name, const std::string& schema) {
  json.begin_object().key("id").whole(id).key("topic").text(topic).key("encoding").text("json");
  add_schema(json, schema_name, schema);
  json.end_object();
}

/// Of a request or a response.
void add_message(host::Json& json, const char* what, std::string_view name,
                 std::string_view schema) {
  json.key(what).begin_object().key("encoding").text("json");
  add_schema(json, name, schema);
  json.end_object();
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
  host::Json json(host::Json::Style::compact);
  json.begin_object().key("episode").whole(episode).key("rows").begin_list();
  for (std::size_t i = 0; i < count * kSceneColumns; ++i) json.number(rows[i]);
  return json.end_list().end_object().str();
}

std::string server_info_text(std::string_view name, bool has_services, std::string_view session,
                             const std::vector<std::pair<std::string, std::string>>& about) {
  host::Json json = operation("serverInfo");
  json.key("name").text(name).key("capabilities").begin_list();
  json.text("time").text("parameters").text("parametersSubscribe");
  if (has_services) json.text("services");
  json.end_list().key("supportedEncodings").begin_list().text("json").end_list();
  json.key("metadata").begin_object();
  for (const auto& [key, value] : about) json.key(key).text(value);
  return json.end_object().key("sessionId").text(session).end_object().str();
}

std::string advertise_text(const publish::PublishedChannels& channels,
                           const std::vector<bool>& chosen, const std::vector<Topic>& topics) {
  host::Json json = operation("advertise");
  json.key("channels").begin_list();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto& channel = channels[c];
    if (chosen[c])
      add_channel(json, c + 1, "/" + channel.name, channel.name, trace_log::json_schema(channel));
  }
  std::size_t id = channels.size();
  for (const Topic& topic : topics)
    add_channel(json, ++id, topic.name, topic.schema_name, topic.schema);
  return json.end_list().end_object().str();
}

std::string advertise_services_text() {
  constexpr std::array<std::string_view, kServices> kNames{"reset", "pause", "resume", "step"};
  constexpr std::string_view kNothing = R"({"type":"object","properties":{}})";
  constexpr std::string_view kSteps =
      R"({"type":"object","properties":{"steps":{"type":"integer","minimum":1}}})";
  constexpr std::string_view kPlace =
      R"({"type":"object","properties":{"episode":{"type":"integer"},"step":{"type":"integer"}}})";
  host::Json json = operation("advertiseServices");
  json.key("services").begin_list();
  for (std::uint32_t i = 0; i < kServices; ++i) {
    const std::string name(kNames[i]);
    json.begin_object().key("id").whole(i + 1).key("name").text("/" + name);
    json.key("type").text("eagerx/" + name);
    add_message(json, "request", "eagerx/" + name + "_request", name == "step" ? kSteps : kNothing);
    add_message(json, "response", "eagerx/place", kPlace);
    json.end_object();
  }
  return json.end_list().end_object().str();
}

std::string parameter_values_text(const std::vector<ParameterValue>& parameters,
                                  std::string_view id) {
  host::Json json = operation("parameterValues");
  json.key("parameters").begin_list();
  for (const ParameterValue& parameter : parameters) {
    json.begin_object().key("name").text(parameter.name);
    if (!parameter.numbers.empty()) {
      json.key("type").text(parameter.is_array ? "float64_array" : "float64").key("value");
      if (parameter.is_array) json.begin_list();
      for (const double value : parameter.numbers)
        parameter.is_float32 ? json.number(static_cast<float>(value)) : json.number(value);
      if (parameter.is_array) json.end_list();
    }
    json.end_object();
  }
  json.end_list();
  if (!id.empty()) json.key("id").text(id);
  return json.end_object().str();
}

std::string status_text(StatusLevel level, std::string_view message) {
  host::Json json = operation("status");
  json.key("level").whole(static_cast<std::uint64_t>(level));
  return json.key("message").text(message).end_object().str();
}

std::string call_failure_text(std::uint32_t service, std::uint32_t call, std::string_view message) {
  host::Json json = operation("serviceCallFailure");
  json.key("serviceId").whole(service).key("callId").whole(call);
  return json.key("message").text(message).end_object().str();
}

}  // namespace eagerx::foxglove
