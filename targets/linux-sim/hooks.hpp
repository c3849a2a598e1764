// The hooks of programs: handle messages in addition to sending them.
#pragma once

#include <cstdint>
#include <eagerx/hooks.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/trace.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <targets/linux-sim/pictures/show.hpp>
#include <targets/linux-sim/recorder.hpp>
#include <targets/linux-sim/spaces.hpp>

namespace eagerx::linux_sim {

/// No trace, but messages out of their spaces are counted, and a reset that waits ends when there
/// was a signal, or a stop.
template <class Graph>
struct UntracedHooks : NoHooks, Shows<Graph> {
  SpaceCounts* spaces = nullptr;

  static bool is_interrupted() { return host::stop_if_requested(), host::ends_reset(); }
  template <class Message>
  void on_message(std::uint32_t channel, Seq seq, const Message& message) {
    spaces->see<Graph>(channel, seq, message);
  }
};

/// Whether the graph shows a scene, not an image that is pixels already.
template <class Graph>
inline constexpr bool shows_scene = requires {
  requires !target::ImageShape<typename Graph::Rendered>::is_image;
};

/// Shows pictures, and keeps their scenes on request.
template <class Graph>
struct ShowsAndKeeps : Shows<Graph> {
  Recorder* recorder = nullptr;
};
template <class Graph>
requires shows_scene<Graph>
struct ShowsAndKeeps<Graph> : Shows<Graph> {
  Recorder* recorder = nullptr;

  bool draws() const { return recorder->keeps_scenes() || Shows<Graph>::draws(); }
  template <class Rate>
  void show(Rate rate, Seq tick, const typename Graph::Rendered& scene) const {
    if (recorder->keeps_scenes()) recorder->scene(Rate::num, Rate::den, tick, scene.data);
    if (Shows<Graph>::draws()) Shows<Graph>::show(rate, tick, scene);
  }
};

/// Folds messages into the hash and shows them to the recorder.
template <class Graph>
class TracedHooks : public ShowsAndKeeps<Graph> {
 public:
  static constexpr bool kSeesSimulators = true;
  using ShowsAndKeeps<Graph>::recorder;
  SpaceCounts* spaces = nullptr;

  static bool is_interrupted() { return host::stop_if_requested(), host::ends_reset(); }
  bool runs_engine() const { return recorder->runs_engine(); }
  std::uint64_t hash() const { return hash_.hash(); }

  void on_episode(std::uint32_t index) {
    recorder->episode(index);
    hash_.on_episode(index);
  }

  /// Never inlined: a program has a call for each of its messages, and a thousand nodes take 15 %
  /// (g++) to 29 % (clang++) more text when all of them are expanded.
  template <class Message>
  [[gnu::noinline]] void on_message(std::uint32_t channel, Seq seq, Message& message) {
    if (recorder->takes_part() && !recorder->before(channel, seq, MessageView::of(message))) return;
    spaces->see<Graph>(channel, seq, message);
    hash_.on_message(channel, seq, message);
    if (recorder->keeps()) recorder->keep(channel, seq, MessageView::of(message));
  }

  template <class Simulator>
  void on_simulator(const char* object, Seq tick, Simulator& simulator) {
    if constexpr (identification::HasDynamics<Simulator>) {
      if (recorder->experiments())
        recorder->simulator(object, tick, identification::view_of(simulator));
    }
  }

 private:
  HashTrace hash_;
};

}  // namespace eagerx::linux_sim
