#include <runtime/host/dds/dds_sink.hpp>
#include <runtime/host/dds/participant.hpp>
#include <runtime/host/dds/ros_values.hpp>
#include <runtime/host/dds/topics.hpp>

namespace eagerx::dds {
namespace {

using publish::PublishedChannels;
using publish::PublishedMessage;
using publish::PublishedStep;
using publish::PublishSink;

class DdsSink final : public PublishSink {
 public:
  DdsSink(Network to, std::string said, const PublishedChannels& channels, const Graph& graph,
          std::vector<bool> chosen)
      : to_(std::move(to)),
        said_(std::move(said)),
        channels_(channels),
        chosen_(std::move(chosen)),
        topics_(topics_of(graph)),
        reset_topic_(topic_of_environment(graph.name, "reset", "")) {}

  std::string open() override {
    std::vector<std::string> names{kClockTopic, reset_topic_};
    for (const Topic& topic : topics_) names.push_back(topic.name);
    std::string problem = problem_of_names(names);
    if (problem.empty()) problem = participant_.open(to_, false);
    if (problem.empty()) problem = make_writers();
    return problem;
  }
  std::string note() const override {
    const std::string reach = participant_.reach();
    return reach.empty() ? "" : "note: `" + said_ + "` publishes " + reach;
  }

  void message(const PublishedMessage& message) override {
    const Topic& topic = topics_[message.channel];
    switch (topic.form) {
      case Form::number:
        return write_number(message);
      case Form::array:
        return write_array(message);
      case Form::image:
        return write_image(message, topic);
      case Form::imu:
        return write_imu(message, topic);
      case Form::position:
      case Form::velocity:
      case Form::effort:
        return write_joints(message, topic);
    }
  }

  void step(const PublishedStep& step) override {
    const rosgraph_msgs_msg_dds__Clock_ clock{ros::time_of(stamp_of(step.time_ns))};
    write(clock_, clock);
    const std_msgs_msg_dds__UInt32_ episode{step.episode};
    if (step.step == 0) write(reset_, episode);
  }

  const char* unit() const override { return "messages"; }

 private:
  static constexpr const char* kClockTopic = "rt/clock";
  using Dimension = std_msgs_msg_dds__MultiArrayDimension_;
  using Header = std_msgs_msg_dds__Header_;

  template <class F>
  void with_type(std::size_t channel, F&& f) {
    ros::with_dtype(channels_[channel].dtype, f);
  }

  std::string make_writers() {
    std::string problem;
    const auto add = [&](const TopicType& type, const std::string& name, Promise promise) {
      const Entity writer = participant_.writer(type, name, promise);
      if (writer < 0 && problem.empty()) problem = participant_.problem(writer, name);
      return writer;
    };
    clock_ = add(rosgraph_msgs_msg_dds__Clock__desc, kClockTopic, Promise::clock);
    reset_ = add(std_msgs_msg_dds__UInt32__desc, reset_topic_, Promise::event);
    layouts_.resize(channels_.size());
    names_.resize(channels_.size());
    for (std::size_t c = 0; c < channels_.size(); ++c) {
      writers_.push_back(!chosen_[c] ? -1 : add(type_of(c), topics_[c].name, Promise::sensor_data));
      if (topics_[c].form == Form::array) layouts_[c] = dimensions_of(topics_[c].shape);
      if (topics_[c].form >= Form::position) names_[c].make(topics_[c].frame, channels_[c].size);
    }
    return problem;
  }
  const TopicType& type_of(std::size_t channel) {
    switch (topics_[channel].form) {
      case Form::image:
        return sensor_msgs_msg_dds__Image__desc;
      case Form::imu:
        return sensor_msgs_msg_dds__Imu__desc;
      case Form::position:
      case Form::velocity:
      case Form::effort:
        return sensor_msgs_msg_dds__JointState__desc;
      case Form::number:
      case Form::array:
        break;
    }
    const TopicType* type = nullptr;
    with_type(channel,
              [&](auto of) { type = topics_[channel].form == Form::number ? &of.one : &of.many; });
    return *type;
  }
  /// As ROS 2 has it: the stride of a dimension counts all elements of it and of those behind it.
  std::vector<Dimension> dimensions_of(const std::vector<std::uint32_t>& shape) {
    std::vector<Dimension> dimensions(shape.size());
    std::uint32_t stride = 1;
    for (std::size_t d = shape.size(); d-- > 0;) {
      stride *= shape[d];
      dimensions[d] = {nothing_.data(), shape[d], stride};
    }
    return dimensions;
  }

