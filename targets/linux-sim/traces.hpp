// The traces of programs: what happens to a message besides being sent.
#pragma once

#include <cstdint>
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
struct Untraced : NoTrace, Shows<Graph> {
  static bool is_interrupted() { return host::stop_if_told(), host::ends_reset(); }
  template <class Message>
  void operator()(std::uint32_t channel, Seq seq, const Message& message) {
    spaces_of_run.see<Graph>(channel, seq, message);
  }
};

/// Whether the graph shows a scene, not an image that is pixels already.
template <class Graph>
inline constexpr bool shows_scene = requires {
  requires !target::ImageShape<typename Graph::Rendered>::is_image;
};

/// What shows pictures, and keeps their scenes if told so.
template <class Graph>
struct ShowsAndKeeps : Shows<Graph> {};
template <class Graph>
requires shows_scene<Graph>
struct ShowsAndKeeps<Graph> : Shows<Graph> {
  static bool draws() { return recorder_of_run.keeps_scenes() || Shows<Graph>::draws(); }
  template <class Rate>
  static void show(Rate rate, Seq tick, const typename Graph::Rendered& scene) {
    if (recorder_of_run.keeps_scenes())
      recorder_of_run.scene(Rate::num, Rate::den, tick, scene.data);
    if (Shows<Graph>::draws()) Shows<Graph>::show(rate, tick, scene);
  }
};

/// Folds messages into the hash and shows them to recorder_of_run.
template <class Graph>
class Traced : public ShowsAndKeeps<Graph> {
 public:
  static constexpr bool kSimulators = true;

  static bool is_interrupted() { return host::stop_if_told(), host::ends_reset(); }
  static bool runs_engine() { return recorder_of_run.runs_engine(); }
  std::uint64_t hash() const { return hash_.hash(); }

  void episode(std::uint32_t index) {
    recorder_of_run.episode(index);
    hash_.episode(index);
  }

  /// Never inlined: a program has a call for each of its messages, and a thousand nodes take 15 %
  /// (g++) to 29 % (clang++) more text when all of them are expanded.
  template <class Message>
  [[gnu::noinline]] void operator()(std::uint32_t channel, Seq seq, Message& message) {
    if (recorder_of_run.takes_part() &&
        !recorder_of_run.before(channel, seq, MessageView::of(message)))
      return;
    spaces_of_run.see<Graph>(channel, seq, message);
    hash_(channel, seq, message);
    if (recorder_of_run.keeps()) recorder_of_run.keep(channel, seq, MessageView::of(message));
  }

  template <class Simulator>
  void simulator(const char* object, Seq tick, Simulator& simulator) {
    if constexpr (identification::HasDynamics<Simulator>) {
      if (recorder_of_run.experiments())
        recorder_of_run.simulator(object, tick, identification::view_of(simulator));
    }
  }

 private:
  HashTrace hash_;
};

}  // namespace eagerx::linux_sim
