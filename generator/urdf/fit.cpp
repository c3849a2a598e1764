// Simple shapes around meshes.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "generator/urdf/meshes.hpp"

namespace eagerx::urdf {
namespace {

using models::ShapeKind;
constexpr double kThinnest = 1e-4;  // of a shape around a flat mesh [m]
constexpr double kPi = std::numbers::pi;

double length(const Vector3& v) {
  return std::sqrt(dot(v, v));
}

/// Three directions at right angles.
using Axes3 = std::array<Vector3, 3>;
constexpr Axes3 kFrameAxes = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};

/// Directions all over a sphere (a spiral of Fibonacci).
std::vector<Vector3> directions(std::size_t count) {
  std::vector<Vector3> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double turn = static_cast<double>(i) * kPi * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    result.push_back({{r * std::cos(turn), r * std::sin(turn), z}});
  }
  return result;
}
constexpr std::size_t kDirections = 1'000;

/// How far points reach in a direction.
double reach(const std::vector<Vector3>& points, const Vector3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3& p : points) most = std::max(most, dot(p, direction));
  return most;
}

/// Those that are the outermost in some direction: for searches, which a last pass over all points
/// completes.
std::vector<Vector3> outermost(const std::vector<Vector3>& points) {
  constexpr std::size_t kFew = 300;
  if (points.size() <= kFew) return points;
  std::vector<Vector3> result;
  for (const Vector3& direction : directions(kFew))
    result.push_back(
        *std::ranges::max_element(points, {}, [&](const Vector3& p) { return dot(p, direction); }));
  return result;
}

/// The centre of the smallest ball around points, nearly (Badoiu and Clarkson 2003).
Vector3 centre_of_ball(const std::vector<Vector3>& points) {
  Vector3 centre = points[0];
  for (int i = 1; i <= 400; ++i) {
    const Vector3 farthest = *std::ranges::max_element(
        points, {}, [&](const Vector3& p) { return dot(p - centre, p - centre); });
    centre = centre + (1.0 / (i + 1.0)) * (farthest - centre);
  }
  return centre;
}
double radius_around(const Vector3& centre, const std::vector<Vector3>& points) {
  double most = 0.0;
  for (const Vector3& p : points) most = std::max(most, length(p - centre));
  return std::max(most, kThinnest);
}

/// The principal axes of the surface, by Jacobi's rotations. It counts by its area: corners would
/// say how a side is divided into triangles.
Axes3 principal_axes(const Triangles& triangles) {
  Vector3 mean{};
  double area = 0.0;
  const auto each = [&triangles](auto&& use) {
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      const Vector3* const p = &triangles[t];
      use(p, length(models::cross(p[1] - p[0], p[2] - p[0])));
    }
  };
  each([&](const Vector3* p, double weight) {
    mean = mean + (weight / 3.0) * (p[0] + p[1] + p[2]);
    area += weight;
  });
  if (area > 0.0) mean = (1.0 / area) * mean;
  double a[3][3] = {};
  each([&](const Vector3* p, double weight) {
    const Vector3 corners[4] = {p[0] - mean, p[1] - mean, p[2] - mean,
                                p[0] + p[1] + p[2] - 3.0 * mean};
    for (const Vector3& d : corners) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) a[i][j] += weight * d[i] * d[j];
      }
    }
  });
  double v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr std::size_t kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (const auto& [p, q] : kPairs) {
      if (a[p][q] == 0.0) continue;
      const double theta = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
      const double c = std::cos(theta), s = std::sin(theta);
      for (auto& row : a) {
        const double x = row[p], y = row[q];
        row[p] = c * x - s * y, row[q] = s * x + c * y;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = a[p][k], y = a[q][k];
        a[p][k] = c * x - s * y, a[q][k] = s * x + c * y;
        const double m = v[k][p], n = v[k][q];
        v[k][p] = c * m - s * n, v[k][q] = s * m + c * n;
      }
    }
  }
  Axes3 axes;
  for (std::size_t i = 0; i < 3; ++i) axes[i] = {{v[0][i], v[1][i], v[2][i]}};
  axes[2] = models::cross(axes[0], axes[1]);  // right-handed
  return axes;
}

/// The rotation from the frame's axes to these.
Quaternion rotation_to(const Axes3& axes) {
  // The largest of the four squares, so that nothing is divided by what is nearly 0.
  const double xx = axes[0][0], yy = axes[1][1], zz = axes[2][2];
  const double squares[4] = {1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz,
                             1 - xx - yy + zz};
  const auto most = static_cast<std::size_t>(std::max_element(squares, squares + 4) - squares);
  const double x = axes[1][2] - axes[2][1], y = axes[2][0] - axes[0][2],
               z = axes[0][1] - axes[1][0];
  const double xy = axes[0][1] + axes[1][0], xz = axes[0][2] + axes[2][0];
  const double yz = axes[1][2] + axes[2][1];
  const Quaternion rows[4] = {{{squares[0], x, y, z}},
                              {{x, squares[1], xy, xz}},
                              {{y, xy, squares[2], yz}},
                              {{z, xz, yz, squares[3]}}};
  return models::normalised(rows[most]);
}

