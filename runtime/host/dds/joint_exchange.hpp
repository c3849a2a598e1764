// Exchanges sensor_msgs/JointState messages with other programs on this machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <runtime/host/dds/stamp.hpp>
#include <span>
#include <string>
#include <vector>

namespace eagerx::dds {

class JointExchange {
 public:
  struct Output {
    std::string topic;
    std::string name;      // its elements are NAME_0, NAME_1 …
    std::size_t size = 0;  // of one message
  };
  /// The time of a message, and its positions; valid during the call.
  using Take = std::function<void(Stamp time, std::span<const double> positions)>;

  virtual ~JointExchange() = default;
  /// Joins `domain`, without accepting messages from other machines. `inputs`: topics to read.
  /// Empty, or the problem.
  virtual std::string open(std::uint32_t domain, const std::vector<std::string>& inputs,
                           const std::vector<Output>& outputs) = 0;
  /// Whether each input has a writer, and an output a reader.
  virtual bool is_there() const = 0;
  /// `positions`: [n · size] of output `output`, which has names if n is 1. False if there is no
  /// room for the message while earlier ones are in flight.
  virtual bool write(std::size_t output, Stamp time, std::string& frame,
                     std::span<double> positions) = 0;
  /// Calls `take` for messages that have come.
  virtual void read(std::size_t input, const Take& take) = 0;
  /// Until a message comes, or for `most_ns`.
  virtual void wait(std::int64_t most_ns) = 0;
  /// Inputs with a writer of another type since the last call, which DDS does not connect.
  virtual std::vector<std::string> strangers() = 0;
};

/// In a program built without Cyclone DDS, open() reports that.
std::unique_ptr<JointExchange> joint_exchange();

}  // namespace eagerx::dds
