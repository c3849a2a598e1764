// Another process with another maker's DDS, with its default settings:
//   stranger read DOMAIN TYPE=TOPIC...                  counts messages until its standard input
//   ends stranger agent DOMAIN OBSERVATION ACTION FILE       answers each observation with a row of
//   FILE
#include <poll.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "messagesPubSubTypes.h"

using namespace eprosima::fastdds::dds;
using sensor_msgs::msg::dds_::JointState_;

namespace {

bool ended() {
  pollfd in{0, POLLIN, 0};
  return poll(&in, 1, 1) > 0;
}

template <class Endpoint>
Endpoint checked(Endpoint endpoint, const std::string& what) {
  if (endpoint != nullptr) return endpoint;
  std::fprintf(stderr, "stranger: no %s\n", what.c_str());
  std::exit(1);
}

template <class Qos>
Qos quality(Qos qos, bool reliable) {
  qos.reliability().kind = reliable ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = 1000;
  qos.endpoint().history_memory_policy =
      eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  return qos;
}

class Stranger {
 public:
  explicit Stranger(std::uint32_t domain)
      : me_(checked(DomainParticipantFactory::get_instance()->create_participant(
                        domain, PARTICIPANT_QOS_DEFAULT),
                    "participant")) {}
  ~Stranger() {
    me_->delete_contained_entities();
    DomainParticipantFactory::get_instance()->delete_participant(me_);
  }

  DataReader* reader(TopicDataType* type, const std::string& topic, bool reliable) {
    Subscriber* const subscriber =
        checked(me_->create_subscriber(SUBSCRIBER_QOS_DEFAULT), "subscriber");
    return checked(
        subscriber->create_datareader(make(type, topic),
                                      quality(subscriber->get_default_datareader_qos(), reliable)),
        topic);
  }
  DataWriter* writer(TopicDataType* type, const std::string& topic) {
    Publisher* const publisher = checked(me_->create_publisher(PUBLISHER_QOS_DEFAULT), "publisher");
    return checked(publisher->create_datawriter(
                       make(type, topic), quality(publisher->get_default_datawriter_qos(), true)),
                   topic);
  }

 private:
  Topic* make(TopicDataType* type, const std::string& topic) {
    TypeSupport support(type);
    support.register_type(me_);
    return checked(me_->create_topic(topic, support.get_type_name(), TOPIC_QOS_DEFAULT), topic);
  }
  DomainParticipant* me_;
};

/// Reads one topic.
struct Listener {
  virtual ~Listener() = default;
  virtual bool take() = 0;
  virtual void tell() const = 0;
};
template <class PubSubType>
class TypedListener final : public Listener {
 public:
  TypedListener(Stranger& stranger, std::string topic)
      : topic_(std::move(topic)), reader_(stranger.reader(new PubSubType(), topic_, false)) {}
  bool take() override {
    SampleInfo info;
    if (reader_->take_next_sample(&message_, &info) != ReturnCode_t::RETCODE_OK) return false;
    count_ += info.valid_data ? 1 : 0;
    return true;
  }
  void tell() const override { std::printf("%s %d\n", topic_.c_str(), count_); }

 private:
  std::string topic_;
  DataReader* reader_;
  typename PubSubType::type message_;
  int count_ = 0;
};

std::unique_ptr<Listener> listener(Stranger& stranger, const std::string& type,
                                   const std::string& topic) {
  using namespace std_msgs::msg::dds_;
  using namespace sensor_msgs::msg::dds_;
  if (type == "Float32")
    return std::make_unique<TypedListener<Float32_PubSubType>>(stranger, topic);
  if (type == "Int64") return std::make_unique<TypedListener<Int64_PubSubType>>(stranger, topic);
  if (type == "Float32MultiArray")
    return std::make_unique<TypedListener<Float32MultiArray_PubSubType>>(stranger, topic);
  if (type == "Image") return std::make_unique<TypedListener<Image_PubSubType>>(stranger, topic);
  if (type == "Imu") return std::make_unique<TypedListener<Imu_PubSubType>>(stranger, topic);
  if (type == "JointState")
    return std::make_unique<TypedListener<JointState_PubSubType>>(stranger, topic);
  return std::make_unique<TypedListener<rosgraph_msgs::msg::dds_::Clock_PubSubType>>(stranger,
                                                                                     topic);
}

int read_topics(Stranger& stranger, const std::vector<std::string>& topics) {
  std::vector<std::unique_ptr<Listener>> listeners;
  for (const std::string& each : topics) {
    const std::size_t equals = each.find('=');
    listeners.push_back(listener(stranger, each.substr(0, equals), each.substr(equals + 1)));
  }
  std::puts("ready");
  std::fflush(stdout);
  for (int quiet = 0; quiet < 200; ++quiet) {
    if (!ended()) quiet = 0;
    for (const auto& each : listeners)
      while (each->take()) quiet = 0;
    if (quiet > 0) poll(nullptr, 0, 1);
  }
  for (const auto& each : listeners) each->tell();
  return 0;
}

std::vector<std::vector<double>> rows_of(const std::string& path) {
  std::vector<std::vector<double>> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      rows.back().push_back(std::strtod(cell.c_str(), nullptr));
  }
  return rows;
}

int be_agent(Stranger& stranger, const std::string& observation, const std::string& action,
             const std::string& path) {
  using Type = sensor_msgs::msg::dds_::JointState_PubSubType;
  const auto rows = rows_of(path);
  DataWriter* const writer = stranger.writer(new Type(), action);
  DataReader* const reader = stranger.reader(new Type(), observation, true);
  std::puts("ready");
  std::fflush(stdout);
  JointState_ seen, answer;
  while (!ended()) {
    while (reader->wait_for_unread_message({0, 100'000'000})) {
      SampleInfo info;
      if (reader->take_next_sample(&seen, &info) != ReturnCode_t::RETCODE_OK || !info.valid_data)
        continue;
      const std::string& frame = seen.header_().frame_id_();
      answer.header_() = seen.header_();
      answer.position_() = rows.at(std::stoul(frame.substr(frame.find('/') + 1)));
      writer->write(&answer);
    }
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> given(arguments + 1, arguments + count);
  if (given.size() < 3) return 2;
  Stranger stranger(static_cast<std::uint32_t>(std::stoul(given[1])));
  if (given[0] == "read") return read_topics(stranger, {given.begin() + 2, given.end()});
  return given.size() == 5 ? be_agent(stranger, given[2], given[3], given[4]) : 2;
}