/// The points as seen along three axes.
std::vector<Vector3> along(const Axes3& axes, const std::vector<Vector3>& points) {
  std::vector<Vector3> result;
  for (const Vector3& p : points)
    result.push_back({{dot(p, axes[0]), dot(p, axes[1]), dot(p, axes[2])}});
  return result;
}
Vector3 back(const Axes3& axes, const Vector3& p) {
  return p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
}

Fitted box_along(const Axes3& axes, const std::vector<Vector3>& points) {
  Vector3 low, high;
  for (std::size_t i = 0; i < 3; ++i) {
    high[i] = reach(points, axes[i]);
    low[i] = -reach(points, -1.0 * axes[i]);
  }
  Fitted box{ShapeKind::box, high - low, {back(axes, 0.5 * (high + low)), rotation_to(axes)}};
  for (double& side : box.size) side = std::max(side, kThinnest);
  return box;
}

Fitted ball(const std::vector<Vector3>& points) {
  const Vector3 centre = centre_of_ball(outermost(points));
  return {
      ShapeKind::sphere, {{radius_around(centre, points), 0, 0}}, {centre, models::kNoRotation}};
}

/// Cylinder and capsule along the third axis.
std::array<Fitted, 2> round_along(const Axes3& axes, const std::vector<Vector3>& points) {
  std::vector<Vector3> seen = along(axes, points), flat = seen;
  for (Vector3& p : flat) p[2] = 0.0;
  const Vector3 centre = centre_of_ball(outermost(flat));
  const double radius = radius_around(centre, flat);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double low = kFar, high = -kFar, first = kFar, last = -kFar;  // of cylinder; of capsule
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double z = seen[i][2], d = length(flat[i] - centre);
    const double half = std::sqrt(std::max(0.0, radius * radius - d * d));
    low = std::min(low, z), high = std::max(high, z);
    first = std::min(first, z + half), last = std::max(last, z - half);
  }
  const auto place = [&](double z) {
    return Frame{back(axes, {{centre[0], centre[1], z}}), rotation_to(axes)};
  };
  return {{{ShapeKind::cylinder,
            {{radius, std::max(high - low, kThinnest), 0}},
            place(0.5 * (low + high))},
           {ShapeKind::capsule,
            {{radius, std::max(last - first, kThinnest), 0}},
            place(0.5 * (first + last))}}};
}

double volume(const Fitted& shape) {
  const double r = shape.size[0];
  switch (shape.kind) {
    case ShapeKind::sphere:
      return 4.0 / 3.0 * kPi * r * r * r;
    case ShapeKind::cylinder:
      return kPi * r * r * shape.size[1];
    case ShapeKind::capsule:
      return kPi * r * r * (shape.size[1] + 4.0 / 3.0 * r);
    case ShapeKind::box:
    case ShapeKind::plane:
      break;
  }
  return shape.size[0] * shape.size[1] * shape.size[2];
}
/// Clearly smaller: of two that are nearly equal the first one stays.
bool is_smaller(const Fitted& a, const Fitted& b) {
  return volume(a) < 0.999 * volume(b);
}

double reach(const Fitted& shape, const Vector3& direction) {
  const Vector3 d = rotate(models::inverse(shape.origin.rotation), direction);
  const double at = dot(shape.origin.position, direction), r = shape.size[0];
  switch (shape.kind) {
    case ShapeKind::sphere:
      return at + r;
    case ShapeKind::cylinder:
      return at + r * std::sqrt(d[0] * d[0] + d[1] * d[1]) + 0.5 * shape.size[1] * std::abs(d[2]);
    case ShapeKind::capsule:
      return at + r + 0.5 * shape.size[1] * std::abs(d[2]);
    case ShapeKind::box:
    case ShapeKind::plane:
      break;
  }
  return at + 0.5 * (shape.size[0] * std::abs(d[0]) + shape.size[1] * std::abs(d[1]) +
                     shape.size[2] * std::abs(d[2]));
}

