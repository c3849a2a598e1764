// Messages of a run, sent while it goes on: `--publish`.
#pragma once

#include <atomic>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <memory>
#include <string>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/message_view.hpp>
#include <targets/linux-sim/publish/message_ring.hpp>
#include <targets/linux-sim/publish/snapshot.hpp>
#include <thread>
#include <vector>

namespace eagerx::linux_sim {

struct Options;
struct Summary;
class Sink;

/// The loop puts messages into a ring; a thread takes them out and sends them. The loop never
/// waits, allocates or calls the system: what does not fit into the ring is dropped and counted.
class LivePublisher {
 public:
  LivePublisher();
  LivePublisher(const LivePublisher&) = delete;
  LivePublisher& operator=(const LivePublisher&) = delete;
  ~LivePublisher();

  /// What is wrong with `--publish` and what belongs to it, or empty. Opens nothing.
  static std::string problem_of(const Options& options, const GraphFacts& facts);
  /// Opens what `--publish` names, and begins. What is wrong, or empty.
  std::string open(const Options& options, const GraphFacts& facts);
  bool is_open() const { return ring_ != nullptr; }

  /// For the loop.
  void message(std::uint32_t channel, Seq seq, MessageView message) {
    const std::size_t bytes = bytes_[channel];
    if (bytes > 0) ring_->push(channel, seq, message.data, bytes);
  }
  void episode(std::uint32_t episode) { ring_->push(kEpisode, episode, nullptr, 0); }
  void step(Seq step) { ring_->push(kStep, step, nullptr, 0); }

  /// Sends what is left, and tells what there was.
  void close(Summary& summary);

 private:
  static constexpr std::uint32_t kStep = 0xffff'ffff, kEpisode = 0xffff'fffe;

  void choose(const std::vector<std::string>& only);
  void send_all();
  void take(const MessageRing::Head& head, const std::byte* message);
  void end_step(std::uint64_t step);

  const GraphFacts* facts_ = nullptr;
  std::unique_ptr<MessageRing> ring_;
  std::vector<std::size_t> bytes_;  // [channels] of a message; 0: it is not published
  std::vector<std::size_t> place_;  // [channels] in snapshot_.messages
  Snapshot snapshot_;
  double episode_begins_s_ = 0.0, next_s_ = 0.0, interval_s_ = 0.0;
  std::vector<std::unique_ptr<Sink>> sinks_;
  std::atomic<bool> is_over_{false};
  std::thread sender_;
};

}  // namespace eagerx::linux_sim
