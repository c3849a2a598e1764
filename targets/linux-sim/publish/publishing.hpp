// --publish: messages of a run for other programs, while it runs.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <eagerx/scene.hpp>
#include <memory>
#include <runtime/host/trace/log_clock.hpp>
#include <string>
#include <targets/linux-sim/graph_program.hpp>
#include <targets/linux-sim/options.hpp>
#include <targets/linux-sim/publish/parameters.hpp>
#include <targets/linux-sim/publish/remote.hpp>
#include <targets/linux-sim/publish/ring.hpp>
#include <targets/linux-sim/publish/sink.hpp>
#include <targets/linux-sim/summary.hpp>
#include <thread>
#include <vector>

namespace eagerx::linux_sim {

/// The loop writes into a ring and never waits: messages that do not fit are dropped and counted.
/// One thread empties the ring, and sends the messages to all destinations.
class Publishing {
 public:
  Publishing(const Options& options, const GraphProgram& program, const Fields& fields);
  Publishing(const Publishing&) = delete;
  Publishing& operator=(const Publishing&) = delete;
  ~Publishing();

  /// Opens all destinations. Empty, or the problem.
  std::string open();
  void start();
  /// Sends the remaining messages. Empty, or the problem.
  std::string finish(Summary& summary);
  /// The requests of clients; null: they only read.
  Remote* remote() const { return remote_.get(); }
  bool wants_scenes() const { return scene_rows_ > 0; }

  // Of the loop, from here on.

  void message(std::uint32_t channel, std::uint32_t episode, Seq seq, const void* data) {
    const Wanted& wanted = wanted_[channel];
    if (wanted.every != 1 && (wanted.every == 0 || seq % wanted.every != 0)) return;
    std::uint64_t* const at = ring_->begin(wanted.words);
    if (at == nullptr) return drop();
    at[0] = std::uint64_t{episode} << kEpisodeShift | channel;
    at[1] = seq;
    // Most messages are one number.
    if (wanted.bytes == sizeof(float)) {
      std::memcpy(at + kHeadWords, data, sizeof(float));
    } else if (wanted.bytes == sizeof(double)) {
      std::memcpy(at + kHeadWords, data, sizeof(double));
    } else {
      return copy(at + kHeadWords, data, wanted);
    }
    ring_->commit(wanted.words);
  }
  /// A reset is step 0.
  void step(std::uint32_t episode, Seq step) {
    if (step % step_every_ != 0) return;
    std::uint64_t* const at = ring_->begin(kHeadWords);
    if (at == nullptr) return drop();
    at[0] = std::uint64_t{episode} << kEpisodeShift | kStep;
    at[1] = step;
    ring_->commit(kHeadWords);
  }
  /// The rows of [rows][kSceneColumns] up to the first empty one.
  void scene(std::uint32_t episode, Seq tick, const float* scene);

 private:
  static constexpr unsigned kEpisodeShift = 32;
  static constexpr std::size_t kHeadWords = 2;
  static constexpr std::uint32_t kStep = 0xffff'ffff, kScene = kStep - 1;
  /// A scene has its number of rows after its head.
  static constexpr std::size_t kSceneHeadWords = kHeadWords + 1;
  static constexpr std::size_t kRowWords = kSceneColumns * sizeof(float) / sizeof(std::uint64_t);

  struct Wanted {
    std::uint32_t every = 0;  // one of this many messages; 0: none
    std::uint32_t words = 0;  // of its record
    std::size_t bytes = 0;    // of its message
  };

  /// The rest of message(); not inlined, so that the usual way needs few registers.
  [[gnu::noinline]] void copy(std::uint64_t* to, const void* from, const Wanted& wanted) {
    std::memcpy(to, from, wanted.bytes);
    ring_->commit(wanted.words);
  }
  [[gnu::cold, gnu::noinline]] void drop() {
    dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  std::string choose_channels();
  std::string open_sinks();
  std::unique_ptr<PublishSink> foxglove_sink_of(const Destination& to);
  std::vector<bool> chosen_channels() const;
  void make_ring();
  void work();
  void take_all();
  std::size_t take(const std::uint64_t* record);
  std::size_t take_step(std::uint32_t episode, const std::uint64_t* record);
  std::size_t take_scene(std::uint32_t episode, const std::uint64_t* record);

  const Options& options_;
  const GraphProgram& program_;
  const Fields& fields_;
  const GraphFacts& facts_;
  PublishedChannels channels_;
  std::vector<Wanted> wanted_;
  std::vector<Scalar> scalars_;  // of channels
  std::uint64_t step_every_ = 1, scene_every_ = 1;
  std::size_t scene_rows_ = 0;  // 0: no scenes are published
  std::unique_ptr<Remote> remote_;
  std::vector<std::unique_ptr<Parameters>> parameters_;  // of each server
  std::unique_ptr<PublishRing> ring_;
  std::vector<std::unique_ptr<PublishSink>> sinks_;
  std::vector<std::string> names_;  // of sinks, as they are written
  std::vector<std::uint64_t> values_;
  std::vector<float> scene_;
  trace_log::LogClock clock_;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

}  // namespace eagerx::linux_sim
