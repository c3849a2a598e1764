// What a program that shows something calls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <targets/common/image_message.hpp>

namespace eagerx::linux_sim {

class Pictures;

Pictures* pictures_of_run();
bool pictures_are_on();
/// A scene of [rows][kSceneColumns].
void show_scene(const float* scene, std::size_t rows);
/// An image of [height][width][channels].
void show_image(const std::uint8_t* image, int width, int height, int channels);

template <class Message>
void show(const Message& message) {
  using Shape = target::ImageShape<Message>;
  if constexpr (Shape::is_image) {
    show_image(message.data, Shape::width, Shape::height, Shape::channels);
  } else {
    show_scene(message.data, kSceneRows<Message>);
  }
}

/// The part of a trace that shows pictures: nothing for a graph without `render:`.
template <class Graph>
struct Shows {};
template <class Graph>
requires requires {
  Graph::kRenders;
}
struct Shows<Graph> {
  static constexpr bool kDraws = true;
  static bool draws() { return pictures_are_on(); }
  template <class Rate, class Message>
  static void show(Rate /*rate*/, Seq /*tick*/, const Message& message) {
    linux_sim::show(message);
  }
};

}  // namespace eagerx::linux_sim
