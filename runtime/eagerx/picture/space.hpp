// Shapes in space, seen by a camera and painted from the farthest to the nearest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <eagerx/math.hpp>
#include <eagerx/picture/brush.hpp>
#include <eagerx/scene.hpp>

namespace eagerx::picture {

constexpr Point3 operator+(Point3 a, Point3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Point3 operator-(Point3 a, Point3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Point3 operator*(float s, Point3 a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr float dot(Point3 a, Point3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Point3 unit(Point3 a) {
  const float length = eagerx::sqrt(dot(a, a));
  return length > 0.0F ? (1.0F / length) * a : Point3{0.0F, 0.0F, 1.0F};
}
/// The direction of a pose's own `p`.
constexpr Point3 turned(const Pose& q, Point3 p) {
  const Point3 v{q.x, q.y, q.z};
  const Point3 t = 2.0F * cross(v, p);
  return p + q.w * t + cross(v, t);
}
constexpr Point3 placed(const Pose& q, Point3 p) {
  return q.at + turned(q, p);
}

/// Projects points in space onto the picture.
class Camera {
 public:
  Camera() = default;
  /// The first six numbers and the angle of a row `camera`.
  Camera(const float* n, const Image& image) : eye_{n[0], n[1], n[2]} {
    forward_ = unit(Point3{n[3], n[4], n[5]} - eye_);
    const bool steep = eagerx::abs(forward_.z) > 0.999F;
    right_ = unit(cross(forward_, steep ? Point3{0.0F, 1.0F, 0.0F} : Point3{0.0F, 0.0F, 1.0F}));
    up_ = cross(right_, forward_);
    const float half = eagerx::min(eagerx::max(0.5F * n[6], 0.01F), 1.5F);
    focal_ = 0.5F * static_cast<float>(image.height) * eagerx::cos(half) / eagerx::sin(half);
    middle_ = {0.5F * static_cast<float>(image.width), 0.5F * static_cast<float>(image.height)};
  }

  Point3 eye() const { return eye_; }
  float depth(Point3 p) const { return dot(p - eye_, forward_); }
  /// False for points behind the camera, or too close to it.
  bool see(Point3 p, Point2& at) const {
    const Point3 d = p - eye_;
    const float z = dot(d, forward_);
    if (!(z > kNearest)) return false;
    const float scale = focal_ / z;
    at = {middle_.x + scale * dot(d, right_), middle_.y - scale * dot(d, up_)};
    return at.x > -kFar && at.x < kFar && at.y > -kFar && at.y < kFar;
  }
  /// Pixels of a length at a point.
  float size(Point3 p, float length) const {
    return length * focal_ / eagerx::max(depth(p), kNearest);
  }

 private:
  static constexpr float kNearest = 0.01F;  // m
  static constexpr float kFar = 1e7F;       // pixels
  Point3 eye_{}, forward_{}, right_{}, up_{};
  float focal_ = 0.0F;
  Point2 middle_{};
};

inline constexpr Point3 kToLight{0.36F, -0.48F, 0.8F};
/// Brightness of a surface with this normal.
constexpr float light_on(Point3 normal) {
  const float towards = dot(normal, kToLight);
  return 0.62F + 0.38F * (towards > 0.0F ? towards : 0.35F * towards);
}
constexpr Paint lit(std::uint32_t colour, float opacity, float light) {
  Paint paint = paint_of(colour, opacity);
  const float part = light > 0.0F ? (light < 1.0F ? light : 1.0F) : 0.0F;  // 0 for NaN
  const auto scale = static_cast<std::int32_t>(part * 256.0F);
  const auto by = [scale](std::uint8_t& c) {
    const std::int32_t value = c * scale / 256;
    c = static_cast<std::uint8_t>(value > 255 ? 255 : value);
  };
  by(paint.red), by(paint.green), by(paint.blue);
  return paint;
}

/// Paints one shape of space.
template <class BrushType>
class SpacePainter {
 public:
  SpacePainter(BrushType& brush, const Camera& camera) : brush_(brush), camera_(camera) {}

  /// The middle of a shape.
  static Point3 middle(const SceneRow& row) {
    if (row.shape == Shape::segment)
      return 0.5F * (Point3{row.n[0], row.n[1], row.n[2]} + Point3{row.n[3], row.n[4], row.n[5]});
    if (row.shape == Shape::facet) {
      Point3 sum = facet_corner(row, 3);
      for (int i = 0; i < 3; ++i) sum = sum + facet_corner(row, i);
      return 0.25F * sum;
    }
    return {row.n[0], row.n[1], row.n[2]};
  }

  void paint(const SceneRow& row) {
    switch (row.shape) {
      case Shape::plane:
        return paint_plane(row);
      case Shape::box:
        return paint_box(row);
      case Shape::sphere:
        return paint_round(row, middle(row), middle(row), row.n[3]);
      case Shape::capsule: {
        const Point3 half = 0.5F * row.n[8] * turned(row.pose(), {0.0F, 0.0F, 1.0F});
        return paint_round(row, row.pose().at - half, row.pose().at + half, row.n[7]);
      }
      case Shape::cylinder:
        return paint_cylinder(row);
      case Shape::segment:
        return paint_segment(row);
      case Shape::facet:
        return paint_facet(row);
      default:
        return;
    }
  }

  /// Adds the shadow of a shape on the level `z` to the brush.
  void add_shadow(const SceneRow& row, float z) {
    std::array<Point2, kMostPoints> p{};
    std::size_t count = 0;
    const auto add = [&](Point3 point) {
      const float along = (point.z - z) / kToLight.z;
      Point2 at;
      const Point3 on{point.x - along * kToLight.x, point.y - along * kToLight.y, z};
      if (along > -0.01F && camera_.see(on, at)) p[count++] = at;
    };
    if (row.shape == Shape::box) {
      for (int i = 0; i < 8; ++i) add(corner(row, i));
    } else if (row.shape == Shape::facet) {
      for (int i = 0; i < 4; ++i) add(facet_corner(row, i));
    } else if (row.shape != Shape::segment && row.shape != Shape::plane) {
      const bool ball = row.shape == Shape::sphere;
      const float radius = ball ? row.n[3] : row.n[7];
      const Point3 half =
          ball ? Point3{} : 0.5F * row.n[8] * turned(row.pose(), {0.0F, 0.0F, 1.0F});
      for (int k = 0; k < kTurn; k += 8) {
        const Point2 c = on_circle(k);
        const Point3 rim{radius * c.x, radius * c.y, 0.0F};
        add(middle(row) + half + rim);
        if (!ball) add(middle(row) - half + rim);
      }
    }
    count = hull(p, count);
    if (count > 2) brush_.add_convex(p.data(), count);
  }

 private:
  static constexpr std::size_t kMostPoints = 40;
  using Points = std::array<Point2, kMostPoints>;

  static Point3 corner(const SceneRow& row, int i) {
    const float x = (i & 1) != 0 ? 0.5F : -0.5F, y = (i & 2) != 0 ? 0.5F : -0.5F;
    const float z = (i & 4) != 0 ? 0.5F : -0.5F;
    return placed(row.pose(), {x * row.n[7], y * row.n[8], z * row.n[9]});
  }

  static Point3 facet_corner(const SceneRow& row, int i) {
    return {row.n[3 * i], row.n[3 * i + 1], row.n[3 * i + 2]};
  }

  /// The convex hull of p, in its place (Andrew's monotone chain).
  static std::size_t hull(Points& p, std::size_t count) {
    if (count < 3) return count;
    for (std::size_t i = 1; i < count; ++i) {
      const Point2 point = p[i];
      std::size_t place = i;
      for (; place > 0 &&
             (p[place - 1].x > point.x || (p[place - 1].x == point.x && p[place - 1].y > point.y));
           --place)
        p[place] = p[place - 1];
      p[place] = point;
    }
    std::array<Point2, 2 * kMostPoints> h{};
    std::size_t size = 0;
    const auto add = [&](Point2 point, std::size_t least) {
      while (size >= least && (h[size - 1].x - h[size - 2].x) * (point.y - h[size - 2].y) -
                                      (h[size - 1].y - h[size - 2].y) * (point.x - h[size - 2].x) <=
                                  0.0F)
        --size;
      h[size++] = point;
    };
    for (std::size_t i = 0; i < count; ++i) add(p[i], 2);
    const std::size_t least = size + 1;
    for (std::size_t i = count - 1; i-- > 0;) add(p[i], least);
    --size;
    for (std::size_t i = 0; i < size; ++i) p[i] = h[i];
    return size;
  }

  /// Paints a flat, convex face, if all of it is in front of the camera.
  void paint_face(const Point3* corners, std::size_t count, const Paint& paint) {
    Points p{};
    for (std::size_t i = 0; i < count; ++i) {
      if (!camera_.see(corners[i], p[i])) return;
    }
    brush_.dip(paint);
    brush_.add_convex(p.data(), count);
    brush_.paint();
  }

  /// Paints the hull, behind the seams of faces.
  void paint_hull(const Point3* corners, std::size_t count, const Paint& paint) {
    Points p{};
    for (std::size_t i = 0; i < count; ++i) {
      if (!camera_.see(corners[i], p[i])) return;
    }
    const std::size_t size = hull(p, count);
    if (size < 3) return;
    brush_.dip(paint);
    brush_.add_convex(p.data(), size);
    brush_.paint();
  }

  void paint_plane(const SceneRow& row) {
    const Point3 at = middle(row);
    const float half = row.n[3];
    const float size = row.n[4] > 0.0F ? row.n[4] : 2.0F * half;
    const float fit = 2.0F * half / size;  // not a number without a size
    const int cells = fit > 1.0F ? static_cast<int>(eagerx::min(fit, 32.0F)) : 1;
    for (int i = 0; i < cells; ++i) {
      for (int k = 0; k < cells; ++k) {
        const float x = at.x - half + static_cast<float>(i) * size;
        const float y = at.y - half + static_cast<float>(k) * size;
        const Point3 p[] = {
            {x, y, at.z}, {x + size, y, at.z}, {x + size, y + size, at.z}, {x, y + size, at.z}};
        paint_face(p, 4, lit(row.ink.colour, row.ink.opacity, ((i + k) & 1) != 0 ? 1.0F : 0.94F));
      }
    }
  }

  void paint_box(const SceneRow& row) {
    Point3 p[8];
    for (int i = 0; i < 8; ++i) p[i] = corner(row, i);
    paint_hull(p, 8, lit(row.ink.colour, row.ink.opacity, 0.75F));
    static constexpr int kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                         {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
    for (int f = 0; f < 6; ++f) {
      const float sign = f % 2 == 0 ? 1.0F : -1.0F;
      const Point3 normal = turned(row.pose(), {f / 2 == 0 ? sign : 0.0F, f / 2 == 1 ? sign : 0.0F,
                                                f / 2 == 2 ? sign : 0.0F});
      const Point3 face[] = {p[kFaces[f][0]], p[kFaces[f][1]], p[kFaces[f][2]], p[kFaces[f][3]]};
      if (dot(normal, camera_.eye() - face[0]) <= 0.0F) continue;
      paint_face(face, 4, lit(row.ink.colour, row.ink.opacity, light_on(normal)));
    }
  }

  /// A sphere, or a capsule from a to b.
  void paint_round(const SceneRow& row, Point3 a, Point3 b, float radius) {
    Point2 pa, pb;
    if (!camera_.see(a, pa) || !camera_.see(b, pb)) return;
    const float ra = camera_.size(a, radius), rb = camera_.size(b, radius);
    brush_.dip(lit(row.ink.colour, row.ink.opacity, 0.66F));
    brush_.add_hull(pa, ra, pb, rb);
    brush_.paint();
    // Lighter towards the light, which is above and to the left.
    static constexpr float kParts[] = {0.86F, 0.66F, 0.42F};
    for (int i = 0; i < 3; ++i) {
      const float part = kParts[i], off = 0.32F * (1.0F - part);
      brush_.dip(lit(row.ink.colour, row.ink.opacity, 0.78F + 0.1F * static_cast<float>(i)));
      brush_.add_hull({pa.x - off * ra, pa.y - 1.6F * off * ra}, part * ra,
                      {pb.x - off * rb, pb.y - 1.6F * off * rb}, part * rb);
      brush_.paint();
    }
  }

  void paint_cylinder(const SceneRow& row) {
    constexpr int kSides = 16;
    const Pose pose = row.pose();
    const float radius = row.n[7], half = 0.5F * row.n[8];
    Point3 rim[2 * kSides];
    for (int k = 0; k < kSides; ++k) {
      const Point2 c = on_circle(k * (kTurn / kSides));
      rim[k] = placed(pose, {radius * c.x, radius * c.y, -half});
      rim[kSides + k] = placed(pose, {radius * c.x, radius * c.y, half});
    }
    paint_hull(rim, 2 * kSides, lit(row.ink.colour, row.ink.opacity, 0.75F));
    for (int k = 0; k < kSides; ++k) {
      const int next = (k + 1) % kSides;
      const Point2 c = on_circle(k * (kTurn / kSides) + kTurn / kSides / 2);
      const Point3 normal = turned(pose, {c.x, c.y, 0.0F});
      const Point3 face[] = {rim[k], rim[next], rim[kSides + next], rim[kSides + k]};
      if (dot(normal, camera_.eye() - face[0]) <= 0.0F) continue;
      paint_face(face, 4, lit(row.ink.colour, row.ink.opacity, light_on(normal)));
    }
    const Point3 axis = turned(pose, {0.0F, 0.0F, 1.0F});
    const bool top = dot(axis, camera_.eye() - rim[kSides]) > 0.0F;
    const bool bottom = dot(axis, camera_.eye() - rim[0]) < 0.0F;
    if (top) paint_face(rim + kSides, kSides, lit(row.ink.colour, row.ink.opacity, light_on(axis)));
    if (bottom)
      paint_face(rim, kSides, lit(row.ink.colour, row.ink.opacity, light_on(-1.0F * axis)));
  }

  /// Lit like the visible side. Facets that face away from the eye fill the seams of the others,
  /// and may cover them if the order of centers is wrong.
  void paint_facet(const SceneRow& row) {
    Point3 p[4];
    for (int i = 0; i < 4; ++i) p[i] = facet_corner(row, i);
    Point3 normal = unit(cross(p[1] - p[0], p[2] - p[0]));
    if (dot(normal, camera_.eye() - p[0]) < 0.0F) normal = -1.0F * normal;
    paint_face(p, 4, lit(row.ink.colour, row.ink.opacity, light_on(normal)));
  }

  void paint_segment(const SceneRow& row) {
    const Point3 a{row.n[0], row.n[1], row.n[2]}, b{row.n[3], row.n[4], row.n[5]};
    Point2 pa, pb;
    if (!camera_.see(a, pa) || !camera_.see(b, pb)) return;
    const bool points = row.ink.width < 0.0F;
    const float one = -row.ink.width * static_cast<float>(brush_.image().height) / 480.0F;
    brush_.dip(paint_of(row.ink.colour, row.ink.opacity));
    brush_.add_hull(pa, 0.5F * (points ? one : camera_.size(a, row.ink.width)), pb,
                    0.5F * (points ? one : camera_.size(b, row.ink.width)));
    brush_.paint();
  }

  BrushType& brush_;
  const Camera& camera_;
};

}  // namespace eagerx::picture
