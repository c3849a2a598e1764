#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <eagerx/scene.hpp>
#include <runtime/host/base/json.hpp>
#include <runtime/host/foxglove/scene_update.hpp>
#include <string_view>
#include <vector>

namespace eagerx::foxglove {
namespace {

constexpr float kPi = 3.14159265F;

/// JSON of the kinds of primitives, one after the other.
class Primitives {
 public:
  struct Turn {
    float x = 0.0F, y = 0.0F, z = 0.0F, w = 1.0F;
  };
  struct Line {
    int type = 0;  // LINE_STRIP, LINE_LOOP
    float width = 0.0F;
    bool is_pixels = false;
  };

  std::string arrows, cubes, spheres, cylinders, lines, triangles, texts;

  void cube(Point3 at, const Turn& turn, Point3 size, const Ink& ink) {
    begin(cubes, at, turn);
    cubes += ",\"size\":" + vector(size) + colour(ink) + "}";
  }
  void sphere(Point3 at, float radius, const Ink& ink) {
    const float size = 2 * radius;
    begin(spheres, at, {});
    spheres += ",\"size\":" + vector({size, size, size}) + colour(ink) + "}";
  }
  void cylinder(Point3 at, const Turn& turn, float radius, float length, const Ink& ink) {
    begin(cylinders, at, turn);
    cylinders += ",\"size\":" + vector({2 * radius, 2 * radius, length}) +
                 R"(,"bottom_scale":1,"top_scale":1)" + colour(ink) + "}";
  }
  void arrow(Point3 at, const Turn& turn, Point2 shaft, Point2 head, const Ink& ink) {
    begin(arrows, at, turn);
    arrows += ",\"shaft_length\":" + number(shaft.x) + ",\"shaft_diameter\":" + number(shaft.y) +
              ",\"head_length\":" + number(head.x) + ",\"head_diameter\":" + number(head.y) +
              colour(ink) + "}";
  }
  void line(const std::vector<Point3>& points, const Line& line, const Ink& ink) {
    begin(lines, {}, {});
    lines += ",\"type\":" + std::to_string(line.type) + ",\"thickness\":" + number(line.width) +
             ",\"scale_invariant\":" + (line.is_pixels ? "true" : "false") +
             ",\"points\":" + list(points) + colour(ink) + R"(,"colors":[],"indices":[]})";
  }
  void triangle_list(const std::vector<Point3>& points, const Ink& ink) {
    begin(triangles, {}, {});
    triangles += ",\"points\":" + list(points) + colour(ink) + R"(,"colors":[],"indices":[]})";
  }
  void text(Point3 at, float height, const std::string& text, const Ink& ink) {
    begin(texts, at, {});
    texts += R"(,"billboard":true,"font_size":)" + number(height) +
             R"(,"scale_invariant":false,"text":)";
    host::append_json_string(texts, text);
    texts += colour(ink) + "}";
  }

