// Scenes as pixels: the same on every machine, since outlines are filled in integers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/picture/brush.hpp>
#include <eagerx/picture/coverage.hpp>
#include <eagerx/picture/space.hpp>
#include <eagerx/scene.hpp>

namespace eagerx::picture {

/// Paints scenes on images that are at most kMaxWidth pixels wide. Needs about 8 bytes for each
/// pixel of that width, 24 for each edge and 16 for each shape in space. An outline with more edges
/// is painted in parts; additional shapes in space are left out.
template <std::size_t kMaxWidth, std::size_t kMaxEdges = 384, std::size_t kMostBodies = 128>
class Painter {
 public:
  /// Paints the whole image. `rows`: number of rows of the scene, 16 numbers each. Paints the
  /// shapes in space first, the farthest first, then the planar shapes in their order.
  void paint(const float* scene, std::size_t rows, const Image& image) {
    brush_.begin(image);
    rows = rows_of(scene, rows);
    clear(scene, rows);
    if (has_camera_) paint_space(scene, rows);
    for (std::size_t i = 0; i < rows; ++i) {
      const SceneRow row = SceneRow::read(scene + i * kSceneColumns);
      if (row.shape > Shape::view && row.shape < Shape::camera) paint_flat(row);
    }
  }

 private:
  using BrushType = Brush<kMaxEdges, kMaxWidth>;
  static constexpr float kPoints = 480.0F;  // of a picture's height

  static std::size_t rows_of(const float* scene, std::size_t rows) {
    std::size_t count = 0;
    while (count < rows && scene[count * kSceneColumns] != 0.0F) ++count;
    return count;
  }

  /// Paints the background, and applies the first view or camera.
  void clear(const float* scene, std::size_t rows) {
    const Image& image = brush_.image();
    const auto width = static_cast<float>(image.width), height = static_cast<float>(image.height);
    screen_ = {0.0F, height, width, height, height};
    view_ = screen_;
    has_camera_ = false;
    Paint paper = paint_of(0xffffff, 1.0F);
    for (std::size_t i = 0; i < rows; ++i) {
      const SceneRow row = SceneRow::read(scene + i * kSceneColumns);
      if (row.shape == Shape::view && row.n[2] > 0.0F) {
        const float scale = height / row.n[2];
        view_ = {0.5F * width - row.n[0] * scale, 0.5F * height + row.n[1] * scale, scale, scale,
                 scale};
      } else if (row.shape == Shape::camera) {
        camera_ = Camera(row.n, image);
        has_camera_ = true;
      } else {
        continue;
      }
      paper = paint_of(row.ink.colour, 1.0F);
      break;
    }
    const std::ptrdiff_t pixels = static_cast<std::ptrdiff_t>(image.width) * image.height;
    if (image.channels == 1) {
      const auto grey = static_cast<std::uint8_t>(grey_of(paper));
      for (std::ptrdiff_t i = 0; i < pixels; ++i) image.pixels[i] = grey;
      return;
    }
    for (std::ptrdiff_t i = 0; i < pixels; ++i) {
      image.pixels[3 * i] = paper.red;
      image.pixels[3 * i + 1] = paper.green;
      image.pixels[3 * i + 2] = paper.blue;
    }
  }

  void paint_space(const float* scene, std::size_t rows) {
    SpacePainter<BrushType> space(brush_, camera_);
    std::size_t count = 0;
    bool has_ground = false;
    float ground = 0.0F;
    for (std::size_t i = 0; i < rows; ++i) {
      const SceneRow row = SceneRow::read(scene + i * kSceneColumns);
      if (row.shape == Shape::plane) {
        space.paint(row);
        ground = row.n[2];
        has_ground = true;
      } else if (row.shape > Shape::plane && count < kMostBodies) {
        insert(count++, i, camera_.depth(SpacePainter<BrushType>::middle(row)));
      }
    }
    if (has_ground) {
      brush_.dip(paint_of(0x000000, 0.16F));
      for (std::size_t k = 0; k < count; ++k)
        space.add_shadow(SceneRow::read(scene + bodies_[k].row * kSceneColumns), ground);
      brush_.paint();
    }
    for (std::size_t k = 0; k < count; ++k)
      space.paint(SceneRow::read(scene + bodies_[k].row * kSceneColumns));
  }

