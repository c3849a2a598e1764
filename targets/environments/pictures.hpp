// Environments whose pictures are wanted: what `render:` of the graph showed last is kept, and
// painted when somebody asks for it.
#pragma once

#include <cstdint>
#include <eagerx/picture.hpp>
#include <eagerx/rate.hpp>
#include <eagerx/scene.hpp>
#include <eagerx/trace.hpp>
#include <memory>
#include <string>
#include <targets/common/image_message.hpp>
#include <targets/environments/problem.hpp>

namespace eagerx::environments {

/// Whether the graph has `render:`.
template <class Graph>
inline constexpr bool has_render = requires {
  Graph::kRenders;
};

/// Pixels a side.
inline constexpr std::uint32_t kWidestPicture = 4096;
using Painter = picture::Painter<kWidestPicture>;

/// The part of a trace that keeps what was shown last: nothing for a graph without `render:`.
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
  /// `image` has three channels.
  void paint(Painter& painter, const picture::Image& image) const {
    using Shape = target::ImageShape<typename Graph::Rendered>;
    if (!is_shown_) {
      painter.paint(nullptr, 0, image);
    } else if constexpr (Shape::is_image) {
      target::scale_image(last_.data, Shape::width, Shape::height, Shape::channels, image);
    } else {
      painter.paint(last_.data, kSceneRows<typename Graph::Rendered>, image);
    }
  }

 private:
  typename Graph::Rendered last_{};
  bool draws_ = false, is_shown_ = false;
};

/// The programs of a batch that draws; for a graph without `render:` there are none.
template <class Graph>
class DrawnPrograms {
 public:
  /// Throws Problem if any are wanted.
  explicit DrawnPrograms(std::uint32_t environments) {
    if (environments == 0) return;
    throw Problem("graph `" + std::string(Graph::kName) +
                  "` has no `render:`, so there are no pictures: add "
                  "`render: {source: OBJECT.scene}` and build it again");
  }
  static constexpr bool any() { return false; }
};
template <class Graph>
requires has_render<Graph>
class DrawnPrograms<Graph> {
 public:
  struct Trace : NoTrace, LastShown<Graph> {};
  using Program = typename Graph::template Program<Trace>;

  explicit DrawnPrograms(std::uint32_t environments) {
    if (environments == 0) return;
    painter_ = std::make_unique<Painter>();
    programs_ = std::make_unique<Program[]>(environments);
    for (std::uint32_t k = 0; k < environments; ++k) programs_[k].trace.draw_from_now_on();
  }

  bool any() const { return programs_ != nullptr; }
  Program& operator[](std::uint32_t k) const { return programs_[k]; }
  Painter& painter() const { return *painter_; }

 private:
  std::unique_ptr<Program[]> programs_;
  std::unique_ptr<Painter> painter_;
};

}  // namespace eagerx::environments
