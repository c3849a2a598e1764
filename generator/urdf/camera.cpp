// From where a robot is drawn.
#include <algorithm>
#include <cmath>
#include <utility>

#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {
namespace {

/// Of a sphere around a shape [m].
double radius_of(const Shape& shape) {
  const Vector3& size = shape.size;
  switch (shape.kind) {
    case models::ShapeKind::box:
      return 0.5 * std::sqrt(dot(size, size));
    case models::ShapeKind::capsule:
    case models::ShapeKind::cylinder:
      return size[0] + 0.5 * size[1];
    default:
      return size[0];
  }
}

/// The corners of a box around everything that is drawn, in the initial position [m].
std::pair<Vector3, Vector3> extent(const Robot& robot) {
  Vector3 low{}, high{};
  bool is_first = true;
  const auto add = [&](const Vector3& middle, double radius) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = is_first ? middle[i] - radius : std::min(low[i], middle[i] - radius);
      high[i] = is_first ? middle[i] + radius : std::max(high[i], middle[i] + radius);
    }
    is_first = false;
  };
  const auto in_world = [&](const std::string& name, const Vector3& at) {
    const auto body = std::ranges::find(robot.bodies, name, &Body::name);
    return body != robot.bodies.end() ? body->position + at : at;
  };
  for (const Facet& facet : robot.facets) {
    for (const Vector3& corner : facet.corners) add(in_world(facet.body, corner), 0.0);
  }
  for (const Shape& shape : robot.shapes) {
    if (shape.kind != models::ShapeKind::plane)
      add(in_world(shape.body, shape.position), radius_of(shape));
  }
  for (const BodyJoint& joint : robot.joints) {
    if (joint.mimics.empty() && !joint.is_fixed) add(joint.anchor, 0.0);
  }
  for (const Body& body : robot.bodies) {
    if (!body.is_made) add(body.position, 0.0);
  }
  return {low, high};
}

}  // namespace

Camera camera_of(const Robot& robot) {
  const auto free = std::ranges::find_if(robot.bodies, &Body::is_free);
  const auto [low, high] = extent(robot);
  const Vector3 across = high - low;
  const double distance = std::max(0.2, 1.6 * std::sqrt(dot(across, across)));
  Camera camera;
  camera.target = 0.5 * (low + high);
  if (free != robot.bodies.end()) {
    camera.follow = free->name;
    camera.target = {{camera.target[0] - free->position[0], camera.target[1] - free->position[1],
                      camera.target[2]}};
  }
  camera.eye = camera.target + distance * Vector3{{0.6, -0.7, 0.4}};
  return camera;
}

}  // namespace eagerx::urdf
