// Messages of a graph in ROS 2: names of topics, and types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::dds {

/// The type of a topic; README.md of targets/linux-sim says when it is which.
enum class Form : std::uint8_t {
  number,    // std_msgs/Float32 and the like
  array,     // std_msgs/Float32MultiArray and the like
  image,     // sensor_msgs/Image
  imu,       // sensor_msgs/Imu
  position,  // sensor_msgs/JointState with this
  velocity,
  effort
};

struct Topic {
  std::string name;  // with the `rt/` that ROS 2 puts before it
  Form form = Form::number;
  std::vector<std::uint32_t> shape;
  std::string frame;  // the object, of those with a header
};

/// The description of a channel, without its messages.
struct Port {
  std::string channel;
  std::string name;  // as graphs call it: "smooth.filtered", "pendulum.theta", "actions.u"
  trace_log::Dtype dtype = trace_log::Dtype::float32;
  std::vector<std::uint32_t> shape;  // none: one number
  bool is_sensor = false;
};
struct Graph {
  std::string name;
  std::vector<Port> ports;  // [channels]
};

/// `rt/ENV/NODE/outputs/X`: EAGERx's name.
std::string topic_of_channel(std::string_view graph, std::string_view channel);
/// `rt/ENV/environment/KIND/X`
std::string topic_of_environment(std::string_view graph, std::string_view kind,
                                 std::string_view name);

/// Those of all channels, in their order.
std::vector<Topic> topics_of(const Graph& graph);
/// Empty, or the problem of their names.
std::string problem_of_names(const std::vector<std::string>& names);

/// "rgb8" of [height, width, 3], "mono8" of [height, width]; null: no image.
const char* encoding_of(const std::vector<std::uint32_t>& shape);

}  // namespace eagerx::dds
