// Interface of `--render` for programs.
#pragma once

#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <targets/common/image_message.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>

namespace eagerx::linux_sim {

template <class Message>
void show(const Message& message, Pictures& pictures) {
  using Shape = target::ImageShape<Message>;
  if constexpr (Shape::is_image) {
    pictures.show_image(message.data, Shape::width, Shape::height, Shape::channels);
  } else {
    pictures.show_scene(message.data, kSceneRows<Message>);
  }
}

/// The part of hooks that shows pictures: nothing for a graph without `render:`.
template <class Graph>
struct Shows {};
template <class Graph>
requires requires {
  Graph::kRenders;
}
struct Shows<Graph> {
  static constexpr bool kDraws = true;
  Pictures* pictures = nullptr;

  bool draws() const { return pictures->is_on(); }
  template <class Rate, class Message>
  void show(Rate /*rate*/, Seq /*tick*/, const Message& message) const {
    linux_sim::show(message, *pictures);
  }
};

}  // namespace eagerx::linux_sim
