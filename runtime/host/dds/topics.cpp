#include <runtime/host/dds/topics.hpp>
#include <set>

namespace eagerx::dds {
namespace {

constexpr std::size_t kLongestName = 248;  // of ROS 2, without its `rt`

/// A part of a name as ROS 2 allows it.
void append_part(std::string& to, std::string_view part) {
  to += '/';
  if (part.empty() || (part.front() >= '0' && part.front() <= '9')) to += '_';
  for (const char c : part) {
    const bool is_right = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                          (c >= 'A' && c <= 'Z') || c == '_' || c == '/';
    to += is_right ? c : '_';
  }
}

Form form_of(const Port& of) {
  using trace_log::Dtype;
  const std::string_view port = of.name;
  if (of.shape.empty()) return Form::number;
  if (of.dtype == Dtype::uint8 && encoding_of(of.shape) != nullptr) return Form::image;
  const bool is_real = of.dtype == Dtype::float32 || of.dtype == Dtype::float64;
  if (!of.is_sensor || !is_real || of.shape.size() != 1) return Form::array;
  if (port.ends_with(".imu") && of.shape[0] == 6) return Form::imu;
  if (port.ends_with(".position")) return Form::position;
  if (port.ends_with(".velocity")) return Form::velocity;
  if (port.ends_with(".torque")) return Form::effort;
  return Form::array;
}

}  // namespace

const char* encoding_of(const std::vector<std::uint32_t>& shape) {
  if (shape.size() == 2) return "mono8";
  if (shape.size() != 3) return nullptr;
  return shape[2] == 1 ? "mono8" : shape[2] == 3 ? "rgb8" : shape[2] == 4 ? "rgba8" : nullptr;
}

std::string topic_of_channel(std::string_view graph, std::string_view channel) {
  const std::size_t slash = channel.rfind('/');
  std::string name = "rt";
  append_part(name, graph);
  append_part(name, channel.substr(0, slash));
  name += "/outputs";
  append_part(name, slash == std::string_view::npos ? channel : channel.substr(slash + 1));
  return name;
}
std::string topic_of_environment(std::string_view graph, std::string_view kind,
                                 std::string_view name) {
  std::string topic = "rt";
  append_part(topic, graph);
  topic += "/environment";
  append_part(topic, kind);
  if (!name.empty()) append_part(topic, name);
  return topic;
}

std::vector<Topic> topics_of(const Graph& graph) {
  std::vector<Topic> topics;
  for (const Port& port : graph.ports) {
    Topic& topic = topics.emplace_back();
    topic.name = topic_of_channel(graph.name, port.channel);
    topic.shape = port.shape;
    topic.form = form_of(port);
    topic.frame = port.name.substr(0, port.name.find('.'));
  }
  return topics;
}

std::string problem_of_names(const std::vector<std::string>& names) {
  std::set<std::string_view> seen;
  for (const std::string& name : names) {
    if (name.size() > kLongestName)
      return "error: `" + name + "` is too long for a topic of ROS 2\nhelp: " +
             "give what it is made of shorter names in the graph";
    if (!seen.insert(name).second)
      return "error: two topics of ROS 2 would have the name `" + name +
             "`\nhelp: give one of them another name in the graph";
  }
  return {};
}

}  // namespace eagerx::dds