 private:
  /// A coordinate that is out of bounds after placing has no text in JSON.
  static std::string number(float value) {
    if (!std::isfinite(value)) return "0";
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  }
  static std::string vector(Point3 p) {
    return "{\"x\":" + number(p.x) + ",\"y\":" + number(p.y) + ",\"z\":" + number(p.z) + "}";
  }
  static std::string list(const std::vector<Point3>& points) {
    std::string text = "[";
    for (const Point3& each : points) text += (text.size() > 1 ? "," : "") + vector(each);
    return text + "]";
  }
  static std::string colour(const Ink& ink) {
    constexpr float kMost = 255.0F;
    const auto part = [&](unsigned shift) {
      return number(static_cast<float>(ink.colour >> shift & 0xffU) / kMost);
    };
    return ",\"color\":{\"r\":" + part(16) + ",\"g\":" + part(8) + ",\"b\":" + part(0) +
           ",\"a\":" + number(ink.opacity) + "}";
  }
  static void begin(std::string& to, Point3 at, const Turn& turn) {
    if (!to.empty()) to += ',';
    to += "{\"pose\":{\"position\":" + vector(at) + ",\"orientation\":{\"x\":" + number(turn.x) +
          ",\"y\":" + number(turn.y) + ",\"z\":" + number(turn.z) + ",\"w\":" + number(turn.w) +
          "}}";
  }
};

using Turn = Primitives::Turn;

/// About the axis that points at the one who looks.
Turn turned(float angle_rad) {
  return {0.0F, -std::sin(angle_rad / 2), 0.0F, std::cos(angle_rad / 2)};
}

/// A triangle each time: [3][…]; the shape may have corners that point inwards.
std::vector<Point2> triangles_of(std::vector<Point2> corners) {
  const auto cross = [](Point2 a, Point2 b, Point2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  float area = 0.0F;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    area += cross(corners[0], corners[i], corners[i + 1]);
  if (area < 0.0F) std::reverse(corners.begin(), corners.end());
  std::vector<Point2> result;
  while (corners.size() >= 3) {
    const std::size_t n = corners.size();
    std::size_t ear = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point2 a = corners[(i + n - 1) % n], b = corners[i], c = corners[(i + 1) % n];
      const bool is_free = std::none_of(corners.begin(), corners.end(), [&](Point2 p) {
        return cross(a, b, p) > 0 && cross(b, c, p) > 0 && cross(c, a, p) > 0;
      });
      if (cross(a, b, c) <= 0.0F || !is_free) continue;
      ear = i;
      break;
    }
    for (const std::size_t i : {ear + n - 1, ear, ear + 1}) result.push_back(corners[i % n]);
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return result;
}

class Drawing {
 public:
  void add(const SceneRow& row) {
    const float* const n = row.n;
    if (!std::all_of(n, n + 3, [](float x) { return std::isfinite(x); })) return;
    if (row.shape == Shape::view) {
      middle_ = {n[0], n[1]};
      height_ = n[2];
      return;
    }
    if (row.shape == Shape::text) return write(row);
    if (!std::all_of(n, n + 12, [](float x) { return std::isfinite(x); })) return;
    if (row.shape == Shape::camera) has_camera_ = true;
    on_screen_ = row.on_screen;
    if (on_screen_ && has_camera_) return;
    ++layer_;
    row.shape >= Shape::camera ? in_space(row) : in_plane(row);
  }
  Primitives done;

 private:
  Point3 at(Point2 p) const {
    if (on_screen_) p = {middle_.x + (p.x - 0.5F) * height_, middle_.y + (p.y - 0.5F) * height_};
    return {p.x, -static_cast<float>(layer_) * height_ * 2e-4F, p.y};
  }
  /// Lengths on the picture are in heights of it.
  float length(float x) const { return on_screen_ ? x * height_ : x; }

  /// A width that is neither in meters nor in points is one point.
  Primitives::Line line_of(const Ink& ink, int type = 0) const {
    if (ink.width > 0.0F) return {type, length(ink.width), false};
    return {type, ink.width < 0.0F ? -ink.width : 1.0F, true};
  }
  void outline(const std::vector<Point2>& points, const Ink& ink, int type) {
    std::vector<Point3> placed;
    placed.reserve(points.size());
    for (const Point2& each : points) placed.push_back(at(each));
    done.line(placed, line_of(ink, type), ink);
  }
  /// A polygon, filled or with an outline.
  void area(const std::vector<Point2>& corners, const Ink& ink) {
    if (ink.width != 0.0F) return outline(corners, ink, 1);
    std::vector<Point3> placed;
    for (const Point2& each : triangles_of(corners)) placed.push_back(at(each));
    if (!placed.empty()) done.triangle_list(placed, ink);
  }

  void in_plane(const SceneRow& row) {
    const float* const n = row.n;
    switch (row.shape) {
      case Shape::line:
        return outline({{n[0], n[1]}, {n[2], n[3]}}, row.ink, 0);
      case Shape::polyline:
        return outline(points_of(n), row.ink, 0);
      case Shape::polygon:
        return area(points_of(n), row.ink);
      case Shape::circle:
        return circle({n[0], n[1]}, n[2], row.ink);
      case Shape::rectangle:
        return rectangle(row);
      case Shape::arrow:
        return arrow(row);
      default:
        return;
    }
  }

  static std::vector<Point2> points_of(const float* n) {
    constexpr std::size_t kMost = 6;
    std::vector<Point2> points{{n[0], n[1]}};
    for (std::size_t i = 1; i < kMost; ++i)
      if (n[2 * i] != points.back().x || n[2 * i + 1] != points.back().y)
        points.push_back({n[2 * i], n[2 * i + 1]});
    return points;
  }

  void circle(Point2 middle, float radius, const Ink& ink) {
    constexpr std::size_t kCorners = 32;
    if (ink.width == 0.0F) {
      constexpr float kHalf = 0.70710678F;  // the axis of a cylinder is z; it is to look along y
      return done.cylinder(at(middle), {kHalf, 0.0F, 0.0F, kHalf}, length(radius), height_ * 1e-4F,
                           ink);
    }
    std::vector<Point2> points;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const float angle = 2 * kPi * static_cast<float>(i) / kCorners;
      points.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
    }
    outline(points, ink, 1);
  }

  void rectangle(const SceneRow& row) {
    const float* const n = row.n;
    const float x = n[2] / 2, y = n[3] / 2, c = std::cos(n[4]), s = std::sin(n[4]);
    if (row.ink.width == 0.0F)
      return done.cube(at({n[0], n[1]}), turned(n[4]),
                       {length(n[2]), height_ * 1e-4F, length(n[3])}, row.ink);
    std::vector<Point2> corners;
    for (const Point2 p : {Point2{x, y}, Point2{-x, y}, Point2{-x, -y}, Point2{x, -y}})
      corners.push_back({n[0] + p.x * c - p.y * s, n[1] + p.x * s + p.y * c});
    outline(corners, row.ink, 1);
  }

  void arrow(const SceneRow& row) {
    const float* const n = row.n;
    const Point2 to{n[2] - n[0], n[3] - n[1]};
    const float all = length(std::hypot(to.x, to.y)), head = std::min(length(n[4]), all);
    const float width =
        row.ink.width > 0.0F ? length(row.ink.width) : -row.ink.width * height_ / 480.0F;
    done.arrow(at({n[0], n[1]}), turned(std::atan2(to.y, to.x)), {all - head, width},
               {head, std::max(head, 2 * width)}, row.ink);
  }

  void write(const SceneRow& row) {
    on_screen_ = row.on_screen;
    if (on_screen_ && has_camera_) return;
    std::string text;
    for (std::size_t i = 0; i < kSceneCharacters && row.character(i) != 0; ++i) {
      const auto c = static_cast<char>(row.character(i));
      if (c == '#' && row.n[4] >= 0.0F) {
        std::array<char, 64> number{};
        const int decimals = static_cast<int>(std::min(row.n[4], 6.0F));
        text.append(number.data(), std::to_chars(number.data(), number.data() + number.size(),
                                                 row.n[3], std::chars_format::fixed, decimals)
                                       .ptr);
      } else if (c >= ' ' && c <= '~') {
        text += c;
      }
    }
    ++layer_;
    // Foxglove has the middle of a text at its place, and letters about half as wide as high.
    const float half = 0.25F * row.n[2] * static_cast<float>(text.size());
    const float shift = row.n[5] == 0.0F ? half : row.n[5] == 2.0F ? -half : 0.0F;
    if (!text.empty()) done.text(at({row.n[0] + shift, row.n[1]}), length(row.n[2]), text, row.ink);
  }

  void in_space(const SceneRow& row) {
    const float* const n = row.n;
    const Pose pose = row.pose();
    const Turn turn{pose.x, pose.y, pose.z, pose.w};
    switch (row.shape) {
      case Shape::plane:
        return done.cube({n[0], n[1], n[2]}, {}, {2 * n[3], 2 * n[3], 1e-3F}, row.ink);
      case Shape::box:
        return done.cube(pose.at, turn, {n[7], n[8], n[9]}, row.ink);
      case Shape::sphere:
        return done.sphere({n[0], n[1], n[2]}, n[3], row.ink);
      case Shape::cylinder:
        return done.cylinder(pose.at, turn, n[7], n[8], row.ink);
      case Shape::capsule:
        return capsule(pose, turn, row);
      case Shape::segment:
        return done.line({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}, line_of(row.ink), row.ink);
      default:
        return;
    }
  }

  void capsule(const Pose& p, const Turn& turn, const SceneRow& row) {
    const float radius = row.n[7], half = row.n[8] / 2;
    // The z of the body in the world.
    const Point3 z{2 * (p.x * p.z + p.w * p.y), 2 * (p.y * p.z - p.w * p.x),
                   1 - 2 * (p.x * p.x + p.y * p.y)};
    done.cylinder(p.at, turn, radius, 2 * half, row.ink);
    for (const float end : {-half, half})
      done.sphere({p.at.x + end * z.x, p.at.y + end * z.y, p.at.z + end * z.z}, radius, row.ink);
  }

  Point2 middle_{};
  float height_ = 1.0F;  // of what is seen
  int layer_ = 0;
  bool has_camera_ = false, on_screen_ = false;
};

}  // namespace

std::string scene_update(const float* scene, std::size_t rows, std::int64_t time_ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  Drawing drawing;
  for (std::size_t i = 0; i < rows; ++i) {
    const SceneRow row = SceneRow::read(scene + i * kSceneColumns);
    if (row.shape != Shape::none) drawing.add(row);
  }
  const Primitives& p = drawing.done;
  return R"({"deletions":[],"entities":[{"timestamp":{"sec":)" + std::to_string(time_ns / kSecond) +
         ",\"nsec\":" + std::to_string(time_ns % kSecond) +
         R"(},"frame_id":"world","id":"scene","lifetime":{"sec":0,"nsec":0},)"
         R"("frame_locked":false,"metadata":[],"arrows":[)" +
         p.arrows + "],\"cubes\":[" + p.cubes + "],\"spheres\":[" + p.spheres +
         "],\"cylinders\":[" + p.cylinders + "],\"lines\":[" + p.lines + "],\"triangles\":[" +
         p.triangles + "],\"texts\":[" + p.texts + R"(],"models":[]}]})";
}

}  // namespace eagerx::foxglove
