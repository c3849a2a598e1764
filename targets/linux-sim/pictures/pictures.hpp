// What `--render` of a program does with scenes: a window, a film, or pictures in files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <string>
#include <targets/common/image_message.hpp>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// The pictures of a run. There is one, so that a program's trace stays small.
class Pictures {
 public:
  /// Before the run. `rate`: pictures a second, "30/1". Empty, or what is wrong.
  std::string open(const Rendering& wanted, const std::string& title, const std::string& rate);
  bool is_on() const { return is_on_; }
  bool has_window() const;
  /// Whether somebody has closed the window, or a picture could not be written.
  bool ends_run() const { return ends_run_; }

  template <class Message>
  void show(const Message& message) {
    using Shape = target::ImageShape<Message>;
    if constexpr (Shape::is_image) {
      show_image(message.data, Shape::width, Shape::height, Shape::channels);
    } else {
      show_scene(message.data, kSceneRows<Message>);
    }
  }
  /// Nanoseconds for which time stood still at the window, since the last time that was asked.
  std::int64_t take_paused_ns();
  /// How much faster than it was told the run should be, as a power of two.
  int speed() const { return speed_; }

  /// Behind the run. Empty, or what is wrong: then the film, or the picture, is not there.
  std::string close();
  std::uint64_t count() const { return count_; }
  /// Of all pixels so far: equal on every machine.
  std::uint64_t hash() const { return hash_; }

 private:
  void show_scene(const float* scene, std::size_t rows);
  void show_image(const std::uint8_t* image, int width, int height, int channels);
  void hand_on();
  void look_at_window();

  bool is_on_ = false, ends_run_ = false;
  bool paused_ = false;
  int speed_ = 0;
  std::int64_t paused_ns_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

inline Pictures pictures_of_run;

/// The part of a trace that shows pictures: nothing for a graph without `render:`.
template <class Graph>
struct Shows {};
template <class Graph>
requires requires {
  Graph::kRenders;
}
struct Shows<Graph> {
  static constexpr bool kDraws = true;
  static bool draws() { return pictures_of_run.is_on(); }
  template <class Rate, class Message>
  static void show(Rate /*rate*/, Seq /*tick*/, const Message& message) {
    pictures_of_run.show(message);
  }
};

/// Pictures a second as ffmpeg takes it.
template <class Rate>
std::string text_of_rate() {
  return std::to_string(Rate::num) + "/" + std::to_string(Rate::den);
}

}  // namespace eagerx::linux_sim
