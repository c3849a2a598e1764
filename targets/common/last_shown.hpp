// The newest picture of `render:`, kept until a reader wants it as pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/picture/coverage.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <targets/common/image_message.hpp>

namespace eagerx::target {

/// Whether the graph has `render:`.
template <class Graph>
inline constexpr bool has_render = requires {
  Graph::kRenders;
};

/// Pixels a side.
inline constexpr std::uint32_t kWidestPicture = 4096;
/// Shapes in space of a picture; more are left out. RigidDrawing has at most as many rows.
inline constexpr std::size_t kMostShapes = 1024;

/// The part of hooks that keeps the last picture; empty for a graph without `render:`.
template <class Graph>
class LastShown {
 public:
  void draw_from_now_on() {}
  void forget() {}
};
template <class Graph>
requires has_render<Graph>
class LastShown<Graph> {
 public:
  static constexpr bool kDraws = true;
  bool draws() const { return draws_; }
  template <class Rate>
  void show(Rate /*rate*/, Seq /*tick*/, const typename Graph::Rendered& message) {
    last_ = message;
    is_shown_ = true;
  }

  void draw_from_now_on() { draws_ = true; }
  /// White, until something is shown.
  void forget() { is_shown_ = false; }
  /// `image` has three channels. `painter`: as picture::Painter.
  template <class Painter>
  void paint(Painter& painter, const picture::Image& image) const {
    using Shape = ImageShape<typename Graph::Rendered>;
    if (!is_shown_) {
      painter.paint(nullptr, 0, image);
    } else if constexpr (Shape::is_image) {
      scale_image(last_.data, Shape::width, Shape::height, Shape::channels, image);
    } else {
      painter.paint(last_.data, kSceneRows<typename Graph::Rendered>, image);
    }
  }

 private:
  typename Graph::Rendered last_{};
  bool draws_ = false, is_shown_ = false;
};

}  // namespace eagerx::target
