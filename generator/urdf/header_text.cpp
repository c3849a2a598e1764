#include <fmt/format.h>

#include <cmath>

#include "generator/backend/emit/literals.hpp"
#include "generator/support/quote/quote.hpp"
#include "generator/urdf/robot.hpp"

namespace eagerx::urdf {
namespace {

/// -0 is written as 0.
std::string literal(double value) {
  return gen::double_literal(value + 0.0);
}

std::string literal(const Vector3& v) {
  return fmt::format("{{{{{}, {}, {}}}}}", literal(v[0]), literal(v[1]), literal(v[2]));
}
std::string literal(const Quaternion& q) {
  return fmt::format("{{{{{}, {}, {}, {}}}}}", literal(q[0]), literal(q[1]), literal(q[2]),
                     literal(q[3]));
}

/// Members of one item, a line each.
class Item {
 public:
  void member(const char* name, const std::string& value) {
    text_ += fmt::format("{}.{} = {}", text_.empty() ? "{" : ",\n       ", name, value);
  }
  void name(const char* member, const std::string& value) {
    if (!value.empty()) this->member(member, gen::cpp_string(value));
  }
  void limit(const char* member, double value) {
    if (std::isfinite(value)) this->member(member, literal(value));
  }
  [[nodiscard]] std::string text() const { return "      " + text_ + "}"; }

 private:
  std::string text_;
};

std::string item(const Body& body) {
  Item result;
  result.name("name", body.name);
  result.member("mass", literal(body.mass));
  result.member("inertia", literal(body.inertia));
  result.member("position", literal(body.position));
  if (body.products != Vector3{}) result.member("products", literal(body.products));
  return result.text();
}

std::string item(const BodyJoint& joint) {
  Item result;
  result.name("name", joint.name);
  if (joint.slides) result.member("kind", "JointKind::slider");
  if (joint.is_fixed) result.member("kind", "JointKind::fixed");
  result.name("parent", joint.parent);
  result.name("child", joint.child);
  result.member("anchor", literal(joint.anchor));
  result.member("axis", literal(joint.axis));
  result.limit("low", joint.limits.lower);
  result.limit("high", joint.limits.upper);
  result.limit("max_torque", joint.limits.effort);
  if (joint.limits.damping > 0.0) result.member("damping", literal(joint.limits.damping));
  if (joint.limits.friction > 0.0) result.member("friction", literal(joint.limits.friction));
  if (joint.limits.stiffness > 0.0) {
    result.member("stiffness", literal(joint.limits.stiffness));
    if (joint.limits.rest != 0.0) result.member("rest", literal(joint.limits.rest));
  }
  if (joint.limits.armature > 0.0) result.member("armature", literal(joint.limits.armature));
  result.limit("max_velocity", joint.limits.velocity);
  if (!joint.mimics.empty()) {
    result.name("mimics", joint.mimics);
    result.member("ratio", literal(joint.ratio));
    if (joint.offset != 0.0) result.member("offset", literal(joint.offset));
  }
  return result.text();
}

const char* kind_text(models::ShapeKind kind) {
  switch (kind) {
    case models::ShapeKind::sphere:
      return "ShapeKind::sphere";
    case models::ShapeKind::box:
      return "ShapeKind::box";
    case models::ShapeKind::capsule:
      return "ShapeKind::capsule";
    case models::ShapeKind::cylinder:
      return "ShapeKind::cylinder";
    case models::ShapeKind::plane:
      break;
  }
  return "ShapeKind::plane";
}

std::string item(const Shape& shape) {
  Item result;
  result.name("name", shape.name);
  result.member("kind", kind_text(shape.kind));
  result.name("body", shape.body);
  const bool is_plane = shape.kind == models::ShapeKind::plane;
  if (!is_plane) result.member("size", literal(shape.size));
  result.member("position", literal(shape.position));
  if (is_plane) result.member("axis", literal(shape.normal));
  result.member("friction", shape.friction == 1.0
                                ? "Io::Config::friction"
                                : literal(shape.friction) + " * Io::Config::friction");
  result.member("bounce", "Io::Config::bounce");
  if (!is_plane && shape.rotation != models::kNoRotation)
    result.member("rotation", literal(shape.rotation));
  return result.text();
}

/// To 0.1 mm.
std::string item(const Facet& facet) {
  const auto point = [](const Vector3& p) {
    const auto rounded = [](double x) { return literal(std::round(1e4 * x) / 1e4); };
    return fmt::format("{{{{{}, {}, {}}}}}", rounded(p[0]), rounded(p[1]), rounded(p[2]));
  };
  return fmt::format("      {{{}, {{{{{}, {}, {}, {}}}}}}}", gen::cpp_string(facet.body),
                     point(facet.corners[0]), point(facet.corners[1]), point(facet.corners[2]),
                     point(facet.corners[2]));
}

/// The plane z = 0 of the world, wherever the robot is.
constexpr const char* kGround =
    "      {.name = \"ground_plane\", .kind = ShapeKind::plane, .position = -1.0 * kOrigin}";

template <class Items>
std::string list(const char* type, const char* name, const Items& items, const char* last = "") {
  std::string text;
  std::size_t count = 0;
  const auto add = [&](const std::string& one) { text += (count++ == 0 ? "\n" : ",\n") + one; };
  for (const auto& one : items) add(item(one));
  if (*last != '\0') add(last);
  if (count == 0)
    return fmt::format("  static constexpr std::array<{}, 0> {} = {{}};\n", type, name);
  return fmt::format("  static constexpr std::array<{}, {}> {} = {{{{{}}}}};\n", type, count, name,
                     text);
}

std::string pairs(const Robot& robot) {
  std::string text;
  for (const auto& [first, second] : robot.pairs)
    text += fmt::format("{}\n      {{{}, {}}}", text.empty() ? "" : ",", gen::cpp_string(first),
                        gen::cpp_string(second));
  return fmt::format(
      "  static constexpr std::array<std::array<const char*, 2>, {}> kPairs = {{{{{}}}}};\n",
      robot.pairs.size(), text);
}

}  // namespace

std::string header_text(const Robot& robot) {
  std::string text = fmt::format(
      R"(// A robot of rigid bodies, as {0} describes it.
// Made by eagerx-urdf. Do not edit: change the description and convert it again.
#pragma once

#include <array>
#include <models/engines/open_dynamics_engine/scene.hpp>

namespace eagerx::models {{

/// Positions are in the frame of the link `{1}`, which is at `origin` in the world.
template <class Io>
struct {2} {{
  using Real = typename Io::Real;
  static constexpr Vector3 kOrigin{{
      {{Io::Config::origin[0], Io::Config::origin[1], Io::Config::origin[2]}}}};
  static constexpr bool kTouchesItself = Io::Config::touches_itself;

)",
      gen::in_comment(robot.file), robot.base, robot.id);
  text += list("RigidBody", "kBodies", robot.bodies);
  text += list("RigidJoint", "kJoints", robot.joints);
  text += list("RigidGeometry", "kGeometries", robot.shapes, robot.ground ? kGround : "");
  if (!robot.facets.empty()) text += list("RigidFacet", "kFacets", robot.facets);
  if (!robot.pairs.empty()) text += pairs(robot);
  return text + "};\n\n}  // namespace eagerx::models\n";
}

}  // namespace eagerx::urdf
