#include <cstddef>
#include <eagerx/picture.hpp>
#include <memory>
#include <targets/common/last_shown.hpp>
#include <targets/environments/base/painter.hpp>

namespace eagerx::environments {

struct Painter::Work {
  picture::Painter<target::kWidestPicture, 384, target::kMostShapes> painter;
};

Painter::Painter() : work_(std::make_unique<Work>()) {}
Painter::~Painter() = default;

void Painter::paint(const float* scene, std::size_t rows, const picture::Image& image) {
  work_->painter.paint(scene, rows, image);
}

}  // namespace eagerx::environments