  /// The farthest comes first.
  void insert(std::size_t count, std::size_t row, float depth) {
    for (; count > 0 && bodies_[count - 1].depth < depth; --count)
      bodies_[count] = bodies_[count - 1];
    bodies_[count] = {depth, row};
  }

  void paint_flat(const SceneRow& row) {
    const Frame& frame = row.on_screen ? screen_ : view_;
    const float* n = row.n;
    const bool filled = row.ink.width == 0.0F;
    const float width = row.ink.width >= 0.0F
                            ? row.ink.width * frame.scale
                            : -row.ink.width * static_cast<float>(brush_.image().height) / kPoints;
    brush_.dip(paint_of(row.ink.colour, row.ink.opacity));
    const Point2 a = frame({n[0], n[1]}), b = frame({n[2], n[3]});
    switch (row.shape) {
      case Shape::line:
        brush_.add_line(a, b, width);
        break;
      case Shape::polyline:
      case Shape::polygon:
        add_points(row, frame, width);
        break;
      case Shape::circle:
        if (filled)
          brush_.add_disc(a, n[2] * frame.scale);
        else
          brush_.add_ring(a, n[2] * frame.scale, width);
        break;
      case Shape::rectangle:
        add_rectangle(row, frame, filled ? 0.0F : 0.5F * width / frame.scale);
        break;
      case Shape::arrow:
        brush_.add_arrow(a, b, n[4] * frame.scale, width);
        break;
      case Shape::text:
        brush_.paint_text(a, n[2] * frame.scale, line_of(row), align_of(n[5]));
        break;
      default:
        break;
    }
    brush_.paint();
  }

  void add_points(const SceneRow& row, const Frame& frame, float width) {
    Point2 p[6];
    std::size_t count = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const bool repeats =
          i > 0 && row.n[2 * i] == row.n[2 * i - 2] && row.n[2 * i + 1] == row.n[2 * i - 1];
      if (!repeats) p[count++] = frame({row.n[2 * i], row.n[2 * i + 1]});
    }
    const bool closed = row.shape == Shape::polygon;
    if (closed && row.ink.width == 0.0F)
      brush_.add_polygon(p, count);
    else
      brush_.add_path(p, count, width, closed);
  }

  /// On the screen widths and heights are both in heights of the picture.
  void add_rectangle(const SceneRow& row, const Frame& frame, float half_line) {
    const Point2 middle = frame({row.n[0], row.n[1]});
    const Frame square{middle.x, middle.y, frame.scale, frame.scale, frame.scale};
    const float n[] = {0.0F, 0.0F, row.n[2], row.n[3], row.n[4], row.n[5]};
    brush_.add_rectangle(square, n, half_line, false);
    if (half_line > 0.0F) brush_.add_rectangle(square, n, -half_line, true);
  }

  static Line line_of(const SceneRow& row) {
    Line line;
    const float decimals = row.n[4];
    const bool numbered = decimals >= 0.0F && decimals <= 6.0F;
    for (std::size_t i = 0; i < kSceneCharacters; ++i) {
      const unsigned char c = row.character(i);
      if (c == 0) break;
      if (c == '#' && numbered)
        line.add_number(row.n[3], static_cast<int>(decimals));
      else
        line.add(c);
    }
    return line;
  }
  static Align align_of(float value) {
    return value == 1.0F ? Align::middle : value == 2.0F ? Align::right : Align::left;
  }

  struct Body {
    float depth;
    std::size_t row;
  };
  BrushType brush_{};
  Frame screen_{}, view_{};
  Camera camera_{};
  bool has_camera_ = false;
  std::array<Body, kMostBodies> bodies_{};
};

}  // namespace eagerx::picture
