// A drawing as a message: float32 [rows, 16], one shape per row. picture.hpp draws it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <eagerx/message.hpp>
#include <string_view>
#include <type_traits>

namespace eagerx {

/// The kind of a row of a scene: its column 0. A row of zeros ends the scene, so that a node can
/// append shapes. Columns 1 to 3 are those of Ink; the shape's own numbers begin at column 4.
/// Lengths are metres in the plane of the view (x right, y up) or in space (z up). With kOnScreen
/// added to column 0, x and y go from 0 to 1 over the picture, from left to right and from bottom
/// to top, and other lengths are in heights of the picture.
enum class Shape : std::uint8_t {
  none,
  view,       // x, y of the middle, height of what is seen; colour: of the background
  line,       // x0, y0, x1, y1; ends are round
  polyline,   // six points; where there are fewer, the last is repeated
  polygon,    // the same, closed and filled (a width makes it an outline)
  circle,     // x, y, radius
  rectangle,  // x and y of the middle, width, height, angle [rad], radius of the corners
  arrow,      // x0, y0, x1, y1, length of the head
  text,       // x, y, height, number, decimals (-1: no number), align (0 left, 1 middle, 2 right),
              // six times three characters; where the number stands, the text has a `#`
  camera,     // eye x, y, z; what it looks at x, y, z; vertical angle of view [rad]; background
  plane,      // x, y, z of the middle, half its width, width of a chequer; level
  box,        // pose (x, y, z, quaternion w, x, y, z), width in x, y, z
  sphere,     // x, y, z, radius
  capsule,    // pose, radius, length without its ends, along z
  cylinder,   // pose, radius, length, along z
  segment,    // x0, y0, z0, x1, y1, z1: a line in space
  facet,      // four corners x, y, z of a flat piece of a surface, with the same light on both
              // sides; a triangle repeats its last one
};
inline constexpr int kOnScreen = 32;
inline constexpr std::size_t kSceneColumns = 16;
inline constexpr std::size_t kSceneCharacters = 18;

/// How a shape is painted: colour 0xRRGGBB, opacity from 0 to 1, and the width of its line: 0 fills
/// the shape, positive widths are in meters, negative ones in points, 1/480 of the picture's
/// height.
struct Ink {
  std::uint32_t colour = 0;
  float opacity = 1.0F;
  float width = 0.0F;
};
constexpr Ink fill(std::uint32_t colour, float opacity = 1.0F) {
  return {colour, opacity, 0.0F};
}
constexpr Ink stroke(std::uint32_t colour, float width_m, float opacity = 1.0F) {
  return {colour, opacity, width_m};
}
constexpr Ink points(std::uint32_t colour, float width, float opacity = 1.0F) {
  return {colour, opacity, -width};
}

struct Point2 {
  float x = 0.0F, y = 0.0F;
};
struct Point3 {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};
/// Position and unit quaternion.
struct Pose {
  Point3 at{};
  float w = 1.0F, x = 0.0F, y = 0.0F, z = 0.0F;
};
enum class Align : std::uint8_t { left, middle, right };

/// Three characters as a whole number below 2^24, which a float represents exactly.
constexpr float pack_characters(std::string_view text, std::size_t first) {
  std::uint32_t packed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t at = first + i;
    packed = packed << 8U | (at < text.size() ? static_cast<unsigned char>(text[at]) : 0U);
  }
  return static_cast<float>(packed);
}

template <class Message>
inline constexpr std::size_t kSceneRows = size_of<Message> / kSceneColumns;

/// Writes a scene into `message`, float32 [rows, 16]. Shapes that do not fit are left out.
template <class Message>
class SceneWriter {
  static_assert(std::is_same_v<ScalarOf<Message>, float> && kSceneRows<Message> > 0 &&
                    size_of<Message> % kSceneColumns == 0,
                "a scene is a message float32 [rows, 16]");

 public:
  /// An empty scene.
  explicit constexpr SceneWriter(Message& message) : message_(message) { message = Message{}; }
  /// Starts from `base`, and adds shapes to it.
  constexpr SceneWriter(Message& message, const Message& base) : message_(message) {
    message = base;
    while (rows_ < kSceneRows<Message> && message_[rows_ * kSceneColumns] != 0.0F) ++rows_;
  }

  constexpr std::size_t rows() const { return rows_; }
  /// Places the following shapes on the picture, or in the view again.
  constexpr void on_screen(bool on = true) { frame_ = on ? kOnScreen : 0; }

  constexpr void view(Point2 middle, float height, std::uint32_t background) {
    add(Shape::view, fill(background), {middle.x, middle.y, height});
  }
  constexpr void line(Point2 a, Point2 b, Ink ink) { add(Shape::line, ink, {a.x, a.y, b.x, b.y}); }
  template <std::size_t N>
  constexpr void polyline(const Point2 (&p)[N], Ink ink) {
    add_points(Shape::polyline, p, ink);
  }
  template <std::size_t N>
  constexpr void polygon(const Point2 (&p)[N], Ink ink) {
    add_points(Shape::polygon, p, ink);
  }
  constexpr void circle(Point2 middle, float radius, Ink ink) {
    add(Shape::circle, ink, {middle.x, middle.y, radius});
  }
  constexpr void rectangle(Point2 middle, float width, float height, Ink ink, float angle_rad = 0,
                           float corner = 0) {
    add(Shape::rectangle, ink, {middle.x, middle.y, width, height, angle_rad, corner});
  }
  constexpr void arrow(Point2 from, Point2 to, float head, Ink ink) {
    add(Shape::arrow, ink, {from.x, from.y, to.x, to.y, head});
  }
  /// At most 18 characters of ASCII.
  constexpr void text(Point2 at, float height, std::string_view text, std::uint32_t colour,
                      Align align = Align::left) {
    write(at, height, text, 0.0F, -1.0F, colour, align);
  }
  /// The same with a number instead of the `#`, rounded to 0 to 6 decimals.
  constexpr void number(Point2 at, float height, std::string_view text, float value, int decimals,
                        std::uint32_t colour, Align align = Align::left) {
    write(at, height, text, value, static_cast<float>(decimals), colour, align);
  }