/// Triangles in parts that are small relative to the mesh, so that a sphere can be around few of
/// them.
Triangles subdivided(Triangles triangles) {
  constexpr std::size_t kMost = 60'000;  // corners
  Vector3 size;
  for (std::size_t i = 0; i < 3; ++i)
    size[i] = reach(triangles, kFrameAxes[i]) + reach(triangles, -1.0 * kFrameAxes[i]);
  const double longest = length(size) / 32.0;
  for (std::size_t t = 0; t < triangles.size() && triangles.size() < kMost;) {
    std::size_t side = 0;
    const auto edge = [&](std::size_t i) {
      return length(triangles[t + i] - triangles[t + (i + 1) % 3]);
    };
    for (std::size_t i = 1; i < 3; ++i) side = edge(i) > edge(side) ? i : side;
    if (edge(side) <= longest) {
      t += 3;
      continue;
    }
    const std::size_t end = (side + 1) % 3, rest = (side + 2) % 3;
    const Vector3 middle = 0.5 * (triangles[t + side] + triangles[t + end]);
    const Vector3 other[3] = {middle, triangles[t + end], triangles[t + rest]};
    triangles[t + end] = middle;
    triangles.insert(triangles.end(), other, other + 3);
  }
  return triangles;
}

/// Both halves of triangles along their longest extent.
std::array<Triangles, 2> halves(const Triangles& triangles) {
  std::size_t axis = 0;
  Vector3 extent;
  for (std::size_t i = 0; i < 3; ++i) {
    extent[i] = reach(triangles, kFrameAxes[i]) + reach(triangles, -1.0 * kFrameAxes[i]);
    if (extent[i] > extent[axis]) axis = i;
  }
  const double middle = reach(triangles, kFrameAxes[axis]) - 0.5 * extent[axis];
  std::array<Triangles, 2> result;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const double at = triangles[t][axis] + triangles[t + 1][axis] + triangles[t + 2][axis];
    Triangles& half = result[at < 3.0 * middle ? 0 : 1];
    half.insert(half.end(), triangles.begin() + static_cast<std::ptrdiff_t>(t),
                triangles.begin() + static_cast<std::ptrdiff_t>(t + 3));
  }
  return result;
}

}  // namespace

Fitted smallest_box(const Triangles& triangles) {
  const std::vector<Vector3> points = outermost(triangles);
  Axes3 axes = principal_axes(triangles);
  if (is_smaller(box_along(kFrameAxes, points), box_along(axes, points))) axes = kFrameAxes;
  // Turned a little about each axis while that makes it smaller.
  double best = volume(box_along(axes, points));
  for (double turn = 0.2; turn > 1e-4; turn *= 0.5) {
    for (std::size_t i = 0; i < 6; ++i) {
      const Quaternion by = models::rotation(axes[i % 3], i < 3 ? turn : -turn);
      const Axes3 other = {rotate(by, axes[0]), rotate(by, axes[1]), rotate(by, axes[2])};
      const double size = volume(box_along(other, points));
      if (size < 0.9999 * best) best = size, axes = other;
    }
  }
  const Fitted straight = box_along(kFrameAxes, triangles), turned = box_along(axes, triangles);
  return is_smaller(turned, straight) ? turned : straight;
}

Fitted smallest_shape(const Triangles& triangles) {
  Fitted best = smallest_box(triangles);
  const auto offer = [&best](const Fitted& other) {
    if (is_smaller(other, best)) best = other;
  };
  for (const Axes3& axes : {kFrameAxes, principal_axes(triangles)}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Axes3 turned = {axes[(i + 1) % 3], axes[(i + 2) % 3], axes[i]};
      for (const Fitted& shape : round_along(turned, triangles)) offer(shape);
    }
  }
  offer(ball(triangles));
  return best;
}

double reach_beyond(const std::vector<Fitted>& shapes, const Triangles& triangles) {
  const std::vector<Vector3> points = outermost(triangles);
  double most = 0.0;
  std::vector<Vector3> where = directions(kDirections);
  for (const Axes3& axes : {kFrameAxes, principal_axes(triangles)}) {
    for (const Vector3& axis : axes) where.insert(where.end(), {axis, -1.0 * axis});
  }
  for (const Vector3& direction : where) {
    const double mesh = reach(points, direction);
    for (const Fitted& shape : shapes) most = std::max(most, reach(shape, direction) - mesh);
  }
  return most;
}

std::vector<Fitted> enclosing_spheres(const Triangles& triangles, double distance,
                                      std::size_t most) {
  std::vector<Triangles> parts = {subdivided(triangles)};
  std::vector<Fitted> spheres = {ball(parts[0])};
  while (spheres.size() < most && reach_beyond(spheres, triangles) > distance) {
    const auto largest = static_cast<std::size_t>(
        std::ranges::max_element(spheres, {}, [](const Fitted& s) { return s.size[0]; }) -
        spheres.begin());
    auto [one, other] = halves(parts[largest]);
    if (one.empty() || other.empty()) break;
    spheres[largest] = ball(one);
    spheres.push_back(ball(other));
    parts[largest] = std::move(one);
    parts.push_back(std::move(other));
  }
  return spheres;
}

}  // namespace eagerx::urdf