  void write(Entity writer, const void* message) {
    ++(participant_.functions().write(writer, message) < 0 ? dropped_ : sent_);
  }
  template <class Message>
  void write(Entity writer, const Message& message) {
    write(writer, static_cast<const void*>(&message));
  }
  Header header(const PublishedMessage& message, const Topic& topic) const {
    return {ros::time_of(stamp_of(message.time_ns)), const_cast<char*>(topic.frame.c_str())};
  }
  /// The elements of a message as those of `sequence`, valid until the next call.
  template <class Sequence>
  void give_elements(const PublishedMessage& message, Sequence& sequence) {
    using T = std::remove_pointer_t<decltype(sequence._buffer)>;
    const std::size_t size = channels_[message.channel].size;
    room_.resize(size);
    auto* const to = reinterpret_cast<T*>(room_.data());
    for (std::size_t i = 0; i < size; ++i) to[i] = ros::value_of<T>(message.values[i]);
    ros::point(sequence, to, size);
  }
  const std::vector<double>& numbers(const PublishedMessage& message) {
    const auto& channel = channels_[message.channel];
    numbers_.resize(channel.size);
    for (std::size_t i = 0; i < channel.size; ++i)
      numbers_[i] = trace_log::number_of(channel.dtype, message.values[i]);
    return numbers_;
  }

  void write_number(const PublishedMessage& message) {
    with_type(message.channel, [&](auto of) {
      using One = typename decltype(of)::One;
      const One one{ros::value_of<decltype(One::data_)>(message.values[0])};
      write(writers_[message.channel], one);
    });
  }
  void write_array(const PublishedMessage& message) {
    with_type(message.channel, [&](auto of) {
      typename decltype(of)::Many many{};
      auto& layout = layouts_[message.channel];
      ros::point(many.layout_.dim_, layout.data(), layout.size());
      give_elements(message, many.data_);
      write(writers_[message.channel], many);
    });
  }
  void write_image(const PublishedMessage& message, const Topic& topic) {
    sensor_msgs_msg_dds__Image_ image{};
    image.header_ = header(message, topic);
    image.height_ = topic.shape[0];
    image.width_ = topic.shape[1];
    image.encoding_ = const_cast<char*>(encoding_of(topic.shape));
    image.step_ = image.width_ * (topic.shape.size() == 3 ? topic.shape[2] : 1);
    give_elements(message, image.data_);
    write(writers_[message.channel], image);
  }
  /// Ours has the specific force before the angular velocity, and knows no orientation.
  void write_imu(const PublishedMessage& message, const Topic& topic) {
    const std::vector<double>& n = numbers(message);
    sensor_msgs_msg_dds__Imu_ imu{};
    imu.header_ = header(message, topic);
    imu.orientation_covariance_[0] = -1.0;
    imu.linear_acceleration_ = {n[0], n[1], n[2]};
    imu.angular_velocity_ = {n[3], n[4], n[5]};
    write(writers_[message.channel], imu);
  }
  void write_joints(const PublishedMessage& message, const Topic& topic) {
    numbers(message);
    sensor_msgs_msg_dds__JointState_ joints{};
    joints.header_ = header(message, topic);
    names_[message.channel].give(joints.name_);
    ros::point(topic.form == Form::position   ? joints.position_
               : topic.form == Form::velocity ? joints.velocity_
                                              : joints.effort_,
               numbers_.data(), numbers_.size());
    write(writers_[message.channel], joints);
  }

  const Network to_;
  const std::string said_;
  const PublishedChannels& channels_;
  const std::vector<bool> chosen_;
  const std::vector<Topic> topics_;
  const std::string reset_topic_;
  std::string nothing_;
  Participant participant_;
  Entity clock_ = -1, reset_ = -1;
  std::vector<Entity> writers_;                  // of channels
  std::vector<std::vector<Dimension>> layouts_;  // of those that are arrays
  std::vector<ros::Names> names_;                // of those that are joints
  std::vector<std::uint64_t> room_;
  std::vector<double> numbers_;
};

}  // namespace

std::unique_ptr<PublishSink> topic_sink(const Network& to, std::string said,
                                        const PublishedChannels& channels, const Graph& graph,
                                        std::vector<bool> chosen) {
  return std::make_unique<DdsSink>(to, std::move(said), channels, graph, std::move(chosen));
}

}  // namespace eagerx::dds
