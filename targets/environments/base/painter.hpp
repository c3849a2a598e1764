// Pictures of scenes, compiled once for all libraries.
#pragma once

#include <cstddef>
#include <eagerx/scene.hpp>
#include <memory>

namespace eagerx::picture {
struct Image;
}

namespace eagerx::environments {

class Painter {
 public:
  Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;
  ~Painter();

  /// As picture::Painter.
  void paint(const float* scene, std::size_t rows, const picture::Image& image);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace eagerx::environments
