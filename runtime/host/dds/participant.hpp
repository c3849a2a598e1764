// The program as a DDS participant.
#pragma once

#include <cstdint>
#include <memory>
#include <runtime/host/dds/library.hpp>
#include <runtime/host/dds/network.hpp>
#include <string>

namespace eagerx::dds {

/// The quality of service of a reader or writer.
enum class Promise : std::uint8_t {
  sensor_data,  // ROS 2's profile of this name: what is lost is lost; the last 5
  clock,        // the same, the last one
  event,        // what is lost is sent again; later readers have the last 5
  exchange      // what is lost is sent again
};

class Participant {
 public:
  Participant() = default;
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  ~Participant();

  /// Empty, or the problem. With `alone`, ignores the user's CYCLONEDDS_URI, and accepts nothing
  /// from other machines.
  std::string open(const Network& network, bool alone);
  /// The network within reach, if readers can be beyond this machine; otherwise empty.
  std::string reach() const { return reach_; }

  const Functions& functions() const { return *functions_; }
  Entity id() const { return id_; }
  /// Below 0 after an error; see problem().
  Entity writer(const TopicType& type, const std::string& topic, Promise promise);
  Entity reader(const TopicType& type, const std::string& topic, Promise promise);
  std::string problem(Entity error, const std::string& topic) const;

 private:
  struct Domain;

  std::string join(const Network& network, const std::string& config);
  template <class Make>
  Entity endpoint(const TopicType& type, const std::string& topic, Promise promise, Make make);

  const Functions* functions_ = nullptr;
  std::shared_ptr<Domain> domain_;
  Entity id_ = -1;
  std::string reach_;
};

}  // namespace eagerx::dds
