// What the messages of a graph are in ROS 2: names of topics, and types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <targets/linux-sim/graph_program.hpp>
#include <vector>

namespace eagerx::linux_sim::dds {

/// The type of a topic; README.md of linux-sim says when it is which.
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

/// `rt/ENV/NODE/outputs/X`: EAGERx's name.
std::string topic_of_channel(std::string_view graph, std::string_view channel);
/// `rt/ENV/environment/KIND/X`
std::string topic_of_environment(std::string_view graph, std::string_view kind,
                                 std::string_view name);

/// Those of all channels, in their order.
std::vector<Topic> topics_of(const GraphFacts& facts);
/// Empty, or what is wrong with their names.
std::string problem_of_names(const std::vector<std::string>& names);

/// "rgb8" of [height, width, 3], "mono8" of [height, width]; null: no image.
const char* encoding_of(const std::vector<std::uint32_t>& shape);

}  // namespace eagerx::linux_sim::dds
