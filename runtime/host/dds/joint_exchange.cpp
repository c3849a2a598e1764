#include <algorithm>
#include <cstring>
#include <runtime/host/dds/joint_exchange.hpp>
#include <runtime/host/dds/participant.hpp>
#include <runtime/host/dds/ros_values.hpp>

namespace eagerx::dds {
namespace {

using JointState = sensor_msgs_msg_dds__JointState_;
constexpr const TopicType& kJointState = sensor_msgs_msg_dds__JointState__desc;

class CycloneExchange final : public JointExchange {
 public:
  std::string open(std::uint32_t domain, const std::vector<std::string>& inputs,
                   const std::vector<Output>& outputs) override {
    std::string problem = participant_.open({domain, ""}, true);
    if (!problem.empty()) return problem;
    const Functions& f = functions();
    waitset_ = f.create_waitset(participant_.id());
    publications_ =
        f.create_reader(participant_.id(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr);
    inputs_ = inputs;
    for (const std::string& topic : inputs) {
      readers_.push_back(participant_.reader(kJointState, topic, Promise::exchange));
      if (readers_.back() < 0) return participant_.problem(readers_.back(), topic);
      const Entity unread = f.create_readcondition(
          readers_.back(), DDS_NOT_READ_SAMPLE_STATE | DDS_ANY_VIEW_STATE | DDS_ANY_INSTANCE_STATE);
      f.waitset_attach(waitset_, unread, 0);
    }
    names_.resize(outputs.size());
    for (std::size_t o = 0; o < outputs.size(); ++o) {
      const std::string& topic = outputs[o].topic;
      writers_.push_back(participant_.writer(kJointState, topic, Promise::exchange));
      if (writers_.back() < 0) return participant_.problem(writers_.back(), topic);
      names_[o].make(outputs[o].name, outputs[o].size);
      sizes_.push_back(outputs[o].size);
    }
    return {};
  }

  bool is_there() const override {
    const Functions& f = functions();
    const bool is_written = std::all_of(readers_.begin(), readers_.end(), [&](Entity reader) {
      dds_subscription_matched_status_t matched{};
      f.get_subscription_matched_status(reader, &matched);
      return matched.current_count > 0;
    });
    return is_written &&
           (writers_.empty() || std::any_of(writers_.begin(), writers_.end(), [&](Entity writer) {
              dds_publication_matched_status_t matched{};
              f.get_publication_matched_status(writer, &matched);
              return matched.current_count > 0;
            }));
  }

  bool write(std::size_t output, Stamp time, std::string& frame,
             std::span<double> positions) override {
    JointState out{};
    out.header_ = {ros::time_of(time), frame.data()};
    // Names are those of one message: all arrays have as many elements, or none.
    if (positions.size() == sizes_[output]) names_[output].give(out.name_);
    ros::point(out.position_, positions.data(), positions.size());
    return functions().write(writers_[output], &out) >= 0;
  }

  void read(std::size_t input, const Take& take) override {
    constexpr std::uint32_t kAtOnce = 16;
    void* messages[kAtOnce] = {};
    dds_sample_info_t infos[kAtOnce];
    const std::int32_t count = functions().take(readers_[input], messages, infos, kAtOnce, kAtOnce);
    for (std::int32_t i = 0; i < count; ++i) {
      if (!infos[i].valid_data) continue;
      const auto& message = *static_cast<const JointState*>(messages[i]);
      const auto& time = message.header_.stamp_;
      take({time.sec_, time.nanosec_}, {message.position_._buffer, message.position_._length});
    }
    if (count > 0) functions().return_loan(readers_[input], messages, count);
  }

  void wait(std::int64_t most_ns) override {
    functions().waitset_wait(waitset_, nullptr, 0, most_ns);
  }

  std::vector<std::string> strangers() override {
    std::vector<std::string> found;
    if (publications_ < 0) return found;
    void* message[1] = {};
    dds_sample_info_t info;
    while (functions().take(publications_, message, &info, 1, 1) == 1) {
      const auto& writer = *static_cast<const dds_builtintopic_endpoint_t*>(message[0]);
      if (info.valid_data && std::ranges::find(inputs_, writer.topic_name) != inputs_.end() &&
          std::strcmp(writer.type_name, kJointState.m_typename) != 0)
        found.emplace_back(writer.topic_name);
      functions().return_loan(publications_, message, 1);
      message[0] = nullptr;
    }
    return found;
  }

 private:
  const Functions& functions() const { return participant_.functions(); }

  Participant participant_;
  Entity waitset_ = -1, publications_ = -1;
  std::vector<std::string> inputs_;
  std::vector<Entity> readers_, writers_;
  std::vector<ros::Names> names_;   // of outputs
  std::vector<std::size_t> sizes_;  // of outputs
};

}  // namespace

std::unique_ptr<JointExchange> joint_exchange() {
  return std::make_unique<CycloneExchange>();
}

}  // namespace eagerx::dds