  constexpr void camera(Point3 eye, Point3 target, float angle_rad, std::uint32_t background) {
    add(Shape::camera, fill(background),
        {eye.x, eye.y, eye.z, target.x, target.y, target.z, angle_rad});
  }
  constexpr void plane(Point3 middle, float half_width, float chequer, std::uint32_t colour) {
    add(Shape::plane, fill(colour), {middle.x, middle.y, middle.z, half_width, chequer});
  }
  constexpr void box(const Pose& pose, Point3 size, std::uint32_t colour) {
    add_posed(Shape::box, pose, colour, size.x, size.y, size.z);
  }
  constexpr void sphere(Point3 at, float radius, std::uint32_t colour) {
    add(Shape::sphere, fill(colour), {at.x, at.y, at.z, radius});
  }
  constexpr void capsule(const Pose& pose, float radius, float length, std::uint32_t colour) {
    add_posed(Shape::capsule, pose, colour, radius, length, 0.0F);
  }
  constexpr void cylinder(const Pose& pose, float radius, float length, std::uint32_t colour) {
    add_posed(Shape::cylinder, pose, colour, radius, length, 0.0F);
  }
  constexpr void segment(Point3 a, Point3 b, Ink ink) {
    add(Shape::segment, ink, {a.x, a.y, a.z, b.x, b.y, b.z});
  }
  constexpr void facet(const Point3 (&p)[4], std::uint32_t colour) {
    add(Shape::facet, fill(colour),
        {p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z, p[2].x, p[2].y, p[2].z, p[3].x, p[3].y,
         p[3].z});
  }

 private:
  static constexpr std::size_t kOwn = 12;  // columns of the shape itself
  struct Numbers {
    float n[kOwn];
  };

  constexpr void add(Shape shape, const Ink& ink, const Numbers& numbers) {
    if (rows_ == kSceneRows<Message>) return;
    const std::size_t row = rows_++ * kSceneColumns;
    message_[row] = static_cast<float>(static_cast<int>(shape) + frame_);
    message_[row + 1] = static_cast<float>(ink.colour);
    message_[row + 2] = ink.opacity;
    message_[row + 3] = ink.width;
    for (std::size_t i = 0; i < kOwn; ++i) message_[row + 4 + i] = numbers.n[i];
  }
  template <std::size_t N>
  constexpr void add_points(Shape shape, const Point2 (&p)[N], Ink ink) {
    static_assert(N >= 2 && N <= kOwn / 2, "two to six points");
    Numbers numbers{};
    for (std::size_t i = 0; i < kOwn / 2; ++i) {
      const Point2& point = p[i < N ? i : N - 1];
      numbers.n[2 * i] = point.x;
      numbers.n[2 * i + 1] = point.y;
    }
    add(shape, ink, numbers);
  }
  constexpr void add_posed(Shape shape, const Pose& p, std::uint32_t colour, float a, float b,
                           float c) {
    add(shape, fill(colour), {p.at.x, p.at.y, p.at.z, p.w, p.x, p.y, p.z, a, b, c});
  }
  constexpr void write(Point2 at, float height, std::string_view text, float value, float decimals,
                       std::uint32_t colour, Align align) {
    Numbers numbers{at.x, at.y, height, value, decimals, static_cast<float>(align)};
    for (std::size_t i = 0; i < kSceneCharacters / 3; ++i)
      numbers.n[6 + i] = pack_characters(text, 3 * i);
    add(Shape::text, fill(colour), numbers);
  }

  Message& message_;
  std::size_t rows_ = 0;
  int frame_ = 0;
};

/// One row of a scene, read.
struct SceneRow {
  Shape shape = Shape::none;
  bool on_screen = false;
  Ink ink{};
  const float* n = nullptr;  // [12], the shape's own numbers

  /// Reads 16 numbers. For any numbers, the result is a shape that can be drawn, or none.
  static constexpr SceneRow read(const float* row) {
    SceneRow result;
    result.n = row + 4;
    const int kind = whole(row[0], kOnScreen + static_cast<int>(Shape::facet));
    const int shape = kind & (kOnScreen - 1);
    if (shape > static_cast<int>(Shape::facet)) return result;
    result.shape = static_cast<Shape>(shape);
    result.on_screen = kind >= kOnScreen;
    result.ink.colour = static_cast<std::uint32_t>(whole(row[1], 0xffffff));
    result.ink.opacity = row[2] > 0.0F ? (row[2] < 1.0F ? row[2] : 1.0F) : 0.0F;
    result.ink.width = row[3];
    return result;
  }
  constexpr Pose pose() const { return {{n[0], n[1], n[2]}, n[3], n[4], n[5], n[6]}; }
  /// Character `i` of a text, 0 behind its end.
  constexpr unsigned char character(std::size_t i) const {
    const auto packed = static_cast<std::uint32_t>(whole(n[6 + i / 3], 0xffffff));
    return static_cast<unsigned char>(packed >> (16U - 8U * static_cast<unsigned>(i % 3)) & 0xffU);
  }

 private:
  /// 0 for anything but a number from 0 to `high`.
  static constexpr int whole(float value, int high) {
    return value >= 0.0F && value <= static_cast<float>(high) ? static_cast<int>(value) : 0;
  }
};

}  // namespace eagerx
