// Pictures of environments: keeps the last scene of the graph's `render:`, and paints it on
// request.
#pragma once

#include <cstdint>
#include <eagerx/hooks.hpp>
#include <memory>
#include <string>
#include <targets/common/last_shown.hpp>
#include <targets/environments/base/painter.hpp>
#include <targets/environments/base/problem.hpp>

namespace eagerx::environments {

using target::has_render;
using target::kWidestPicture;
using target::LastShown;

/// The programs of a batch that draws; none for a graph without `render:`.
template <class Graph>
class DrawnPrograms {
 public:
  /// Throws Problem if any are wanted.
  explicit DrawnPrograms(std::uint32_t environments) {
    if (environments == 0) return;
    refuse("graph `" + std::string(Graph::kName) +
           "` has no `render:`, so there are no pictures: add `render: {source: OBJECT.scene}` and "
           "build it again");
  }
  static constexpr bool any() { return false; }
};
template <class Graph>
requires has_render<Graph>
class DrawnPrograms<Graph> {
 public:
  struct Hooks : NoHooks, LastShown<Graph> {};
  using Program = typename Graph::template Program<Hooks>;

  explicit DrawnPrograms(std::uint32_t environments) {
    if (environments == 0) return;
    painter_ = std::make_unique<Painter>();
    programs_ = std::make_unique<Program[]>(environments);
    for (std::uint32_t k = 0; k < environments; ++k) programs_[k].hooks.draw_from_now_on();
  }

  bool any() const { return programs_ != nullptr; }
  Program& operator[](std::uint32_t k) const { return programs_[k]; }
  Painter& painter() const { return *painter_; }

 private:
  std::unique_ptr<Program[]> programs_;
  std::unique_ptr<Painter> painter_;
};

}  // namespace eagerx::environments
