// Text messages of a server in Foxglove's WebSocket protocol.
#pragma once

#include <cstdint>
#include <runtime/host/publish/sink.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::foxglove {

inline constexpr std::string_view kFoxgloveProtocol = "foxglove.websocket.v1";

enum class Service : std::uint8_t { none, reset, pause, resume, step };
inline constexpr std::uint32_t kServices = 4;  // from 1

/// The current value of a parameter; without numbers it has no value.
struct ParameterValue {
  std::string name;
  bool is_array = false;
  bool is_float32 = false;  // has fewer digits
  std::vector<double> numbers;
};

/// Messages in JSON that are not a channel of the graph.
struct Topic {
  std::string name, schema_name;
  std::string schema;  // JSON Schema
};
/// The drawing for Foxglove's 3D panel, and its numbers as `eagerx/scene.hpp` has them.
Topic scene_topic();
Topic drawing_topic();

/// `about`: names and values.
std::string server_info_text(std::string_view name, bool has_services, std::string_view session,
                             const std::vector<std::pair<std::string, std::string>>& about);
/// Channel `c` has number c + 1; topics follow the channels.
std::string advertise_text(const publish::PublishedChannels& channels,
                           const std::vector<bool>& chosen, const std::vector<Topic>& topics);
/// A message of drawing_topic(): `rows` is [count][kSceneColumns].
std::string drawing_text(const float* rows, std::size_t count, std::uint32_t episode);
std::string advertise_services_text();
std::string parameter_values_text(const std::vector<ParameterValue>& parameters,
                                  std::string_view id);
enum class StatusLevel : std::uint8_t { info, warning, error };
std::string status_text(StatusLevel level, std::string_view message);
std::string call_failure_text(std::uint32_t service, std::uint32_t call, std::string_view message);

}  // namespace eagerx::foxglove
