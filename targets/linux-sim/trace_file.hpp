// The trace: hash and, if wanted, every message in a file, or compared with a log.
#pragma once

#include <cstdint>
#include <eagerx/message.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/trace.hpp>
#include <eagerx/trace_text.hpp>
#include <optional>
#include <runtime/host/identify/experiment.hpp>
#include <runtime/host/trace/replay.hpp>
#include <string_view>
#include <targets/linux-sim/interrupt.hpp>
#include <targets/linux-sim/measures.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/scene_record.hpp>
#include <targets/linux-sim/spaces.hpp>
#include <targets/linux-sim/text_file.hpp>

namespace eagerx::linux_sim {

/// No trace, but messages out of their spaces are counted, and a reset that waits ends when there
/// was a signal, or a stop.
template <class Graph>
struct Untraced : NoTrace, Shows<Graph> {
  static bool is_interrupted() { return stop_if_told(), interrupted(); }
  template <class Message>
  void operator()(std::uint32_t channel, Seq seq, const Message& message) {
    spaces_of_run<Graph>.see(channel, seq, message);
  }
};

/// The record of a run. There is one, so that a program's trace stays small.
template <class Message>
inline std::optional<SceneRecord<Message>> scenes_of_run;

/// What shows pictures, and writes their scenes into the trace if told so.
template <class Graph>
class ShowsAndKeeps : public Shows<Graph> {
 public:
  static void keep_scenes(TextFile* /*file*/) {}
  static void scenes_are_of(std::uint32_t /*episode*/) {}
};
template <class Graph>
requires shows_scene<Graph>
class ShowsAndKeeps<Graph> : public Shows<Graph> {
 public:
  void keep_scenes(TextFile* file) {
    scenes_of_run<Message>.emplace();
    scene_file_ = file;
  }
  void scenes_are_of(std::uint32_t episode) { scene_episode_ = episode; }
  bool draws() const { return scene_file_ != nullptr || Shows<Graph>::draws(); }
  template <class Rate>
  void show(Rate rate, Seq tick, const typename Graph::Rendered& scene) {
    if (scene_file_ != nullptr)
      scenes_of_run<Message>->write(*scene_file_, scene_episode_, rate, tick, scene);
    if (Shows<Graph>::draws()) Shows<Graph>::show(rate, tick, scene);
  }

 private:
  using Message = typename Graph::Rendered;
  TextFile* scene_file_ = nullptr;
  std::uint32_t scene_episode_ = 0;
};

/// A trace for generated programs that folds messages into the hash, writes them to a file, and
/// compares them with a log or takes them from it.
template <class Graph>
class TraceRecorder : public ShowsAndKeeps<Graph> {
 public:
  static constexpr bool kSimulators = true;
  using Text = TraceText<Graph, TextFile>;

  /// Without a file only the hash is made. `timed`: every message with the time it was sent at.
  void write_to(TextFile* file, bool timed) {
    file_ = file;
    start_ns_ = now_ns();
    timed_ = timed;
  }
  /// Expressions see the messages.
  void measure() { measures_ = measures_of_run.reads_messages(); }
  void follow(trace_log::Replay* replay) { replay_ = replay; }
  /// Every run is one of the experiment's from now on.
  void measure(identification::Experiment* experiment) { experiment_ = experiment; }
  static bool is_interrupted() { return stop_if_told(), interrupted(); }
  /// An engine that acts on the world itself is neither started nor called.
  void leave_engine_alone() { engine_is_left_alone_ = true; }
  bool runs_engine() const {
    return !engine_is_left_alone_ && (replay_ == nullptr || replay_->runs_engine());
  }
  std::uint64_t hash() const { return hash_.hash(); }

  void episode(std::uint32_t index) {
    episode_ = index;
    this->scenes_are_of(index);
    hash_.episode(index);
  }

  /// Never inlined: a program has a call for each of its messages, and a thousand nodes take 15 %
  /// (g++) to 29 % (clang++) more text when all of them are expanded.
  template <class Message>
  [[gnu::noinline]] void operator()(std::uint32_t channel, Seq seq, Message& message) {
    if (experiment_ != nullptr) return experiment_->message(channel, seq, message);
    if (replay_ != nullptr) replay_->message(channel, episode_, seq, message);
    spaces_of_run<Graph>.see(channel, seq, message);
    if (measures_) measures_of_run.set_message(Variable::Kind::message, channel, message);
    hash_(channel, seq, message);
    if (file_ != nullptr) write(channel, seq, message);
  }

  template <class Simulator>
  void simulator(const char* object, Seq tick, Simulator& simulator) {
    if (experiment_ != nullptr) experiment_->simulator(object, tick, simulator);
  }

  /// The file's last line.
  void write_end() const {
    if (file_ != nullptr) Text::end(*file_, messages_, hash());
  }

 private:
  template <class Message>
  void write(std::uint32_t channel, Seq seq, const Message& message) {
    ++messages_;
    Text::begin_message(*file_, episode_, channel, seq);
    if (timed_) Text::time(*file_, now_ns() - start_ns_);
    Text::values(*file_, message);
  }

  HashTrace hash_;
  TextFile* file_ = nullptr;
  trace_log::Replay* replay_ = nullptr;
  identification::Experiment* experiment_ = nullptr;
  std::uint64_t messages_ = 0;  // in the file
  std::int64_t start_ns_ = 0;
  std::uint32_t episode_ = 0;
  bool timed_ = false;
  bool measures_ = false;
  bool engine_is_left_alone_ = false;
};

}  // namespace eagerx::linux_sim
