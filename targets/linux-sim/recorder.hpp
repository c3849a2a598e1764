// Writes and measures the messages of a run, compares them with a log or takes them from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <runtime/host/identify/simulator_view.hpp>
#include <targets/linux-sim/message_view.hpp>

namespace eagerx::host {
class TextFile;
}
namespace eagerx::trace_log {
class Replay;
}
namespace eagerx::identification {
class Experiment;
}

namespace eagerx::linux_sim {

struct GraphFacts;
class Measures;
class Publishing;
class SceneRecord;

/// A program's trace points to it, and so stays small. Programs call the first part.
class Recorder {
 public:
  void episode(std::uint32_t index) { episode_ = index; }
  /// Whether before() has something to do.
  bool takes_part() const { return replay_ != nullptr || experiment_ != nullptr; }
  /// Whether keep() has something to do.
  bool keeps() const { return keeps_; }
  /// A message may become another one. False: no other observer wants it.
  bool before(std::uint32_t channel, Seq seq, MessageView message);
  void keep(std::uint32_t channel, Seq seq, MessageView message);
  bool experiments() const { return experiment_ != nullptr; }
  void simulator(const char* object, Seq tick, const identification::SimulatorView& simulator);
  bool runs_engine() const;
  bool keeps_scenes() const { return keeps_scenes_; }
  void scene(std::uint64_t rate_num, std::uint64_t rate_den, Seq tick, const float* scene);

  void graph_is(const GraphFacts& facts) { facts_ = &facts; }
  /// Without a file only the hash is made. `timed`: every message with the time it was sent at.
  void write_to(host::TextFile* file, bool timed);
  void keep_scenes(host::TextFile* file, SceneRecord* scenes);
  /// Others see the messages.
  void publish(Publishing* publishing);
  /// Expressions see the messages.
  void measure(Measures& measures);
  void follow(trace_log::Replay* replay) { replay_ = replay; }
  /// Every run is one of the experiment's from now on.
  void follow(identification::Experiment* experiment) { experiment_ = experiment; }
  /// The file's last line.
  void write_end(std::uint64_t hash) const;

 private:
  /// Not inlined: where messages are only published, keep() needs few registers.
  [[gnu::noinline]] void keep_all(std::uint32_t channel, Seq seq, MessageView message);
  void decide();

  const GraphFacts* facts_ = nullptr;
  host::TextFile* file_ = nullptr;
  host::TextFile* scene_file_ = nullptr;
  SceneRecord* scenes_ = nullptr;
  Measures* measures_ = nullptr;  // null: they read no messages
  Publishing* publishing_ = nullptr;
  trace_log::Replay* replay_ = nullptr;
  identification::Experiment* experiment_ = nullptr;
  std::uint64_t messages_ = 0;  // in the file
  std::int64_t start_ns_ = 0;
  std::uint32_t episode_ = 0;
  bool timed_ = false;
  bool keeps_ = false;
  bool only_publishes_ = false;
  bool keeps_scenes_ = false;
};

}  // namespace eagerx::linux_sim
