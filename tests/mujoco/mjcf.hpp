// The description of an object (scene.hpp) as MuJoCo's XML, with all digits.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <models/engines/open_dynamics_engine/scene.hpp>
#include <string>

namespace eagerx::mujoco {

using models::Quaternion;
using models::Vector3;

inline std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}
template <class Values>
std::string numbers(const Values& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? " " : "") + number(values[i]);
  return text;
}
inline std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "='" + value + "'";
}

/// Principal inertias and the axes that have them, by Jacobi's rotations: MuJoCo's own are good to
/// 1e-8 only.
struct PrincipalInertia {
  Vector3 inertia{};
  Quaternion axes = models::kNoRotation;

  explicit PrincipalInertia(const models::RigidBody& body) {
    const Vector3 &i = body.inertia, &p = body.products;
    double a[3][3] = {{i[0], p[0], p[1]}, {p[0], i[1], p[2]}, {p[1], p[2], i[2]}};
    for (int sweep = 0; sweep < 60; ++sweep) {
      for (std::size_t k = 0; k < 3; ++k) rotate_away(a, k, (k + 1) % 3);
    }
    inertia = {{a[0][0], a[1][1], a[2][2]}};
  }

 private:
  /// A rotation about the third axis that makes a[r][c] zero, by an eighth of a turn at most:
  /// larger ones swap axes again and again.
  void rotate_away(double (&a)[3][3], std::size_t r, std::size_t c) {
    if (std::abs(a[r][c]) < 1e-300) return;
    const double angle = 0.5 * std::atan(2.0 * a[r][c] / (a[r][r] - a[c][c]));
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto turn = [&](double& x, double& y) {
      const double old = x;
      x = cosine * old + sine * y;
      y = cosine * y - sine * old;
    };
    for (auto& row : a) turn(row[r], row[c]);
    for (std::size_t k = 0; k < 3; ++k) turn(a[r][k], a[c][k]);
    Vector3 axis{};
    axis[3 - r - c] = 1.0;
    axes = models::normalised(models::product(axes, models::rotation(axis, angle)));
  }
};

/// Settings that the description does not contain.
struct MjcfSettings {
  double step_s = 0.002;
  std::string options;  // further attributes of <option>
};

/// Bodies as links of MuJoCo's tree: each has its frame in its center of mass and, in the reference
/// pose, the axes of the object's frame. Joints have the description's names. Shapes touch the
/// plane and not each other. Actuators and servos are the caller's.
template <class Model>
class Mjcf {
 public:
  static std::string text(const MjcfSettings& settings) {
    return "<mujoco><compiler angle='radian' inertiafromgeom='false'/><option" +
           attribute("timestep", number(settings.step_s)) + " " + settings.options +
           "/><worldbody>" + geometries("") + children("", {}) + "</worldbody></mujoco>";
  }

 private:
  static_assert(!models::scene::has_mimics<Model>(), "Mjcf: no joint mimics another one");

  static const models::RigidJoint* joint_of(const models::RigidBody& body) {
    for (const auto& joint : Model::kJoints) {
      if (std::string(joint.child) == body.name) return &joint;
    }
    return nullptr;
  }
  /// `place`: of the parent's center of mass.
  static std::string children(const std::string& parent, const Vector3& place) {
    using models::operator-;
    std::string text;
    for (const auto& body : Model::kBodies) {
      const models::RigidJoint* const joint = joint_of(body);
      if ((joint == nullptr ? "" : joint->parent) != parent) continue;
      text += "<body" + attribute("name", body.name) +
              attribute("pos", numbers(body.position - place)) + ">" + inertia(body) +
              (joint == nullptr ? "<freejoint/>" : motion(*joint, body)) + geometries(body.name) +
              children(body.name, body.position) + "</body>";
    }
    return text;
  }
  static std::string inertia(const models::RigidBody& body) {
    const PrincipalInertia principal(body);
    return "<inertial pos='0 0 0'" + attribute("mass", number(body.mass)) +
           attribute("diaginertia", numbers(principal.inertia)) +
           attribute("quat", numbers(principal.axes)) + "/>";
  }
  static std::string motion(const models::RigidJoint& joint, const models::RigidBody& child) {
    using models::operator-;
    if (joint.kind == models::JointKind::fixed) return "";
    std::string text =
        "<joint" + attribute("name", joint.name) +
        attribute("type", joint.kind == models::JointKind::slider ? "slide" : "hinge") +
        attribute("pos", numbers(joint.anchor - child.position)) +
        attribute("axis", numbers(joint.axis)) + attribute("armature", number(joint.armature)) +
        attribute("damping", number(joint.damping)) +
        attribute("frictionloss", number(joint.friction));
    if (std::isfinite(joint.low) && std::isfinite(joint.high))
      text += " limited='true'" + attribute("range", number(joint.low) + " " + number(joint.high));
    return text + "/>";
  }
  /// Of a body, or of the world.
  static std::string geometries(const std::string& body) {
    std::string text;
    for (const auto& geometry : Model::kGeometries) {
      if (geometry.body != body) continue;
      const bool is_plane = geometry.kind == models::ShapeKind::plane;
      text += "<geom" + attribute("name", geometry.name) +
              attribute("friction", number(geometry.friction)) +
              attribute("contype", is_plane ? "1" : "0") +
              attribute("conaffinity", is_plane || body.empty() ? "0" : "1") +
              attribute("pos", numbers(geometry.position)) + shape(geometry) + "/>";
    }
    return text;
  }
  static std::string shape(const models::RigidGeometry& geometry) {
    const Vector3& s = geometry.size;
    const auto form = [&](const char* type, const Vector3& size) {
      return attribute("type", type) + attribute("size", numbers(size)) +
             attribute("quat", numbers(geometry.rotation));
    };
    switch (geometry.kind) {
      case models::ShapeKind::sphere:
        return form("sphere", s);
      case models::ShapeKind::box:
        return form("box", {{0.5 * s[0], 0.5 * s[1], 0.5 * s[2]}});
      case models::ShapeKind::capsule:
        return form("capsule", {{s[0], 0.5 * s[1], 0.0}});
      case models::ShapeKind::cylinder:
        return form("cylinder", {{s[0], 0.5 * s[1], 0.0}});
      case models::ShapeKind::plane:
        break;
    }
    return " type='plane' size='50 50 1'" + attribute("zaxis", numbers(geometry.axis));
  }
};

}  // namespace eagerx::mujoco
