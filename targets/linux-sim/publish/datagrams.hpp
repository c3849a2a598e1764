// UDP: one datagram for each step, or a few where a step does not fit into one.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <cstdint>
#include <string>
#include <targets/linux-sim/publish/destination.hpp>
#include <targets/linux-sim/publish/snapshot.hpp>

namespace eagerx::linux_sim {

/// A socket that never waits: what the system does not take is lost, and counted.
class Datagrams {
 public:
  Datagrams() = default;
  Datagrams(const Datagrams&) = delete;
  Datagrams& operator=(const Datagrams&) = delete;
  ~Datagrams();

  /// What is wrong, or empty.
  std::string open(const Destination& destination);
  void send(const std::string& datagram);
  std::uint64_t sent() const { return sent_; }
  std::uint64_t lost() const { return lost_; }

 private:
  int socket_ = -1;
  sockaddr_storage to_{};
  socklen_t to_bytes_ = 0;
  std::uint64_t sent_ = 0, lost_ = 0;
};

/// The most bytes of a datagram: what UDP over IPv4 carries is 65,507.
inline constexpr std::size_t kMostDatagram = 60'000;

/// JSON as PlotJuggler's UDP server reads it: {"timestamp":1.5,"episode":0,"step":45,
/// "pendulum":{"theta":0.1}}. One message of one number is a number, others are arrays; numbers
/// that are not finite are null. https://slides.com/davidefaconti/plotjuggler-data
class JsonDatagrams {
 public:
  /// Calls `send` with each datagram.
  template <class Send>
  void write(const Snapshot& snapshot, Send&& send) {
    begin(snapshot);
    const std::string head = text_;
    for (const LatestMessage& message : snapshot.messages) {
      if (!message.is_there) continue;
      const std::size_t before = text_.size();
      const std::string node = node_;
      add(message);
      if (text_.size() <= kMostDatagram || before == head.size()) continue;
      text_.resize(before);
      node_ = node;
      finish();
      send(text_);
      text_ = head;
      add(message);
    }
    finish();
    send(text_);
  }

 private:
  void begin(const Snapshot& snapshot);
  void add(const LatestMessage& message);
  void finish();

  std::string text_;
  std::string node_;  // whose object is open
};

/// Lines as Teleplot reads them: `pendulum/theta:1500:0.1`, the time in milliseconds; elements of a
/// message of several have their number behind its name. Numbers that are not finite are left out.
/// https://github.com/nesnes/teleplot
class TeleplotLines {
 public:
  template <class Send>
  void write(const Snapshot& snapshot, Send&& send) {
    text_.clear();
    for (const LatestMessage& message : snapshot.messages) {
      if (!message.is_there) continue;
      for (std::size_t i = 0; i < message.size; ++i) {
        add(snapshot, message, i);
        if (text_.size() < kMostLines) continue;
        send(text_);
        text_.clear();
      }
    }
    if (!text_.empty()) send(text_);
  }

 private:
  static constexpr std::size_t kMostLines = 1'400;  // of one frame of Ethernet

  void add(const Snapshot& snapshot, const LatestMessage& message, std::size_t i);

  std::string text_;
};

}  // namespace eagerx::linux_sim
